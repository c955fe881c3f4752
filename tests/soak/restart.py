#!/usr/bin/env python3
"""Stops a run of every scene of data/ halfway, goes on with it on another number of threads, and wants the same bits.

  restart.py MESOPIX DATA [--full] [--only NAME]

Without --full the scenes are loaded so fast that each takes a second or so.
"""
import argparse, sys, tempfile
from pathlib import Path

sys.dont_write_bytecode = True
from runs import checkpoints, digest, finished, frames, is_whole, scenes_of, simulate, stop, wait_for


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
    count = 0
    for key, (scene, options) in scenes_of(given.data, given.full).items():
        if given.only not in key:
            continue
        with tempfile.TemporaryDirectory() as folder:
            check(given.mesopix.resolve(), key, scene, options, Path(folder))
        count += 1
    print(f"In all: {count} scenes stopped halfway, each with the same bits in the end")
