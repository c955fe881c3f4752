#!/usr/bin/env bash
# HDF5 -> h5wasm and jsfive: 12-bit numbers come back 16 times too large, and negative ones as 4095.
source "$(dirname "${BASH_SOURCE[0]}")/fetch.sh"

cat <<'TEXT'
Belief: a reader that opens an HDF5 data set of integers gives its numbers, whatever precision and bit offset its type has, or refuses it.
Why:    both are part of the type in the file (12-bit detectors use them), and h5wasm is the HDF5 library itself, compiled.
TEXT
fetch_debian python3-h5py=3.7.0-8 python3-h5py-serial=3.7.0-8 hdf5-tools=1.10.8+repack1-1 python3-numpy=1:1.24.2-1+deb12u1
fetch_npm h5wasm@0.10.3 jsfive@0.4.2
cat >write.py <<'PY'
import h5py
import numpy

numbers = numpy.arange(-3, 4, dtype="i2")
with h5py.File("detector.h5", "w") as file:
    for name, offset in (("low_bits", 0), ("high_bits", 4)):
        kind = h5py.h5t.STD_I16LE.copy()
        kind.set_precision(12)
        kind.set_offset(offset)
        data = h5py.h5d.create(file.id, name.encode(), kind, h5py.h5s.create_simple(numbers.shape))
        data.write(h5py.h5s.ALL, h5py.h5s.ALL, numbers)
PY
"$python" write.py
echo "Seen:   signed 12-bit numbers in 16 bits, in the low and in the high ones, written by h5py 3.7.0"
for set in low_bits high_bits; do
  echo "        h5dump $(h5dump --version | sed 's/.*Version //')  $set: $(h5dump -y -d "$set" detector.h5 | sed -n '/DATA {/,/}/p' | tr -d '\n' | sed 's/ *DATA { *//; s/ *}.*//')"
done
cat >read.mjs <<'JS'
import fs from "node:fs";
import { createRequire } from "node:module";
import h5wasm from "h5wasm/node";
await h5wasm.ready;
const version = (name) => JSON.parse(fs.readFileSync(`node_modules/${name}/package.json`)).version;
const bytes = fs.readFileSync("detector.h5");
const jsfive = createRequire(import.meta.url)("jsfive");
const five = new jsfive.File(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), "detector.h5");
const wasm = new h5wasm.File("detector.h5", "r");
let wrong = 0;
for (const set of ["low_bits", "high_bits"])
  for (const [name, file] of [["h5wasm", wasm], ["jsfive", five]]) {
    const numbers = Array.from(file.get(set).value);
    console.log(`        ${name} ${version(name)}  ${set}: ${numbers.join(", ")}`);
    if (numbers.some((value, i) => value !== i - 3)) ++wrong;
  }
wasm.close();
console.log("So:     both take the 16 bits as they lie in the file. In the low bits only the negative numbers are wrong: dark pixels turn bright.");
console.log("Cure:   write whole 8, 16 or 32-bit types (h5py: astype before create_dataset); gzip with shuffle packs the idle bits as well.");
if (wrong !== 4) {
  console.log(`no longer so: ${4 - wrong} of 4 are right`);
  process.exit(1);
}
JS
node read.mjs
