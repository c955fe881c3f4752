#!/usr/bin/env bash
# Teem -> three.js: NRRDLoader ignores "endian: big" and gives other grey values.
source "$(dirname "${BASH_SOURCE[0]}")/fetch.sh"

cat <<'TEXT'
Belief: three.js reads the same volume from a NRRD whether its header says "endian: little" or "endian: big".
Why:    the field stands in the header for this and nothing else, and the loader reads the header.
TEXT
fetch_debian teem-apps=1.12.0~20160122-5
fetch_npm three@0.187.0
cat >volume.mjs <<'JS'
import fs from "node:fs";
const scan = new Int16Array(4 * 4 * 4).map((_, i) => 10 * i - 100);
fs.writeFileSync("scan.raw", scan);
JS
node volume.mjs
for order in little big; do
  teem-unu make -i scan.raw -t short -s 4 4 4 -e raw -en little 2>/dev/null | teem-unu save -f nrrd -e raw -en "$order" -o "scan-$order.nrrd" 2>/dev/null
  echo "Seen:   Teem writes $(grep -a endian "scan-$order.nrrd"), and reads back $(teem-unu minmax "scan-$order.nrrd" 2>/dev/null | tr '\n' ' ')"
done
cat >read.mjs <<'JS'
import fs from "node:fs";
import { REVISION } from "three";
import { NRRDLoader } from "three/examples/jsm/loaders/NRRDLoader.js";
const range = {};
for (const order of ["little", "big"]) {
  const bytes = fs.readFileSync(`scan-${order}.nrrd`);
  const volume = new NRRDLoader().parse(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
  range[order] = [volume.min, volume.max];
  console.log(`        three.js r${REVISION} reads endian ${order}: min ${volume.min} max ${volume.max}, first voxels ${volume.data.slice(0, 4).join(" ")}`);
}
console.log("So:     greys from -100 to 530 become greys over the whole range of the type; a level chosen in Teem cuts noise here.");
console.log("Cure:   teem-unu save -en little.");
if (range.little.join() !== "-100,530" || range.big.join() === "-100,530") {
  console.log("no longer so");
  process.exit(1);
}
JS
node read.mjs
