"""Breaks a small specimen, plots the run in every format, and opens the files with other programs.

    check_plot.py MESOPIX FOLDER
"""
import pathlib
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

import h5py
import numpy
from PIL import Image


def call(*command):
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    assert done.returncode == 0, f"{command}: {done.stderr}"
    return done.stdout + done.stderr


def share_of(picture, colour):
    """Share of the pixels of a picture that have a colour, give or take the rims of what is drawn."""
    pixels = numpy.asarray(Image.open(picture).convert("RGB")).astype(int)
    return (abs(pixels - numpy.array(colour)).max(axis=2) < 12).mean()


def nearest_frame(run, strain):
    frames = [h5py.File(path)["VTKHDF"] for path in sorted((run / "frames").iterdir())]
    return min(frames, key=lambda frame: abs(frame["FieldData/strain"][0] - strain))


def value_of(component, stress):
    """Of an array of stress tensors, by numpy [MPa]."""
    tensors = stress.reshape(-1, 3, 3).astype(float) / 1e6
    return {"xx": tensors[:, 0, 0], "yy": tensors[:, 1, 1], "first": numpy.linalg.eigvalsh(tensors)[:, -1]}[component]


def check_stress(mesopix, run, folder, component):
    """Each pixel has the colour that the colour bar of the same picture has at the stress which h5py reads."""
    with h5py.File(run / "result.h5") as file:
        peak, side = file.attrs["peak_strain"], file["failure_strain"].shape[0]
    frame = nearest_frame(run, peak)
    said = call(mesopix, "plot", run, "--what", "stress", "--component", component, "--range", "-4:8 MPa", "-o",
                folder / "one.pdf")
    assert pathlib.Path(frame.file.filename).name in said, said
    assert f"{100 * frame['FieldData/strain'][0] / peak:.1f}" in call("pdftotext", folder / "one.pdf", "-")
    call("pdftoppm", "-r", "384", "-png", "-singlefile", folder / "one.pdf", folder / "one")  # 4 pixels a px
    picture = numpy.asarray(Image.open(folder / "one.png").convert("RGB")).astype(int)
    margin, width = 4 * 16, 4 * 480
    at = margin + ((numpy.arange(side) + 0.5) * width / side).astype(int)
    bar = picture[margin + width + 4 * (22 + 33 + 9 + 7), margin + 4 * 16 : margin + width - 4 * 16]
    ids, damage = frame["PointData/id"][:], frame["PointData/damage"][:]
    value = value_of(component, frame["PointData/stress"][:])
    column = numpy.clip(((value + 4) / 12 * len(bar)).astype(int), 2, len(bar) - 3)  # its rim is mixed with the frame's
    wanted = numpy.where(damage[:, None] >= 1, 0, bar[column])
    off = abs(picture[at][:, at].reshape(-1, 3)[ids] - wanted).max(axis=1)
    assert len(ids) == side * side and (damage >= 1).sum() > 20 and numpy.ptp(value[damage < 1]) > 2
    assert off.max() <= 4, f"{component}: {(off > 4).sum()} of {len(ids)} pixels have other colours, by up to {off.max()}"
    print(f"stress {component}: {len(ids)} pixels have the colours of their values, within {off.max()} of 255")


def main():
    mesopix, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    run = folder / "run"
    scene = folder / "scene.toml"
    scene.write_text('[generate]\nwidth = "40 mm"\nheight = "40 mm"\npixel_size = "1 mm"\nfraction = 0.3\nd_min = "4 mm"\n'
                     'd_max = "10 mm"\n[loading]\nvelocity = "0.5 m/s"\nstop_drop = 0.3\n')
    call(mesopix, "simulate", scene, "-o", run, "--frames", "20")
    for ending in ("png", "svg", "pdf"):
        call(mesopix, "plot", run, "--at", "100%peak", "--look", "colour", "-o", folder / f"damage.{ending}")
        call(mesopix, "plot", run, "--what", "curve", "-o", folder / f"curve.{ending}")
        call(mesopix, "plot", run, "--what", "stress", "-o", folder / f"stress.{ending}")
    for kind, word in (("damage", "of the peak strain"), ("curve", "MPa"), ("stress", "tension positive")):
        call("pdftoppm", "-r", "180", "-png", "-singlefile", folder / f"{kind}.pdf", folder / f"{kind}_pdf")
        assert word in call("pdftotext", folder / f"{kind}.pdf", "-"), f"the words of {kind}.pdf cannot be searched"
        assert ElementTree.parse(folder / f"{kind}.svg").getroot().tag.endswith("svg")
        sizes = [Image.open(folder / name).size for name in (f"{kind}.png", f"{kind}_pdf.png")]
        assert abs(sizes[0][0] / sizes[0][1] - sizes[1][0] / sizes[1][1]) < 0.01, sizes
    cracked = (0x0b, 0x2c, 0x7a)
    mortar = share_of(folder / "damage.png", (0xf1, 0xe7, 0xd1)), share_of(folder / "damage_pdf.png", (0xf1, 0xe7, 0xd1))
    failed = share_of(folder / "damage.png", cracked), share_of(folder / "damage_pdf.png", cracked)
    assert failed[0] > 0.001 and abs(failed[0] / failed[1] - 1) < 0.15, failed
    for component in ("yy", "xx", "first"):
        check_stress(mesopix, run, folder, component)
    print(f"failed pixels: {failed[0]:.4f} of the PNG, {failed[1]:.4f} of the PDF; mortar {mortar[0]:.3f}, {mortar[1]:.3f}")


main()
