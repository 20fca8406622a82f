#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: three.js 0.187.0 (npm three).
# Expected: the VTK loader of three.js reads a binary file of the older format with points of doubles, as
# VTK writes it for them, or refuses it.
# Seen: it takes each half of a double for a float: the first of four points, (1/3, 0, 0), arrives as
# (1.67, 1.5e13, 0), no error is reported, and the faces are right. The same file with floats is read.
# Met: the program's VTK files have doubles in this format; its glTF files have floats.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm install --silent --no-audit --no-fund three@0.187.0 >/dev/null

cat >doubles.mjs <<'JS'
import { REVISION } from "three";
import { VTKLoader } from "three/examples/jsm/loaders/VTKLoader.js";

const points = [1 / 3, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1];
const faces = [3, 0, 2, 1, 3, 0, 1, 3, 3, 1, 2, 3, 3, 0, 3, 2];
const bytes = (numbers, size, write) => {
  const buffer = Buffer.alloc(size * numbers.length);
  numbers.forEach((number, i) => buffer[write](number, size * i));
  return buffer;
};
const file = (type, size, write) => Buffer.concat([
  Buffer.from("# vtk DataFile Version 3.0\n" + "a tetrahedron ".repeat(10) +
    `\nBINARY\nDATASET POLYDATA\nPOINTS 4 ${type}\n`), bytes(points, size, write),
  Buffer.from("\nPOLYGONS 4 16\n"), bytes(faces, 4, "writeInt32BE"), Buffer.from("\n")]);
console.warn = () => {};  // that the loader goes with release 194
console.log("three", REVISION);
for (const [type, content] of [["float", file("float", 4, "writeFloatBE")],
                               ["double", file("double", 8, "writeDoubleBE")]]) {
  const geometry = new VTKLoader().parse(new Uint8Array(content).buffer);
  const [x, y, z] = geometry.attributes.position.array;
  console.log(`${type}: ${geometry.index.count / 3} faces, first point`,
    x.toPrecision(3), y.toPrecision(3), z.toPrecision(3));
}
JS
cat >wanted <<'TEXT'
three 187
float: 4 faces, first point 0.333 0.00 0.00
double: 4 faces, first point 1.67 1.47e+13 0.00
TEXT

node doubles.mjs | tee seen
diff wanted seen
