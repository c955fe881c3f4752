#!/usr/bin/env bash
# SciPy: minres(tol=1e-5) reports success with 93 % of the residual left.
source "$(dirname "${BASH_SOURCE[0]}")/fetch.sh"

cat <<'TEXT'
Belief: minres(A, b, tol=1e-5) with info 0 means |b - A x| <= 1e-5 |b|, as with cg of the same module.
Why:    the two have the same arguments, and the description of minres says that it ends when the relative residual is below tol.
TEXT
fetch_debian python3-scipy=1.10.1-2
cat >minres.py <<'PY'
import sys

import numpy
import scipy
import scipy.sparse
from scipy.sparse.linalg import cg, minres

print(f"Seen:   SciPy {scipy.__version__}, a row of n equal springs held at both ends under an even load, tol = 1e-5")
print("        n      minres info, |b - A x| / |b|, largest displacement    cg info, |b - A x| / |b|    largest displacement, exact")
left = {}
for n in (100, 1000, 10000):
    A = scipy.sparse.diags([-1, 2, -1], [-1, 0, 1], (n, n), format="csr")
    b = numpy.ones(n)
    exact = numpy.arange(1, n + 1) * (n - numpy.arange(n)) / 2.0
    x, info = minres(A, b, tol=1e-5)
    y, good = cg(A, b, tol=1e-5)
    left[n] = (info, numpy.linalg.norm(b - A @ x) / numpy.linalg.norm(b))
    right = numpy.linalg.norm(b - A @ y) / numpy.linalg.norm(b)
    print(f"        {n:<7}{info}  {left[n][1]:10.3f}  {x.max():12.5g} {'':22}{good}  {right:8.1e} {'':14}{exact.max():12.5g}")
print("So:     minres measures the residual against |A| |x|, which is huge for a soft body, and stops almost where it began.")
print("Cure:   compute b - A x yourself, or use cg for positive definite matrices.")
sys.exit(0 if left[1000][0] == 0 and left[1000][1] > 0.5 else "no longer so: the residual is below tol, or failure is reported")
PY
"$python" minres.py
