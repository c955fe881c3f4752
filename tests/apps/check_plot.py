"""Breaks a small specimen, plots the run in every format, and opens the files with other programs.

    check_plot.py MESOPIX FOLDER
"""
import pathlib
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

import numpy
from PIL import Image


def call(*command):
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    assert done.returncode == 0, f"{command}: {done.stderr}"
    return done.stdout


def share_of(picture, colour):
    """Share of the pixels of a picture that have a colour, give or take the rims of what is drawn."""
    pixels = numpy.asarray(Image.open(picture).convert("RGB")).astype(int)
    return (abs(pixels - numpy.array(colour)).max(axis=2) < 12).mean()


def main():
    mesopix, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    run = folder / "run"
    scene = folder / "scene.toml"
    scene.write_text('[generate]\nwidth = "40 mm"\nheight = "40 mm"\npixel_size = "1 mm"\nfraction = 0.3\nd_min = "4 mm"\n'
                     'd_max = "10 mm"\n[loading]\nvelocity = "0.5 m/s"\nstop_drop = 0.3\n')
    call(mesopix, "simulate", scene, "-o", run)
    for ending in ("png", "svg", "pdf"):
        call(mesopix, "plot", run, "--at", "100%peak", "--look", "colour", "-o", folder / f"damage.{ending}")
        call(mesopix, "plot", run, "--what", "curve", "-o", folder / f"curve.{ending}")
    for kind, word in (("damage", "of the peak strain"), ("curve", "MPa")):
        call("pdftoppm", "-r", "180", "-png", "-singlefile", folder / f"{kind}.pdf", folder / f"{kind}_pdf")
        assert word in call("pdftotext", folder / f"{kind}.pdf", "-"), f"the words of {kind}.pdf cannot be searched"
        assert ElementTree.parse(folder / f"{kind}.svg").getroot().tag.endswith("svg")
        sizes = [Image.open(folder / name).size for name in (f"{kind}.png", f"{kind}_pdf.png")]
        assert abs(sizes[0][0] / sizes[0][1] - sizes[1][0] / sizes[1][1]) < 0.01, sizes
    cracked = (0x0b, 0x2c, 0x7a)
    mortar = share_of(folder / "damage.png", (0xf1, 0xe7, 0xd1)), share_of(folder / "damage_pdf.png", (0xf1, 0xe7, 0xd1))
    failed = share_of(folder / "damage.png", cracked), share_of(folder / "damage_pdf.png", cracked)
    assert failed[0] > 0.001 and abs(failed[0] / failed[1] - 1) < 0.15, failed
    print(f"failed pixels: {failed[0]:.4f} of the PNG, {failed[1]:.4f} of the PDF; mortar {mortar[0]:.3f}, {mortar[1]:.3f}")


main()
