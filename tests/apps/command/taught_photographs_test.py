#!/usr/bin/env python3
"""Strokes that were painted by hand over photographs, and simulated ones over a picture with hand-made instances.

Usage: taught_photographs_test.py MESOPIX SOURCE_DIR. The photographs are no part of the project: MESOPIX_PICTURES names
their folder, or they are in shared/images in or beside the source tree; without them it is skipped.
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy
from PIL import Image

program, source = sys.argv[1], pathlib.Path(sys.argv[2])
sys.path.insert(0, str(source / "tests/bench"))
import simulated_strokes as strokes_of  # noqa: E402

places = [os.environ.get("MESOPIX_PICTURES", ""), source / "shared/images", source.parent / "shared/images"]
pictures = next((pathlib.Path(place) for place in places if place and pathlib.Path(place).is_dir()), None)
if pictures is None:
    print("skipped: the photographs are not at hand; MESOPIX_PICTURES names their folder")
    sys.exit(77)

# Shares of the area by phase, and what is at places (x, y as shares of width and height), as seen in the photograph.
SEEN = {
    "concrete_cut_two_aggregates.jpg": (
        {"aggregate": (0.47, 0.02), "void": (0.010, 0.005)},
        {"aggregate": [(.3, .15), (.3, .3), (.3, .5), (.3, .7), (.9, .3), (.9, .5), (.9, .65), (.69, .12)],
         "mortar": [(.6, .1), (.6, .3), (.6, .6), (.6, .9), (.1, .9)], "void": [(.315, .885), (.57, .16)]}),
    "concrete_cut_voids.jpg": (
        {"aggregate": (0.515, 0.02), "void": (0.030, 0.01)},
        {"aggregate": [(.5, .15), (.2, .4), (.25, .85), (.95, .15)], "mortar": [(.6, .45), (.75, .85), (.2, .15)],
         "void": [(.95, .6), (.4, .55), (.775, .045), (.87, .74)]}),
    "cracked_mortar.png": (
        {"void": (0.20, 0.01)}, {"void": [(.5, .95), (.477, .72), (.59, .06)], "mortar": [(.2, .5), (.8, .3), (.6, .7)]}),
}
NUMBER = {"void": 0, "aggregate": 1, "mortar": 2}
faults = []


def convert(*arguments):
    said = subprocess.run([program, "convert", *arguments, "--itz-mode", "none", "--json"], capture_output=True, text=True)
    if said.returncode != 0:
        sys.exit(said.stderr)
    return json.loads(said.stdout)


def check(what, holds):
    if not holds:
        faults.append(what)


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    for photo, (shares, at) in SEEN.items():
        strokes = source / "tests/apps/strokes" / (pathlib.Path(photo).stem + ".csv")
        found = convert(pictures / photo, "--pixel-size", "0.01 mm", "--strokes", strokes, "-o", folder / "found.png")
        for phase, (wanted, off) in shares.items():
            share = found["phases"][phase]["fraction"]
            check(f"{photo}: {phase} is {share:.3f} of the area, not {wanted} +- {off}", abs(share - wanted) <= off)
        labels = numpy.array(Image.open(folder / "found.png"))
        for phase, spots in at.items():
            for x, y in spots:
                met = labels[int(y * labels.shape[0]), int(x * labels.shape[1])]
                check(f"{photo}: label {met} at ({x}, {y}), where the photograph shows {phase}", met == NUMBER[phase])
        check(f"{photo}: {found['uncertain']:.3f} of the area is uncertain", found["uncertain"] < 0.06)

    instances = pictures / "conglomerate_instances.tif"
    truth = numpy.where(numpy.array(Image.open(instances)) > 0, 1, 2).astype(numpy.uint8)

    def sort(strokes):
        strokes_of.save(strokes, folder / "strokes.png")
        convert(pictures / "conglomerate.jpg", "--pixel-size", "0.39 mm", "--strokes", folder / "strokes.png", "-o",
                folder / "found.png")
        return numpy.array(Image.open(folder / "found.png"))

    strokes = strokes_of.looking(truth, sort)
    sort(strokes)
    found = convert(pictures / "conglomerate.jpg", "--pixel-size", "0.39 mm", "--strokes", folder / "strokes.png", "-o",
                    folder / "found.png", "--reference", instances)
    share = found["intersection_over_union"]["aggregate"]
    print(f"conglomerate: IoU {share:.3f}, boundary F {found['boundary_f']['aggregate']:.3f}, panoptic quality "
          f"{found['aggregates_found']['panoptic_quality']:.3f}")
    check(f"conglomerate: IoU {share:.3f} of the stones", share > 0.78)  # 0.81 was measured
print("\n".join(faults))
sys.exit(bool(faults))
