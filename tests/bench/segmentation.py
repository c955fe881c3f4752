#!/usr/bin/env python3
"""Taught segmentation beside scikit-image's TrainableSegmenter: the same strokes, comparable features, 100 trees.

    apt-get install python3-skimage python3-sklearn
    python3 tests/bench/segmentation.py build/release/bin/mesopix [--pictures FOLDER] [--looking]

Three synthetic cuts that data/dress_cut.py dresses, and the conglomerate of FOLDER (conglomerate.jpg and
conglomerate_instances.tif), if it is given. 20 strokes over 0.5 % of the pixels: at random places, or with --looking
each where the result of the others is most wrong. Prints the intersection over union of the stones, and seconds.
"""
import argparse
import pathlib
import subprocess
import sys
import tempfile
import time

import numpy
from PIL import Image

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import simulated_strokes as strokes_of

ROOT = pathlib.Path(__file__).resolve().parents[2]


def by_mesopix(program, folder, photo, strokes):
    strokes_of.save(strokes, folder / "strokes.png")
    begin = time.perf_counter()
    subprocess.run([program, "convert", photo, "--pixel-size", "0.1 mm", "--itz-mode", "none", "--strokes",
                    folder / "strokes.png", "-o", folder / "found.png", "-q"], check=True)
    return numpy.array(Image.open(folder / "found.png")), time.perf_counter() - begin


def by_skimage(photo, strokes):
    from skimage import feature, future
    from sklearn.ensemble import RandomForestClassifier
    picture = numpy.array(Image.open(photo).convert("RGB"))
    begin = time.perf_counter()
    segmenter = future.TrainableSegmenter(
        RandomForestClassifier(n_estimators=100, n_jobs=-1, random_state=0),
        lambda image: feature.multiscale_basic_features(image, sigma_min=1, sigma_max=16, channel_axis=-1))
    segmenter.fit(picture, numpy.where(strokes == strokes_of.NOTHING, 0, strokes + 1))
    return segmenter.predict(picture) - 1, time.perf_counter() - begin


def cuts(program, folder, pictures):
    for seed in (1, 2, 3):
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
    parser.add_argument("--seeds", type=int, default=1, help="sets of strokes for each picture")
    parser.add_argument("--alone", action="store_true", help="mesopix only")
    given = parser.parse_args()
    program = given.program.resolve()
    print("picture        strokes      mesopix: IoU  seconds     scikit-image: IoU  seconds")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for title, photo, truth in cuts(program, folder, given.pictures):
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
