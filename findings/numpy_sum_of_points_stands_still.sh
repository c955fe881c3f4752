#!/usr/bin/env bash
# NumPy: the sum of 20 million points over axis 0 in float32 is 16777216; the mean of a constant 1 is 0.84.
source "$(dirname "${BASH_SOURCE[0]}")/fetch.sh"

cat <<'TEXT'
Belief: p.sum(axis=0) and p.mean(axis=0) of an array of points (n, 3) in float32 are right to six digits.
Why:    NumPy adds pairwise, so that the error hardly grows with n, and p[:, 0].sum() over the same numbers is right.
TEXT
fetch_debian python3-numpy=1:1.24.2-1+deb12u1
cat >points.py <<'PY'
import sys

import numpy

n = 20_000_000
velocity = numpy.ones((n, 3), numpy.float32)
print(f"Seen:   NumPy {numpy.__version__}, {n} points with velocity (1, 1, 1) in float32")
whole, means, column = velocity.sum(axis=0), velocity.mean(axis=0), velocity[:, 0].sum()
print(f"        velocity.sum(axis=0)    {whole}")
print(f"        velocity.mean(axis=0)   {means}")
print(f"        velocity[:, 0].sum()    {column}")
print(f"        sum(axis=0, float64)    {velocity.sum(axis=0, dtype=numpy.float64)}")
print("So:     over the slow axis the numbers are added one by one. From 2^24 on, adding 1 to a float32 changes nothing: the momentum of a")
print("        cloud of points stands still, without a word.")
print("Cure:   sum(axis=0, dtype=float64), or keep the components apart in arrays (3, n).")
sys.exit(0 if whole[0] == 2**24 and column == n else "no longer so: both sums agree")
PY
"$python" points.py
