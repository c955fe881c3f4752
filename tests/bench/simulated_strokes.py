"""Strokes that a person might paint over a picture whose phases are known: for tests and benchmarks."""
import math

import numpy
from PIL import Image, ImageDraw

COLOURS = {0: (255, 255, 255), 1: (112, 128, 150), 2: (226, 205, 160)}
NOTHING = 255


def eroded(inside, times):
    """Pixels at least so many steps away from what is not inside, and from the border."""
    for _ in range(times):
        shrunk = numpy.zeros_like(inside)
        shrunk[1:-1, 1:-1] = (inside[1:-1, 1:-1] & inside[:-2, 1:-1] & inside[2:, 1:-1] & inside[1:-1, :-2]
                              & inside[1:-1, 2:])
        inside = shrunk
    return inside


def deepest(inside):
    """The pixels that erosion leaves last, and how many steps that took."""
    steps = 0
    while True:
        smaller = eroded(inside, 1)
        if not smaller.any():
            return inside, steps
        inside, steps = smaller, steps + 1


def curve(random, room, begin, length):
    """Points of a smooth line of at most this length that stays in the room."""
    rows, cols = room.shape
    best = [begin]
    for _ in range(30):
        direction = random.uniform(0, 2 * math.pi)
        halves = []
        for turn in (0, math.pi):
            row, col, heading, half = *begin, direction + turn, []
            while len(half) < length / 2:
                heading += random.normal(0, 0.12)
                row, col = row + math.sin(heading), col + math.cos(heading)
                if not (0 <= row < rows and 0 <= col < cols and room[int(row), int(col)]):
                    break
                half.append((row, col))
            halves.append(half)
        line = halves[0][::-1] + [begin] + halves[1]
        if len(line) > len(best):
            best = line
    return best


def paint(strokes, line, label, width):
    rows, cols = strokes.shape
    layer = Image.fromarray(strokes)
    points = [(col + 0.5, row + 0.5) for row, col in line]
    if len(points) > 1:
        ImageDraw.Draw(layer).line(points, fill=int(label), width=width)
    else:
        ImageDraw.Draw(layer).point(points, fill=int(label))
    return numpy.array(layer)


def blind(truth, count=20, share=0.005, seed=0, width=3):
    """So many strokes over this share of the picture: as many of each phase, at random places well inside it."""
    random = numpy.random.default_rng(seed)
    strokes = numpy.full(truth.shape, NOTHING, numpy.uint8)
    labels = [label for label in range(3) if (truth == label).any()]
    for number in range(count):
        label = labels[number % len(labels)]
        room = eroded(truth == label, width // 2 + 2)
        if not room.any():
            room = deepest(truth == label)[0]
        free = numpy.argwhere(room & (strokes == NOTHING))
        begin = tuple(float(x) for x in free[random.integers(len(free))])
        strokes = paint(strokes, curve(random, room, begin, truth.size * share / count / width), label, width)
    strokes[(strokes != NOTHING) & (strokes != truth)] = NOTHING
    return strokes


def looking(truth, sort, count=20, share=0.005, seed=0, width=3):
    """The same by a person who looks at the result and puts the next stroke where most is wrong.

    sort(strokes) gives the labels that the strokes lead to.
    """
    random = numpy.random.default_rng(seed)
    strokes = numpy.full(truth.shape, NOTHING, numpy.uint8)
    labels = [label for label in range(3) if (truth == label).any()]
    for number in range(count):
        if number < len(labels):
            label = labels[number]
            place, depth = deepest(truth == label)
        else:
            found = sort(strokes)
            tries = [(deepest((truth == one) & (found != one)), one) for one in labels]
            (place, depth), label = max(tries, key=lambda one: one[0][1])
        begins = numpy.argwhere(place)
        begin = tuple(float(x) for x in begins[random.integers(len(begins))])
        room = eroded(truth == label, min(width // 2 + 1, max(depth - 1, 0)))
        strokes = paint(strokes, curve(random, room, begin, truth.size * share / count / width), label, width)
        strokes[(strokes != NOTHING) & (strokes != truth)] = NOTHING
    return strokes


def save(strokes, path):
    """As a layer that is transparent but for the strokes."""
    layer = numpy.zeros((*strokes.shape, 4), numpy.uint8)
    for label, colour in COLOURS.items():
        layer[strokes == label] = (*colour, 255)
    Image.fromarray(layer).save(path)


def overlap(found, truth, label):
    """Intersection over union."""
    return ((found == label) & (truth == label)).sum() / max(1, ((found == label) | (truth == label)).sum())
