#!/usr/bin/env python3
"""How much memory a run takes for every point, report and files included: from the largest resident sets of two sizes.
Usage: memory_test.py MESOPIX"""
import os, subprocess, sys, tempfile

mesopix = os.path.abspath(sys.argv[1])
SCENE = """
[generate]
width = "{0} mm"
height = "{0} mm"
pixel_size = "1 mm"
fraction = "20 %"
d_min = "20 mm"
d_max = "40 mm"
[loading]
stop_strain = 2e-7
[solver]
threads = 1
"""


def largest_set(folder, edge, options):
    """[bytes]"""
    with open("scene.toml", "w", encoding="utf-8") as scene:
        scene.write(SCENE.format(edge))
    program = subprocess.Popen([mesopix, "simulate", "scene.toml", "-q", "--overwrite", "-o", "run", *options], cwd=folder,
                               stderr=subprocess.DEVNULL)
    _, status, used = os.wait4(program.pid, 0)
    program.returncode = os.waitstatus_to_exitcode(status)
    assert program.returncode == 0, options
    return used.ru_maxrss << 10


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    small, large = 200, 500
    for name, options, most in (("without inertia", ["--method", "quasi_static"], 200),
                                ("moving points", ["--kinematics", "moving"], 240)):
        of_a_point = (largest_set(folder, large, options) - largest_set(folder, small, options)) / (large**2 - small**2)
        print(f"{name}: {of_a_point:.0f} bytes a point")
        assert of_a_point <= most, f"{name}: {of_a_point:.0f} bytes a point, more than {most}"
