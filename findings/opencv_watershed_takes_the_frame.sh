#!/usr/bin/env bash
# OpenCV: watershed takes the outermost pixels of the picture away from every grain.
source "$(dirname "${BASH_SOURCE[0]}")/fetch.sh"

cat <<'TEXT'
Belief: cv2.watershed marks with -1 the lines where two grains meet, and every other pixel belongs to a grain.
Why:    -1 is described as the boundary between regions; a grain that runs out of the picture meets no other one there. scikit-image gives
        such pixels to the grain.
TEXT
fetch_debian python3-opencv=4.6.0+dfsg-12 python3-skimage=0.19.3-8
cat >watershed.py <<'PY'
import sys

import cv2
import numpy
import skimage
from skimage.segmentation import watershed

height, width = 40, 60
heights = numpy.zeros((height, width), numpy.uint8)
heights[:, width // 2] = 255
seeds = numpy.zeros((height, width), numpy.int32)
seeds[15:25, 10:20], seeds[15:25, 40:50] = 1, 2
of_cv = cv2.watershed(numpy.repeat(heights[:, :, None], 3, axis=2), seeds.copy())
of_ski = watershed(heights, seeds, watershed_line=True)
frame = numpy.ones((height, width), bool)
frame[1:-1, 1:-1] = False
print(f"Seen:   OpenCV {cv2.__version__}, scikit-image {skimage.__version__}; {width} x {height} pixels, two grains with one ridge between them")
for name, grains in (("OpenCV", of_cv), ("scikit-image", of_ski)):
    print(f"        {name:13} pixels of grain 1 and 2: {(grains == 1).sum()}, {(grains == 2).sum()}; frame pixels without a grain: {(grains[frame] <= 0).sum()} of {frame.sum()}")
print("So:     OpenCV writes -1 over the whole frame. Read as void, every specimen gets a gap along its edges, where it is held and loaded;")
print(f"        here {100 * frame.mean():.0f} % of the area.")
print("Cure:   add a border of one pixel before (copyMakeBorder) and cut it off after.")
sys.exit(0 if (of_cv[frame] == -1).all() and (of_ski[frame] > 0).mean() > 0.9 else "no longer so: the frame has grains")
PY
"$python" watershed.py
