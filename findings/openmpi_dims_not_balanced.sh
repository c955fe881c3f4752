#!/usr/bin/env bash
# Open MPI: MPI_Dims_create gives 12 x 6 for 72 ranks, where 9 x 8 is to be had.
source "$(dirname "${BASH_SOURCE[0]}")/fetch.sh"

cat <<'TEXT'
Belief: MPI_Dims_create gives the most compact grid of ranks.
Why:    the standard asks for dimensions as close to each other as possible, and a compact grid has the shortest borders to exchange.
TEXT
fetch_debian openmpi-bin=4.1.4-3+b1 libopenmpi3=4.1.4-3+b1 python3-mpi4py=3.1.4-2+b2
cat >dims.py <<'PY'
import sys

from mpi4py import MPI


def grids(ranks, dimensions, largest):
    if dimensions == 1:
        return [(ranks,)] if ranks <= largest else []
    return [(f, *rest) for f in range(1, min(ranks, largest) + 1) if ranks % f == 0 for rest in grids(ranks // f, dimensions - 1, f)]


def border(grid):
    return sum(grid)  # border length of a square or cubic body, up to a factor: fewer cuts are better


print("Seen:  ", MPI.Get_library_version().split(",")[0])
missed = {}
for dimensions in (2, 3):
    missed[dimensions] = []
    for ranks in range(2, 1025):
        given = tuple(MPI.Compute_dims(ranks, dimensions))
        best = min(grids(ranks, dimensions, ranks), key=lambda grid: (max(grid) - min(grid), max(grid)))
        if max(given) - min(given) > max(best) - min(best):
            missed[dimensions].append((border(given) / border(best) - 1, ranks, given, best))
    print(f"        {dimensions} dimensions: not the closest for {len(missed[dimensions])} of the numbers 2 to 1024, among them")
    first = sorted(missed[dimensions], key=lambda row: row[1])[:2]
    worst = sorted(missed[dimensions], reverse=True)[:2]
    for more, ranks, given, best in sorted(set(first + worst), key=lambda row: row[1]):
        print(f"          {ranks:4} ranks: {' x '.join(map(str, given)):11} instead of {' x '.join(map(str, best)):11} {100 * more:4.1f} % more border")
print("Cure:   choose the grid by trying all divisors (it takes no time), and give it to MPI_Cart_create yourself.")
sys.exit(0 if missed[2] and missed[3] else "no longer so: all grids are the closest ones")
PY
mpirun_here 1 --bind-to none "$python" dims.py
