#!/usr/bin/env bash
# h5diff: a data set that lost two rows, or became integer, counts as no difference: exit 0.
source "$(dirname "${BASH_SOURCE[0]}")/fetch.sh"

cat <<'TEXT'
Belief: h5diff old.h5 new.h5 in a regression test exits with 1 when the result changed its shape or its type.
Why:    one number off by one gives 1, so does a missing data set; results that cannot even be compared are further apart.
TEXT
fetch_debian hdf5-tools=1.10.8+repack1-1 python3-h5py=3.7.0-8 python3-h5py-serial=3.7.0-8 python3-numpy=1:1.24.2-1+deb12u1
cat >write.py <<'PY'
import h5py
import numpy

force = numpy.arange(12.0)
other = force.copy()
other[5] += 1
for name, data in (
    ("old", force),
    ("value", other),
    ("shorter", force[:10]),
    ("folded", force.reshape(3, 4) + 7),
    ("whole", force.astype("i4") + 7),
    ("text", force.astype("S8")),
):
    with h5py.File(f"{name}.h5", "w") as file:
        file["force"] = data
with h5py.File("missing.h5", "w") as file:
    file["displacement"] = force
PY
"$python" write.py
echo "Seen:   $(h5diff --version); old.h5 has 12 numbers in double precision"
declare -A code
row() {
  code[$1]=0
  h5diff old.h5 "$1.h5" >/dev/null 2>&1 || code[$1]=$?
  printf '        %-52s exit %s\n' "$2" "${code[$1]}"
}
row value "one number off by one"
row missing "the data set has another name"
row shorter "two numbers lost at the end"
row folded "3 x 4 instead of 12, and every number 7 larger"
row whole "int32 instead of double, and every number 7 larger"
row text "text instead of numbers"
echo "So:     the more it differs the less it counts: h5diff says 'Some objects are not comparable' on its output and exits with 0."
echo "Cure:   fail the test when the output has 'not comparable', or compare shape and type first."
[ "${code[value]}" = 1 ] && [ "${code[shorter]}${code[folded]}${code[whole]}${code[text]}" = 0000 ] || {
  echo "no longer so"
  exit 1
}
