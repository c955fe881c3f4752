#!/usr/bin/env bash
# CalculiX: a voxel that hangs on nothing falls by thousands of kilometres, and the job is finished with exit 0.
source "$(dirname "${BASH_SOURCE[0]}")/fetch.sh"

cat <<'TEXT'
Belief: a voxel that hangs on nothing, under gravity, makes a static step of ccx stop with an error. Should the iterative solver run
        into it, it says that it did not converge.
Why:    the load on the loose voxel has no answer, and ccx prints the error that it has and the limit that it should come below.
TEXT
fetch_debian calculix-ccx=2.20-1
deck() { # deck SOLVER: a held cube and a loose one (elements of one voxel, mm, N, t)
  cat <<INP
*NODE
1, 0., 0., 0.
2, 1., 0., 0.
3, 0., 1., 0.
4, 1., 1., 0.
5, 0., 0., 1.
6, 1., 0., 1.
7, 0., 1., 1.
8, 1., 1., 1.
9, 4., 0., 0.
10, 5., 0., 0.
11, 5., 1., 0.
12, 4., 1., 0.
13, 4., 0., 1.
14, 5., 0., 1.
15, 5., 1., 1.
16, 4., 1., 1.
*ELEMENT, TYPE=C3D8, ELSET=ALL
1, 1, 2, 4, 3, 5, 6, 8, 7
2, 9, 10, 11, 12, 13, 14, 15, 16
*MATERIAL, NAME=STONE
*ELASTIC
10000., 0.2
*DENSITY
1.E-3
*SOLID SECTION, ELSET=ALL, MATERIAL=STONE
*NSET, NSET=HELD
1, 2, 3, 4
*NSET, NSET=SEEN
5, 13
*STEP
*STATIC, SOLVER=$1
*BOUNDARY
HELD, 1, 3, 0.
*DLOAD
ALL, GRAV, 9.81, 0., 0., -1.
*NODE PRINT, NSET=SEEN
U
*END STEP
INP
}
echo "Seen:   ccx $(ccx -v 2>/dev/null | sed -n 's/.*Version //p' | head -1); vertical displacement of a corner of the held voxel and of the loose one"
declare -A held loose
fine=yes
for solver in "SPOOLES" "ITERATIVE SCALING"; do
  deck "$solver" >loose.inp
  rm -f loose.dat
  code=0
  OMP_NUM_THREADS=1 timeout 300 ccx -i loose 2>&1 | tail -60 >tail.txt || code=$?
  held[$solver]=$(awk '$1 == 5 {print $4}' loose.dat)
  loose[$solver]=$(awk '$1 == 13 {print $4}' loose.dat)
  grep -q 'Job finished' tail.txt && [ "$code" = 0 ] || fine=no
  echo "        $solver: exit $code, $(sed -n 's/^ *\(Job finished\)/\1/p' tail.txt); held ${held[$solver]} mm, loose ${loose[$solver]} mm"
  sed -n -e '/^iteration/h' -e '/^error condition/{x;p;x;p;}' tail.txt | sed 's/^/          /'
done
echo "So:     a part of the picture that was cut off is seen only by who looks at its nodes. The conjugate gradients cannot converge, spoil"
echo "        the displacements of the part that is held as well, and say 'good' when their iterations are used up."
echo "Cure:   drop every part that does not hang together with a held node before the deck is written."
far() { awk -v u="$1" 'BEGIN {exit !(u * u > 1e12)}'; }
[ $fine = yes ] && far "${loose[SPOOLES]}" && far "${loose[ITERATIVE SCALING]}" || {
  echo "no longer so"
  exit 1
}
