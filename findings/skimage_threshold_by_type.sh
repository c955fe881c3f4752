#!/usr/bin/env bash
# scikit-image: the same grey values as uint16 and as float have other thresholds, and so other volume fractions.
source "$(dirname "${BASH_SOURCE[0]}")/fetch.sh"

cat <<'TEXT'
Belief: a threshold found by scikit-image depends on the grey values, not on the type that holds them; what is lost in a histogram of
        256 bins is one bin at most.
Why:    the methods are functions of the grey values, and every whole number up to 65535 is exact in float64.
TEXT
fetch_debian python3-skimage=0.19.3-8 python3-skimage-lib=0.19.3-8+b1
cat >threshold.py <<'PY'
import sys

import numpy
import skimage
from skimage.filters import threshold_li, threshold_otsu, threshold_triangle, threshold_yen

draw = numpy.random.default_rng(1)
scan = numpy.concatenate([draw.normal(10000, 800, 6000), draw.normal(14000, 800, 4000)]).round().astype(numpy.uint16)
bin_width = (int(scan.max()) - int(scan.min())) / 256
print(f"Seen:   scikit-image {skimage.__version__}; 6000 voxels around 10000 and 4000 around 14000, one bin of 256 is {bin_width:.0f} wide")
gap = {}
for method in (threshold_triangle, threshold_otsu, threshold_yen, threshold_li):
    whole, real = float(method(scan)), float(method(scan.astype(numpy.float64)))
    gap[method.__name__] = abs(whole - real) / bin_width
    print(f"        {method.__name__:19} uint16: {whole:7.0f} ({(scan > whole).mean():.1%} above)   float64: {real:7.0f} ({(scan > real).mean():.1%} above)")
print("So:     whole numbers are counted one by one and floats in 256 bins. The triangle method sees another shape in each: a scan that was")
print("        read as float, or divided by 1, has another share of stones.")
print("Cure:   choose the type on purpose, give the histogram yourself (hist=...), and write down both with the result.")
sys.exit(0 if gap["threshold_triangle"] > 10 else "no longer so: the thresholds agree within a few bins")
PY
"$python" threshold.py 2>/dev/null
