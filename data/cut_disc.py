"""Cut a disc out of a square preview, as a label picture: 0 is void, 112 aggregate, 226 mortar.

    python3 data/cut_disc.py data/concrete.png data/disc.png

Reads 8-bit RGB, as `mesopix generate` draws its previews, and keeps the red of the two phases.
"""
import struct
import sys
import zlib


def chunks(png):
    at = 8
    while at < len(png):
        size, = struct.unpack(">I", png[at:at + 4])
        yield png[at + 4:at + 8], png[at + 8:at + 8 + size]
        at += 12 + size


def unfilter(data, rows, stride, step=3):
    """Lines of bytes, each of which was written as a difference from its neighbours."""
    lines, above = [], bytes(stride)
    for row in range(rows):
        kind, line = data[row * (stride + 1)], bytearray(data[row * (stride + 1) + 1:(row + 1) * (stride + 1)])
        for i in range(stride):
            a, b, c = (line[i - step], above[i], above[i - step]) if i >= step else (0, above[i], 0)
            nearest = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
            line[i] = (line[i] + (0, a, b, (a + b) // 2, nearest)[kind]) % 256
        lines.append(line)
        above = line
    return lines


def cut(source, target):
    png = open(source, "rb").read()
    parts = list(chunks(png))
    cols, rows, depth, colour = struct.unpack(">IIBB", dict(parts)[b"IHDR"][:10])
    assert (depth, colour) == (8, 2) and rows == cols, "must be a square picture in 8-bit RGB"
    lines = unfilter(zlib.decompress(b"".join(body for name, body in parts if name == b"IDAT")), rows, 3 * cols)
    inside = [[(2 * row + 1 - rows) ** 2 + (2 * col + 1 - cols) ** 2 <= cols ** 2 for col in range(cols)]
              for row in range(rows)]
    labels = [bytes(red if is_in else 0 for red, is_in in zip(line[::3], row)) for line, row in zip(lines, inside)]
    header = struct.pack(">IIBBBBB", cols, rows, 8, 0, 0, 0, 0)
    scale = dict(parts)[b"pHYs"]
    image = zlib.compress(b"".join(b"\0" + line for line in labels), 9)
    with open(target, "wb") as out:
        out.write(png[:8])
        for name, body in ((b"IHDR", header), (b"pHYs", scale), (b"IDAT", image), (b"IEND", b"")):
            out.write(struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body)))


cut(*sys.argv[1:])
