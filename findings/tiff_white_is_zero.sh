#!/usr/bin/env bash
# TIFF with WhiteIsZero: Pillow and OpenCV turn the greys round at 8 bits and not at 16, tifffile at neither.
source "$(dirname "${BASH_SOURCE[0]}")/fetch.sh"

cat <<'TEXT'
Belief: a program either turns pictures whose zero is white (tag 262 = 0), so that bright is large, or it does not.
Why:    the tag says what the numbers mean. How many bits they have changes nothing about it.
TEXT
fetch_debian python3-opencv=4.6.0+dfsg-12 python3-pil=9.4.0-1.1+deb12u1 python3-tifffile=20230203-1
cat >white.py <<'PY'
import sys

import cv2
import numpy
import PIL
import tifffile
from PIL import Image

print(f"Seen:   Pillow {PIL.__version__}, OpenCV {cv2.__version__}, tifffile {tifffile.__version__}; the stored numbers are 0 10 20 30")
turned = {}
for kind in (numpy.uint8, numpy.uint16):
    stored = numpy.tile(numpy.array([0, 10, 20, 30], kind), (3, 1))
    tifffile.imwrite("zero.tif", stored, photometric="miniswhite")
    bits = 8 * stored.itemsize
    for name, picture in (
        ("Pillow", numpy.asarray(Image.open("zero.tif"))),
        ("OpenCV", cv2.imread("zero.tif", cv2.IMREAD_UNCHANGED)),
        ("tifffile", tifffile.imread("zero.tif")),
    ):
        turned[name, bits] = not numpy.array_equal(picture, stored)
        print(f"        {bits:2} bits  {name:9} {picture[0]}")
print("So:     the same scan saved at 16 instead of 8 bits has its pores and its stones exchanged by Pillow and by OpenCV, not by tifffile.")
print("Cure:   save scans as BlackIsZero; look at tag 262 before a threshold.")
expected = {("Pillow", 8): True, ("Pillow", 16): False, ("OpenCV", 8): True, ("OpenCV", 16): False, ("tifffile", 8): False, ("tifffile", 16): False}
sys.exit(0 if turned == expected else f"no longer so: turned round are {[key for key in turned if turned[key]]}")
PY
"$python" white.py
