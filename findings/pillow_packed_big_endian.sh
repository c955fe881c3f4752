#!/usr/bin/env bash
# libtiff -> Pillow: a compressed big-endian TIFF with 32-bit numbers is read with its bytes the wrong way round.
source "$(dirname "${BASH_SOURCE[0]}")/fetch.sh"

cat <<'TEXT'
Belief: Pillow reads the same numbers from a TIFF whether its bytes are little or big endian, packed or not.
Why:    it does so for the unpacked file and for 16 bits; packing is undone by libtiff, which knows the order of the bytes.
TEXT
fetch_debian libtiff-tools=4.5.0-6+deb12u4 python3-pil=9.4.0-1.1+deb12u1 python3-numpy=1:1.24.2-1+deb12u1
cat >write.py <<'PY'
import numpy
from PIL import Image

for kind in ("uint16", "int32", "float32"):
    Image.fromarray(numpy.arange(1, 13).reshape(3, 4).astype(kind)).save(f"{kind}.tif")
PY
"$python" write.py
for kind in uint16 int32 float32; do
  for packing in none lzw zip; do
    tiffcp -B -c "$packing" "$kind.tif" "$kind-$packing.tif"
    tiffcmp "$kind.tif" "$kind-$packing.tif" >/dev/null # libtiff itself finds the same pixels in both
  done
done
cat >read.py <<'PY'
import sys

import numpy
import PIL
from PIL import Image, features

print(f"Seen:   Pillow {PIL.__version__} with libtiff {features.version('libtiff')}; the first numbers are 1 2 3, made big endian by tiffcp")
wrong = set()
for kind in ("uint16", "int32", "float32"):
    for packing in ("none", "lzw", "zip"):
        picture = numpy.asarray(Image.open(f"{kind}-{packing}.tif"))
        if not numpy.array_equal(picture, numpy.arange(1, 13).reshape(3, 4)):
            wrong.add((kind, packing))
        print(f"        {kind:8} {packing:5} {picture[0, 0]:.6g} {picture[0, 1]:.6g} {picture[0, 2]:.6g}")
print("So:     label 1 becomes 16777216 and a grey value becomes 4.6e-41. libtiff turns the bytes, and Pillow turns them once more.")
print("Cure:   tiffcp -L -c none first, or read with tifffile.")
same = {(kind, packing) for kind in ("int32", "float32") for packing in ("lzw", "zip")}
sys.exit(0 if wrong == same else f"no longer so: wrong are {sorted(wrong)}")
PY
"$python" read.py
