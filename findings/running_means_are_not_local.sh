#!/usr/bin/env bash
# SciPy and OpenCV: one bad pixel changes the 3 x 3 mean of pixels far away, each program in another direction.
source "$(dirname "${BASH_SOURCE[0]}")/fetch.sh"

cat <<'TEXT'
Belief: in a 3 x 3 mean one bad pixel (a no-data value, a NaN) spoils the 9 pixels around it and no other.
Why:    the mean of a window depends on the pixels of the window.
TEXT
fetch_debian python3-scipy=1.10.1-2 python3-opencv=4.6.0+dfsg-12
cat >mean.py <<'PY'
import sys

import cv2
import numpy
import scipy
from scipy.ndimage import uniform_filter

print(f"Seen:   SciPy {scipy.__version__}, OpenCV {cv2.__version__}; a picture of 200 x 200 ones in float32, one pixel (50, 50) bad")
far = {}
for bad in (numpy.float32(1e20), numpy.float32("nan")):
    picture = numpy.ones((200, 200), numpy.float32)
    picture[50, 50] = bad
    for name, mean in (("scipy.ndimage.uniform_filter", uniform_filter(picture, 3)), ("cv2.blur", cv2.blur(picture, (3, 3)))):
        wrong = ~numpy.isclose(mean, 1.0)
        wrong[49:52, 49:52] = False
        rows, columns = numpy.nonzero(wrong)
        far[name, str(bad)] = len(rows)
        where = f"rows {rows.min()} to {rows.max()}, columns {columns.min()} to {columns.max()}" if len(rows) else "nowhere"
        example = f", for example {mean[rows[-1], columns[-1]]:.3g} instead of 1" if len(rows) else ""
        print(f"        {bad!s:6} {name:29} wrong outside its window: {len(rows):6} ({where}{example})")
print("So:     both keep a running sum: they add the pixel that comes in and take away the one that goes out. What was lost in adding 1 to")
print("        1e20 does not come back. A plausible 0.333 is worse than a NaN.")
print("Cure:   replace no-data values before any mean (local thresholds have one inside), or use a correlation with a kernel of ninths.")
sys.exit(0 if all(far.values()) else "no longer so: the harm stays in the window")
PY
"$python" mean.py
