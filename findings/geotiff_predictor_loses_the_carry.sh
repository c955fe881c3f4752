#!/usr/bin/env bash
# libtiff -> geotiff.js: a big-endian TIFF with a predictor comes back with most of its numbers a little wrong.
source "$(dirname "${BASH_SOURCE[0]}")/fetch.sh"

cat <<'TEXT'
Belief: geotiff reads the same numbers from a TIFF whether its bytes are little or big endian, with a predictor or without.
Why:    it does so for every pair of these but one; the predictor is one subtraction, and a wrong file would be refused or plainly garbage.
TEXT
fetch_debian libtiff-tools=4.5.0-6+deb12u4
fetch_npm geotiff@3.0.5
cat >scan.mjs <<'JS'
import fs from "node:fs";
const scan = new Uint16Array(64 * 64); // a smooth slope of greys, as of a beam-hardened scan
for (let y = 0; y < 64; ++y) for (let x = 0; x < 64; ++x) scan[64 * y + x] = 20000 + 37 * x + 11 * y;
fs.writeFileSync("scan.raw", scan);
JS
node scan.mjs
raw2tiff -w 64 -l 64 -d short -M -c none scan.raw scan.tif 2>/dev/null
for order in L B; do
  for packing in zip:1 zip:2; do
    tiffcp "-$order" -c "$packing" scan.tif "scan-$order-$packing.tif"
    tiffcmp scan.tif "scan-$order-$packing.tif" >/dev/null # libtiff itself finds the same pixels in both
  done
done
cat >read.mjs <<'JS'
import fs from "node:fs";
import { fromFile } from "geotiff";
const right = new Uint16Array(fs.readFileSync("scan.raw").buffer.slice(0, 2 * 64 * 64));
const version = JSON.parse(fs.readFileSync("node_modules/geotiff/package.json")).version;
console.log(`Seen:   geotiff ${version}; 64 x 64 greys from ${right[0]} to ${right.at(-1)}, written by tiffcp of libtiff 4.5.0`);
const bad = {};
for (const order of ["L", "B"])
  for (const predictor of [1, 2]) {
    const file = await fromFile(`scan-${order}-zip:${predictor}.tif`);
    const [grey] = await (await file.getImage()).readRasters();
    let wrong = 0, least = Infinity, most = -Infinity;
    for (let i = 0; i < right.length; ++i) {
      if (grey[i] !== right[i]) ++wrong;
      least = Math.min(least, grey[i]);
      most = Math.max(most, grey[i]);
    }
    bad[order + predictor] = wrong;
    console.log(`        ${order === "L" ? "little" : "big   "} endian, ${predictor === 2 ? "with   " : "without"} predictor: ${String(wrong).padStart(4)} of 4096 wrong, from ${least} to ${most}`);
    file.close();
  }
console.log("So:     the differences are added byte by byte from the wrong end, and the carry goes astray. The picture looks like the scan, with steps.");
console.log("Cure:   tiffcp -L, or save without a predictor.");
if (bad.B2 === 0 || bad.L1 + bad.L2 + bad.B1 > 0) {
  console.log("no longer so");
  process.exit(1);
}
JS
node read.mjs
