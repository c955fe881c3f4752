#!/usr/bin/env bash
# SciPy -> PETSc: a CSR matrix with repeated entries is three different matrices, and no one says so.
source "$(dirname "${BASH_SOURCE[0]}")/fetch.sh"

cat <<'TEXT'
Belief: the three arrays of a CSR matrix mean the same in SciPy and in PETSc. Entries that stand twice in a row, as finite elements
        leave them, are added up by both, or refused.
Why:    SciPy adds them, and PETSc itself adds what MatSetValues is given with ADD_VALUES.
TEXT
fetch_debian python3-petsc4py=3.18.5-1 python3-scipy=1.10.1-2
folder=$(find "$root/usr/lib/petscdir" -path '*-real/lib/python3/dist-packages' -type d | head -1)
export PYTHONPATH=$folder:$PYTHONPATH PETSC_DIR=${folder%/lib/python3/dist-packages}
cat >repeats.py <<'PY'
import sys

import numpy
import scipy
import scipy.sparse
from petsc4py import PETSc

# Three springs 1, 2, 3 in a row; every spring adds its four entries, so nodes 1 and 2 have two diagonal entries each.
rows = [[(0, 1.0), (1, -1.0)], [(0, -1.0), (1, 1.0), (1, 2.0), (2, -2.0)], [(1, -2.0), (2, 2.0), (2, 3.0), (3, -3.0)], [(2, -3.0), (3, 3.0)]]
start = numpy.cumsum([0] + [len(row) for row in rows]).astype("i4")
column = numpy.array([c for row in rows for c, _ in row], "i4")
value = numpy.array([v for row in rows for _, v in row])
print(f"Seen:   SciPy {scipy.__version__}, PETSc {'.'.join(map(str, PETSc.Sys.getVersion()))}; diagonal of three springs 1, 2, 3 in a row")
truth = scipy.sparse.csr_matrix((value, column, start), shape=(4, 4))
copied = PETSc.Mat().createAIJ((4, 4), csr=(start, column, value))
shared = PETSc.Mat().createAIJWithArrays((4, 4), (start, column, value))
move = numpy.array([0.0, 0.0, 1.0, 0.0])
diagonals, products = [], []
print(f"        {'':34}{'diagonal':24}row 2 times (0, 0, 1, 0)")
for name, matrix in (("SciPy csr_matrix", None), ("PETSc createAIJ(csr=...)", copied), ("PETSc createAIJWithArrays", shared)):
    if matrix is None:
        diagonal, product = truth.diagonal(), truth @ move
    else:
        x, y = matrix.createVecs()
        x.setArray(move)
        matrix.mult(x, y)
        diagonal, product = matrix.getDiagonal().getArray().copy(), y.getArray().copy()
    diagonals.append(diagonal)
    products.append(product[2])
    print(f"        {name:34}{str(diagonal):24}{product[2]:g}")
same = all(numpy.array_equal(d, diagonals[0]) for d in diagonals) and len(set(products)) == 1
print("So:     createAIJ keeps the last of the repeats: another stiffness. createAIJWithArrays multiplies with their sum but gives the first")
print("        as the diagonal: Jacobi then divides by a wrong number, while the matrix looks right.")
print("Cure:   matrix.sum_duplicates() in SciPy before the arrays are handed over.")
sys.exit("no longer so: all three agree" if same else 0)
PY
"$python" repeats.py
