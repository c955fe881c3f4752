#!/usr/bin/env python3
"""A run that takes the place of an earlier one, and is gone before any of its calls that change the disk.

  overwrite.py MESOPIX LIBFAILING_DISK [--most N]

Whenever that was, no command may take results of the earlier run for those of the scene that stands beside them.
"""
import argparse, json, os, shutil, signal, subprocess, sys, tempfile
from pathlib import Path

scene = """[generate]
width = "20 mm"
height = "20 mm"
pixel_size = "1 mm"
fraction = 0.3
d_min = "4 mm"
d_max = "8 mm"
[loading]
velocity = "{} m/s"
stop_strain = 2e-5
"""


def call(*words, **settings):
    return subprocess.run([str(given.mesopix), *map(str, words)], capture_output=True, text=True,
                          env={**os.environ, **settings})


def overwrite(path, run, at, log):
    """@return whether it was killed."""
    log.write_text("")
    done = call("simulate", path, "--checkpoint-every", "1e-6 s", "--frames", 3, "--overwrite", "-o", run,
                LD_PRELOAD=str(given.disk), FAULT_FOLDER=str(run), FAULT_LOG=str(log), FAULT_MODE="kill", FAULT_AT=str(at))
    assert done.returncode in (0, -signal.SIGKILL), done.stderr
    return done.returncode != 0


def check(run, peaks, words):
    """What commands say of a run that may be of two."""
    now = (run / "scene.toml").read_text()
    shown = call("inspect", run, "--json")
    if shown.returncode == 0:
        peak = json.loads(shown.stdout)["largest_stress_Pa"]
        assert peak == peaks[now], f"{words}: the result of another scene is shown"
    for other in (("report", run), ("plot", run, "-o", run.parent / "x.png"), ("export", run, "--to", "tif")):
        done = call(*other)
        assert done.returncode == 0 or shown.returncode != 0 or other[0] == "export", f"{words}: {other[0]}: {done.stderr}"
        if shown.returncode != 0:
            assert done.returncode in (65, 74), f"{words}: {other[0]} takes what inspect refuses: {done.stderr}"
    gone_on = call("simulate", "--resume", run)
    if gone_on.returncode == 0:
        peak = json.loads(call("inspect", run, "--json").stdout)["largest_stress_Pa"]
        assert peak == peaks[now], f"{words}: --resume takes the result of another scene"


parser = argparse.ArgumentParser()
parser.add_argument("mesopix", type=Path)
parser.add_argument("disk", type=Path)
parser.add_argument("--most", type=int, help="calls that are tried, the first half of them from the beginning")
given = parser.parse_args()
given.mesopix, given.disk = given.mesopix.resolve(), given.disk.resolve()
with tempfile.TemporaryDirectory() as name:
    folder = Path(name)
    peaks = {}
    for name, velocity in (("old", 0.05), ("new", 0.1)):
        (folder / f"{name}.toml").write_text(scene.format(velocity))
        assert call("simulate", folder / f"{name}.toml", "--frames", 3, "-o", folder / name).returncode == 0
        peaks[(folder / name / "scene.toml").read_text()] = json.loads(
            (folder / name / "summary.json").read_text())["largest_stress_Pa"]
    assert len(set(peaks.values())) == 2
    run, log = folder / "run", folder / "log"
    shutil.copytree(folder / "old", run)
    assert not overwrite(folder / "new.toml", run, 0, log)
    calls = log.read_text().splitlines()
    # Only behind these the folder looks different.
    tried = [1] + [at + 1 for at, one in enumerate(calls, 1) if one.split()[0] in ("rename", "mkdir") and at < len(calls)]
    if given.most and given.most < len(tried):
        half = given.most // 2
        tried = [*tried[:half], *tried[half::-(-(len(tried) - half) // (given.most - half))]]
    for at in tried:
        shutil.rmtree(run)
        shutil.copytree(folder / "old", run)
        if overwrite(folder / "new.toml", run, at, log):
            check(run, peaks, f"call {at}, {log.read_text().splitlines()[-1]}")
    print(f"In all: gone before {len(tried)} of {len(calls)} calls; no result was taken for that of another scene")
