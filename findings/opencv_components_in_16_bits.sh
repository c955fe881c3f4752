#!/usr/bin/env bash
# OpenCV: connectedComponents with 16-bit labels counts 90000 grains as 24464 and gives distant grains the same label.
source "$(dirname "${BASH_SOURCE[0]}")/fetch.sh"

cat <<'TEXT'
Belief: connectedComponents(image, ltype=CV_16U) raises an error when there are more components than 65535.
Why:    OpenCV checks the type asked for and raises an error for any other one; the count it returns is a plain int that would show it.
TEXT
fetch_debian python3-opencv=4.6.0+dfsg-12
cat >components.py <<'PY'
import sys

import cv2
import numpy

grains = numpy.zeros((600, 600), numpy.uint8)
grains[::2, ::2] = 1
count, labels = cv2.connectedComponents(grains, ltype=cv2.CV_16U)
right, wide = cv2.connectedComponents(grains, ltype=cv2.CV_32S)
print(f"Seen:   OpenCV {cv2.__version__}, {int(grains.sum())} single pixels that do not touch")
print(f"        32-bit labels: count {right - 1}, largest label {wide.max()}")
print(f"        16-bit labels: count {count - 1}, largest label {labels.max()}, pixels with label 1: {(labels == 1).sum()}, grains lost in the")
print(f"        background: {((labels == 0) & (grains == 1)).sum()}")
print("So:     the labels start again from 0, and so does the count that is returned. One grain becomes void, thousands become pairs.")
print("Cure:   ltype=CV_32S (what one gets without asking), and convert after looking at the count.")
sys.exit(0 if count != right and (labels == 1).sum() > 1 else "no longer so: all grains are told apart")
PY
"$python" components.py
