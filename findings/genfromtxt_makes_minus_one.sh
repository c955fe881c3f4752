#!/usr/bin/env bash
# NumPy: genfromtxt(dtype=int) reads "3.0" and "1e3" as -1 without a word.
source "$(dirname "${BASH_SOURCE[0]}")/fetch.sh"

cat <<'TEXT'
Belief: genfromtxt(dtype=int) on a table of labels reads 3.0 as 3, as loadtxt does, or raises an error.
Why:    a number that is there is not a missing one, and int("3.0") is an error in Python.
TEXT
fetch_debian python3-numpy=1:1.24.2-1+deb12u1
cat >labels.py <<'PY'
import sys
import warnings

import numpy

table = ["0 3 3.0", "1 2 1e3", "2 1 2.5"]
print(f"Seen:   NumPy {numpy.__version__}, rows: {'; '.join(table)}")
for reader in (numpy.loadtxt, numpy.genfromtxt):
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        read = reader(table, dtype=int)
    rows = "; ".join(" ".join(map(str, row)) for row in read)
    print(f"        {reader.__name__ + '(dtype=int):':24} {rows}   warnings: {len(said)}")
print("So:     what int() cannot read counts as missing, and missing whole numbers become -1: often the label of the background.")
print("Cure:   read as float and compare with the rounded numbers before astype(int).")
sys.exit(0 if (read[:, 2] == -1).all() and not said else "no longer so: the numbers are read or refused")
PY
"$python" labels.py
