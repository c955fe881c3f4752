#!/usr/bin/env python3
"""Stops a run of every scene of data/ halfway, goes on with it on another number of threads, and wants the same bits.

  restart.py MESOPIX DATA [--full] [--only NAME]

Without --full the scenes are loaded so fast that each takes a second or so.
"""
import argparse, sys, tempfile
from pathlib import Path

sys.dont_write_bytecode = True
from runs import checkpoints, digest, finished, frames, is_whole, simulate, stop, wait_for

small = ["--generate.width", "60 mm", "--generate.height", "60 mm"]
# What makes a scene short, by its name.
short = {
    "brazilian": ["--velocity", "20 m/s"],
    "compression_fragments": [*small, "--velocity", "50 m/s"],
    "concrete_compression": [*small, "--velocity", "1 m/s"],
    "concrete_tension": [*small, "--velocity", "0.2 m/s"],
    "disc_impact": ["--duration", "0.05 ms"],
    "two_aggregates": ["--velocity", "0.2 m/s"],
    "paper/compression": [*small, "--velocity", "2 m/s", "--set", "damage.crack_closure=clipped"],
    "paper/compression_closure": [*small, "--velocity", "8 m/s"],
    "paper/generation": [*small, "--velocity", "0.2 m/s"],
    "paper/objectivity": ["--velocity", "1 m/s"],
    "paper/tension": [*small, "--velocity", "0.2 m/s", "--precision", "single"],
    "paper/two_aggregates": ["--velocity", "0.2 m/s"],
}


def stopped_halfway(mesopix, arguments, run):
    """A run that was stopped when the frame of its half was there."""
    process = simulate(mesopix, *arguments, "--threads", 1, "-o", run)
    wait_for(run / "frames" / "p_000002.hdf", process)
    stop(process)
    said = finished(process, 75)
    assert f"to go on: mesopix simulate --resume {run}" in said, said


def check(mesopix, key, scene, options, folder):
    name = scene.stem
    arguments = [scene, "--frames", 4, *options]
    whole, run = folder / f"{name}_whole", folder / name
    finished(simulate(mesopix, *arguments, "--threads", 2, "-o", whole))
    stopped_halfway(mesopix, arguments, run)
    kept = checkpoints(run)
    assert len(kept) == 1 and is_whole(kept[0]), kept
    size = kept[0].stat().st_size / 1e6
    said = finished(simulate(mesopix, "--resume", run, "--threads", 3))
    share = said[said.index("goes on at ") + 11:said.index(" %, step")]
    different = {key: value for key, value in digest(whole).items() if digest(run).get(key) != value}
    assert not different, f"{name}: {', '.join(different)} differ"
    assert digest(run).keys() == digest(whole).keys()
    assert frames(run) == frames(whole), f"{name}: other frames"
    assert not (run / "checkpoints").exists()
    print(f"{key}: the same bits, stopped at {share} % with a checkpoint of {size:.1f} MB", flush=True)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("mesopix", type=Path)
    parser.add_argument("data", type=Path)
    parser.add_argument("--full", action="store_true")
    parser.add_argument("--only", default="")
    given = parser.parse_args()
    scenes = {str(path.relative_to(given.data).with_suffix("")): path for path in sorted(given.data.rglob("*.toml"))
              if not path.stem.endswith("_study") and path.stem != "small_tension"}  # over before it can be stopped
    assert scenes.keys() == short.keys(), "a scene of data/ has no short form here, or the other way round"
    for key, scene in scenes.items():
        if given.only not in key:
            continue
        with tempfile.TemporaryDirectory() as folder:
            check(given.mesopix.resolve(), key, scene.resolve(), [] if given.full else short[key], Path(folder))
