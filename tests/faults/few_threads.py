#!/usr/bin/env python3
"""Commands where the system gives a program few threads: each ends, with the result that it has with many, or says why.

  few_threads.py MESOPIX [COMMAND ...]

Only root can become a user who has no other tasks; for others there is nothing to test.
"""
import filecmp, os, resource, shutil, subprocess, sys, tempfile
from pathlib import Path

scene = """[generate]
width = "20 mm"
height = "20 mm"
pixel_size = "1 mm"
fraction = 0.3
d_min = "4 mm"
d_max = "8 mm"
[loading]
velocity = "0.05 m/s"
stop_strain = 2e-5
"""
commands = {
    "simulate": ["simulate", "scene.toml", "--threads", "4", "--checkpoint-every", "1e-3 s", "-o", "out"],
    "served": ["simulate", "scene.toml", "--threads", "4", "--serve", "-o", "out"],
    "quasi-static": ["simulate", "scene.toml", "--threads", "4", "--set", "solver.method=quasi_static", "-o", "out"],
    "study": ["study", "study.toml", "--jobs", "4", "-o", "out"],
    "report": ["report", "run"],
    "taught": ["convert", "picture.pgm", "--pixel-size", "0.5 mm", "--strokes", "strokes.csv", "-o", "out.h5"],
    "convert": ["convert", "picture.pgm", "--pixel-size", "0.5 mm",
                "--label-phases", "90:mortar,220:aggregate", "-o", "out.h5"],
}
same = {"simulate": ["out/curve.csv"], "served": ["out/curve.csv"], "quasi-static": ["out/curve.csv"],
        "study": ["out/table.csv"], "report": ["run/curve.csv", "run/summary.json"], "convert": ["out.h5"], "taught": ["out.h5"]}


def call(words, folder, most=None):
    """With so many tasks at most, this program among them."""
    def limit():
        resource.setrlimit(resource.RLIMIT_NPROC, (most, most))
        os.setgid(61000 + most)
        os.setuid(61000 + most)

    return subprocess.run([mesopix, *words], cwd=folder, capture_output=True, text=True, timeout=120,
                          preexec_fn=limit if most else None)


def prepare(folder):
    folder.mkdir()
    folder.chmod(0o777)
    (folder / "scene.toml").write_text(scene)
    (folder / "study.toml").write_text('scene = "scene.toml"\nseeds = 4\n')
    bright = [(x // 20 + y // 20) % 2 for y in range(80) for x in range(80)]
    (folder / "picture.pgm").write_bytes(b"P5 80 80 255\n" + bytes(220 if grain else 90 for grain in bright))
    (folder / "strokes.csv").write_text("stroke,phase,width_px,x_px,y_px\n1,mortar,3,5,5\n1,mortar,3,14,14\n"
                                        "2,aggregate,3,25,5\n2,aggregate,3,34,14\n")
    if (whole / "run").exists():
        shutil.copytree(whole / "run", folder / "run")
        for path in [folder / "run", *(folder / "run").iterdir()]:
            path.chmod(0o777)


if os.getuid() != 0:
    sys.exit(77)
with tempfile.TemporaryDirectory() as name:
    os.chmod(name, 0o755)
    mesopix = shutil.copy(sys.argv[1], name)  # which others may read there
    os.chmod(mesopix, 0o755)
    whole = Path(name) / "whole"
    prepare(whole)
    done = call(["simulate", "scene.toml", "-o", "run"], whole)
    assert done.returncode == 0, done.stderr
    for title in sys.argv[2:] or commands:
        words = commands[title]
        good = Path(name) / title
        prepare(good)
        done = call(words, good)
        assert done.returncode == 0, f"{title}: {done.stderr}"
        for most in range(1, 6):
            folder = Path(name) / f"{title}_{most}"
            prepare(folder)
            done = call(words, folder, most)
            where = f"{title}, {most} threads: exit code {done.returncode}: {done.stderr}"
            if title == "served" and done.returncode == 75:
                assert most < 3 and "--serve: " in done.stderr and not (folder / "out/result.h5").exists(), where
                continue
            assert done.returncode == 0, where
            for path in same[title]:
                assert filecmp.cmp(good / path, folder / path, shallow=False), f"{path} differs; {where}"
print(f"In all: {len(sys.argv[2:] or commands)} commands with 1 to 5 threads")
