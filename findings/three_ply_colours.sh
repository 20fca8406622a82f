#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: three.js 0.187.0 (npm three).
# Expected: the PLY loader of three.js keeps the 256 values that a colour of one byte can have.
# Seen: 183 are left. The loader turns colours from sRGB to linear light, which needs more than eight
# bits for dark colours, and stores the result in bytes again: all of 0 to 6 becomes black, all of 7 to
# 17 becomes 13. Bytes in OBJ or glTF files are not treated so.
# Met: painted surfaces, whose dark strokes a viewer on three.js merges.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm install --silent --no-audit --no-fund three@0.187.0 >/dev/null

cat >colours.mjs <<'JS'
import { Color, REVISION, SRGBColorSpace } from "three";
import { PLYLoader } from "three/examples/jsm/loaders/PLYLoader.js";

let ply = "ply\nformat ascii 1.0\nelement vertex 256\n";
for (const name of ["x", "y", "z"]) ply += `property float ${name}\n`;
for (const name of ["red", "green", "blue"]) ply += `property uchar ${name}\n`;
ply += "end_header\n";
for (let i = 0; i < 256; ++i) ply += `0 0 0 ${i} ${i} ${i}\n`;
const colours = new PLYLoader().parse(ply).attributes.color;
const read = [...Array(256).keys()].map(i =>
  Math.round(255 * new Color().fromBufferAttribute(colours, i).getRGB({}, SRGBColorSpace).r));
console.log(`three ${REVISION}, ${colours.array.constructor.name}`);
console.log(`${new Set(read).size} of 256 values are left`);
console.log(`0 to 20 are read as ${read.slice(0, 21).join(" ")}`);
JS
cat >wanted <<'TEXT'
three 187, Uint8Array
183 of 256 values are left
0 to 20 are read as 0 0 0 0 0 0 0 13 13 13 13 13 13 13 13 13 13 13 22 22 22
TEXT

node colours.mjs | tee seen
diff wanted seen
