"""Dress labels as the photograph of a saw cut: textures, voids, uneven light, blur, noise and JPEG.

    mesopix generate --itz-mode none --pixel-size "0.1 mm" -o labels.png
    python3 data/dress_cut.py labels.png photo.jpg truth.png --seed 1

The labels are those that mesopix writes: 1 aggregate, 2 mortar. truth.png has the voids too, which are drawn into the
mortar: 0. It needs NumPy and Pillow.
"""
import argparse

import numpy
from PIL import Image


def blurred(field, sigma):
    """A Gaussian blur, periodic at the edges."""
    rows, cols = (numpy.fft.fftfreq(n) for n in field.shape)
    gain = numpy.exp(-2 * (numpy.pi * sigma) ** 2 * (rows[:, None] ** 2 + cols[None, :] ** 2))
    return numpy.real(numpy.fft.ifft2(numpy.fft.fft2(field) * gain))


def mottled(random, shape, sigma):
    """Noise in spots of the size sigma, with a mean of 0 and a deviation of 1."""
    field = blurred(random.standard_normal(shape), sigma)
    return (field - field.mean()) / field.std()


def pieces(labels):
    """Connected pieces of label 1, numbered from 1; each takes the least number of its neighbours until none changes."""
    count = numpy.where(labels == 1, numpy.arange(1, labels.size + 1).reshape(labels.shape), labels.size + 1)
    inside = labels == 1
    while True:
        before = count.copy()
        for axis in (0, 1):
            for step in (1, -1):
                along = numpy.moveaxis(count, axis, 0)[::step]
                gate = numpy.moveaxis(inside, axis, 0)[::step]
                for i in range(1, len(along)):
                    both = gate[i] & gate[i - 1]
                    along[i][both] = numpy.minimum(along[i][both], along[i - 1][both])
        if (count == before).all():
            break
    numbers = numpy.unique(count[inside])
    return numpy.where(inside, numpy.searchsorted(numbers, count) + 1, 0)


def with_voids(random, labels):
    """Round voids in the mortar, apart from the aggregates."""
    truth, rows, cols = labels.copy(), *labels.shape
    y, x = numpy.mgrid[:rows, :cols]
    for _ in range(60):
        radius = random.uniform(0.008, 0.025) * min(rows, cols)
        row, col = random.uniform(0, rows), random.uniform(0, cols)
        near = (y - row) ** 2 + (x - col) ** 2 < (radius + 3) ** 2
        if (truth[near] == 2).all():
            truth[(y - row) ** 2 + (x - col) ** 2 < radius ** 2] = 0
    return truth


ROCKS = [(128, 126, 124), (150, 140, 128), (112, 116, 122), (166, 160, 154), (142, 124, 118), (104, 104, 100)]


def dressed(random, truth):
    shape = truth.shape
    paste = numpy.array([176, 164, 146.0])[None, None, :] + 5 * mottled(random, shape, 12)[..., None]
    sand = mottled(random, shape, 1.6)
    tint = numpy.stack([mottled(random, shape, 2.2) for _ in range(3)], -1)
    picture = paste + 17 * sand[..., None] + 6 * tint
    grains = pieces(truth)
    for number in range(1, grains.max() + 1):
        mine = grains == number
        rock = numpy.array(ROCKS[random.integers(len(ROCKS))]) + random.uniform(-8, 8)
        minerals = mottled(random, shape, random.uniform(2.5, 6))
        bands = numpy.sin((numpy.mgrid[:shape[0], :shape[1]] * random.standard_normal(2)[:, None, None]).sum(0)
                          / random.uniform(4, 12))
        texture = rock + (random.uniform(4, 9) * minerals + random.uniform(0, 4) * bands)[..., None]
        picture[mine] = texture[mine]
    depth = blurred((truth == 0).astype(float), 6)
    dark = numpy.array([70, 62, 55.0]) + 40 * (1 - depth[..., None]) + 4 * mottled(random, shape, 1)[..., None]
    picture[truth == 0] = dark[truth == 0]
    y, x = (numpy.linspace(-1, 1, n) for n in shape)
    a, b, c = random.uniform(-0.2, 0.2, 3)
    light = 1 + a * x[None, :] + b * y[:, None] + c * (x[None, :] ** 2 + y[:, None] ** 2 - 0.67) / 2
    picture *= light[..., None]
    picture = numpy.stack([blurred(picture[..., k], random.uniform(0.7, 1.1)) for k in range(3)], -1)
    return numpy.clip(picture + 3 * random.standard_normal(picture.shape), 0, 255).astype(numpy.uint8)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("labels")
    parser.add_argument("photo")
    parser.add_argument("truth")
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    generator = numpy.random.default_rng(given.seed)
    known = with_voids(generator, numpy.array(Image.open(given.labels)))
    Image.fromarray(dressed(generator, known)).save(given.photo, quality=85)
    Image.fromarray(known).save(given.truth)
