#!/usr/bin/env bash
# Open MPI: two runs started side by side are both tied to the first core, and the others stand idle.
source "$(dirname "${BASH_SOURCE[0]}")/fetch.sh"

cat <<'TEXT'
Belief: a study starts as many small MPI runs as the machine has cores, and each of them gets a core.
Why:    without MPI the kernel spreads two busy processes over two idle cores, and neither run knows less about the cores than the kernel.
TEXT
cores=$(nproc)
[ "$cores" -ge 2 ] || cannot_check "this machine offers one core only"
fetch_debian openmpi-bin=4.1.4-3+b1 libopenmpi3=4.1.4-3+b1
work='echo "may use core(s) $(sed -n "s/^Cpus_allowed_list:\s*//p" /proc/self/status)"; sleep 3'

echo "Seen:   $("$root/usr/bin/mpirun.openmpi" --version | head -1), $cores cores"
echo "        two runs of one rank, started together:"
for run in 1 2; do mpirun_here 1 bash -c "$work" >run$run 2>&1 & done
wait
sed 's/^/          /' run1 run2
echo "        the same with --bind-to none:"
for run in 1 2; do mpirun_here 1 --bind-to none bash -c "$work" >free$run 2>&1 & done
wait
sed 's/^/          /' free1 free2
first=$(sed -n 's/.*core(s) //p' run1)
second=$(sed -n 's/.*core(s) //p' run2)
echo "Cure:   give --bind-to none to small runs side by side, or a --cpu-set of its own to each."
if ! [[ $first =~ ^[0-9]+$ ]] || [ "$first" != "$second" ]; then
  echo "no longer so: the two runs have core(s) $first and $second"
  exit 1
fi
echo "So:     both runs share core $first; the kernel may not move either of them to an idle one."
