#!/usr/bin/env bash
# nibabel: labels saved with the header of the scan come back as 0.99998 and 4.00005.
source "$(dirname "${BASH_SOURCE[0]}")/fetch.sh"

cat <<'TEXT'
Belief: labels 0 to 7 in an array of floats, saved with the header of the 16-bit scan they belong to, come back as 0 to 7.
Why:    the whole numbers 0 to 7 fit 16 bits without any scaling, and the header is passed on to keep voxel size and position.
TEXT
fetch_debian python3-nibabel=5.0.0-2 python3-numpy=1:1.24.2-1+deb12u1
cat >labels.py <<'PY'
import sys

import nibabel
import numpy

scan = nibabel.Nifti1Image(numpy.zeros((4, 4, 4), numpy.int16), numpy.diag([0.01, 0.01, 0.01, 1.0]))
labels = (numpy.arange(64).reshape(4, 4, 4) % 8).astype(float)
print(f"Seen:   nibabel {nibabel.__version__}, labels 0 to 7")
right = {}
for kind in ("float64", "int16"):
    nibabel.save(nibabel.Nifti1Image(labels.astype(kind), scan.affine, scan.header), "labels.nii")
    back = nibabel.load("labels.nii")
    values = back.get_fdata()
    right[kind] = (values == labels).mean()
    print(f"        from {kind:8} slope {back.dataobj.slope:<22.17g} back: {' '.join(f'{v:.6g}' for v in values.ravel()[:8])};  {100 * right[kind]:.1f} % equal")
print("So:     floats are stretched over the whole range of the 16 bits of the header. `labels == 3` then finds nothing, astype(int) makes 3 a 2.")
print("Cure:   astype('int16') before the image is made, or header.set_data_dtype('float32').")
sys.exit(0 if right["float64"] < 0.5 and right["int16"] == 1 else "no longer so: the labels come back")
PY
"$python" labels.py
