#!/usr/bin/env bash
# Open MPI: whether MPI_MAX keeps a NaN depends on the rank that has it, on the length of the message and on the place in it.
source "$(dirname "${BASH_SOURCE[0]}")/fetch.sh"

cat <<'TEXT'
Belief: a solver takes the largest residual of all ranks with MPI_Allreduce(MPI_MAX). If one rank has NaN, every rank sees NaN, and the
        run stops. At the least, every rank sees the same number, and it does not matter which rank went wrong.
Why:    a maximum does not depend on the order of its arguments, and MPI calls MPI_MAX commutative and associative.
TEXT
fetch_debian openmpi-bin=4.1.4-3+b1 libopenmpi3=4.1.4-3+b1 python3-mpi4py=3.1.4-2+b2 python3-numpy=1:1.24.2-1+deb12u1
cat >max.py <<'PY'
import sys

import numpy
from mpi4py import MPI

world = MPI.COMM_WORLD
if world.rank == 0:
    print("Seen:  ", MPI.Get_library_version().split(",")[0], "- two ranks, rank r has r + 1 everywhere, one of them NaN everywhere")
    print("        length  rank with NaN  NaN in the maximum on rank 0, on rank 1")
seen = {}
for length in (1, 2, 3, 7, 8, 17):
    for wrong in (0, 1):
        mine = numpy.full(length, float(world.rank + 1) if world.rank != wrong else numpy.nan)
        largest = numpy.empty(length)
        world.Allreduce(mine, largest, op=MPI.MAX)
        counts = world.allgather(int(numpy.isnan(largest).sum()))
        seen[length, wrong] = counts
        if world.rank == 0:
            print(f"        {length:6}  {wrong:13}  {counts[0]} of {length}, {counts[1]} of {length}")
lost = [key for key, counts in seen.items() if min(counts) < key[0]]
by_rank = [length for length in (1, 2, 3, 7, 8, 17) if seen[length, 0] != seen[length, 1]]
if world.rank == 0:
    print(f"So:     the NaN is lost, whole or in part, in {len(lost)} of {len(seen)} cases; who had it decides in {len(by_rank)} of 6 lengths.")
    print("Cure:   reduce a count of bad values with MPI_SUM beside the maximum, or test for NaN before the reduction.")
sys.exit(0 if lost and by_rank else "no longer so: the NaN always arrives")
PY
mpirun_here 2 --bind-to none "$python" max.py
