#!/usr/bin/env python3
"""Taught segmentation beside scikit-image's TrainableSegmenter: the same strokes, comparable features, 100 trees.

    apt-get install python3-skimage python3-sklearn
    python3 tests/bench/segmentation.py build/release/bin/mesopix [--pictures FOLDER] [--looking] [--cuts 3]

Synthetic cuts that data/dress_cut.py dresses, and the conglomerate of FOLDER (conglomerate.jpg and
conglomerate_instances.tif), if it is given. 20 strokes over 0.5 % of the pixels: at random places, or with --looking
each where the result of the others is most wrong. Prints the intersection over union of the stones, and seconds of CPU
time, so that other work on the machine does not count: of mesopix from file to file, of scikit-image without reading.
"""
import argparse
import pathlib
import resource
import subprocess
import sys
import tempfile

import numpy
from PIL import Image

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import simulated_strokes as strokes_of

ROOT = pathlib.Path(__file__).resolve().parents[2]


def seconds(who):
    """CPU time of this process, or of those that it waited for."""
    used = resource.getrusage(who)
    return used.ru_utime + used.ru_stime


def by_mesopix(program, folder, photo, strokes):
    strokes_of.save(strokes, folder / "strokes.png")
    begin = seconds(resource.RUSAGE_CHILDREN)
    subprocess.run([program, "convert", photo, "--pixel-size", "0.1 mm", "--itz-mode", "none", "--strokes",
                    folder / "strokes.png", "-o", folder / "found.png", "-q"], check=True)
    used = seconds(resource.RUSAGE_CHILDREN) - begin
    return numpy.array(Image.open(folder / "found.png")), used


def by_skimage(photo, strokes):
    from skimage import feature, future
    from sklearn.ensemble import RandomForestClassifier
    picture = numpy.array(Image.open(photo).convert("RGB"))
    begin = seconds(resource.RUSAGE_SELF)
    segmenter = future.TrainableSegmenter(
        RandomForestClassifier(n_estimators=100, random_state=0),
        lambda image: feature.multiscale_basic_features(image, sigma_min=1, sigma_max=16, channel_axis=-1))
    segmenter.fit(picture, numpy.where(strokes == strokes_of.NOTHING, 0, strokes + 1))
    found = segmenter.predict(picture) - 1
    return found, seconds(resource.RUSAGE_SELF) - begin


def cuts(program, folder, pictures, count):
    for seed in range(1, count + 1):
        labels, photo, truth = (folder / f"{name}{seed}.{kind}" for name, kind in
                                (("labels", "png"), ("cut", "jpg"), ("truth", "png")))
        subprocess.run([program, "generate", "--itz-mode", "none", "--width", "60 mm", "--height", "60 mm",
                        "--pixel-size", "0.1 mm", "--d-min", "3 mm", "--d-max", "16 mm", "--fraction", "0.42", "--gap",
                        "0.4 mm", "--seed", str(seed), "-o", labels, "-q"], check=True)
        subprocess.run([sys.executable, ROOT / "data/dress_cut.py", labels, photo, truth, "--seed", str(seed)],
                       check=True)
        yield f"synthetic {seed}", photo, numpy.array(Image.open(truth))
    if pictures:
        instances = numpy.array(Image.open(pictures / "conglomerate_instances.tif"))
        yield "conglomerate", pictures / "conglomerate.jpg", numpy.where(instances > 0, 1, 2).astype(numpy.uint8)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--pictures", type=pathlib.Path)
    parser.add_argument("--looking", action="store_true")
    parser.add_argument("--cuts", type=int, default=3, help="number of synthetic cuts")
    parser.add_argument("--seeds", type=int, default=1, help="sets of strokes for each picture")
    parser.add_argument("--alone", action="store_true", help="mesopix only")
    given = parser.parse_args()
    program = given.program.resolve()
    print("picture        strokes      mesopix: IoU  seconds     scikit-image: IoU  seconds")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for title, photo, truth in cuts(program, folder, given.pictures, given.cuts):
            for seed in range(given.seeds):
                if given.looking:
                    strokes = strokes_of.looking(
                        truth, lambda some: by_mesopix(program, folder, photo, some)[0], seed=seed)
                else:
                    strokes = strokes_of.blind(truth, seed=seed)
                ours, our_time = by_mesopix(program, folder, photo, strokes)
                line = (f"{title:14} {(strokes != strokes_of.NOTHING).mean():7.3%}      "
                        f"{strokes_of.overlap(ours, truth, 1):12.3f}  {our_time:7.2f}")
                if not given.alone:
                    theirs, their_time = by_skimage(photo, strokes)
                    line += f"     {strokes_of.overlap(theirs, truth, 1):17.3f}  {their_time:7.2f}"
                print(line, flush=True)


if __name__ == "__main__":
    main()
