#!/usr/bin/env bash
# HDF5: the scale-offset filter turns a NaN into the smallest number of its chunk, unless it is the first one.
source "$(dirname "${BASH_SOURCE[0]}")/fetch.sh"

cat <<'TEXT'
Belief: a field packed with scaleoffset=3 comes back right to three decimals, and a NaN (a failed point, an empty voxel) comes back NaN.
Why:    infinities and 1e30 do come back, and the filter is free to keep a chunk unpacked that it cannot pack.
TEXT
fetch_debian python3-h5py=3.7.0-8 python3-h5py-serial=3.7.0-8 python3-numpy=1:1.24.2-1+deb12u1
cat >nan.py <<'PY'
import sys

import h5py
import numpy

print(f"Seen:   h5py {h5py.version.version} with HDF5 {h5py.version.hdf5_version}; stresses from 10 to 20, one of 12 replaced")
back = {}
for name, value in (("NaN", numpy.nan), ("inf", numpy.inf), ("1e30", 1e30)):
    for place in (0, 5, 11):
        stress = numpy.linspace(10.0, 20.0, 12)
        stress[place] = value
        with h5py.File("field.h5", "w") as file:
            file.create_dataset("stress", data=stress, chunks=(12,), scaleoffset=3)
        with h5py.File("field.h5", "r") as file:
            back[name, place] = file["stress"][place]
    print(f"        {name:4} written at place 0, 5, 11: read {back[name, 0]:g}, {back[name, 5]:g}, {back[name, 11]:g}")
print("So:     a failed point becomes the least loaded one; mean and minimum are plausible, and isnan finds nothing.")
print("Cure:   a mask of its own for what has no value, or gzip with shuffle instead.")
hidden = numpy.isfinite(back["NaN", 5]) and numpy.isfinite(back["NaN", 11]) and numpy.isinf(back["inf", 5])
sys.exit(0 if hidden else "no longer so: the NaN comes back")
PY
"$python" nan.py
