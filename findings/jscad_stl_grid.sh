#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: JSCAD's STL reader 2.1.30 (npm @jscad/stl-deserializer).
# Expected: a coordinate of an STL file is read as it stands there, or as the nearest float.
# Seen: each coordinate of a text file is moved away from zero to the next multiple of 1e-5, so that a
# model that measures millimetres in metres is off by a percent and one of micrometres is a cube. Binary
# files are read as they are.
# Met: small or normalised surfaces in STL.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm install --silent --no-audit --no-fund @jscad/stl-deserializer@2.1.30 >/dev/null

cat >grid.mjs <<'JS'
import { deserialize } from "@jscad/stl-deserializer";

for (const x of [0.5, 0.123456789, -0.123456789, 0.000123456, 0.0000001]) {
  const text = `solid s
facet normal 0 0 1
outer loop
vertex ${x.toFixed(9)} 0 0
vertex 1 0 0
vertex 0 1 0
endloop
endfacet
endsolid s
`;
  const binary = Buffer.alloc(134);
  binary.writeUInt32LE(1, 80);
  [0, 0, 1, x, 0, 0, 1, 0, 0, 0, 1, 0].forEach((y, i) => binary.writeFloatLE(y, 84 + 4 * i));
  const first = data => [deserialize({ output: "geometry" }, data)].flat()[0].polygons[0].vertices
    .flat().find(y => y !== 0 && y !== 1);
  console.log(`${x.toFixed(9)}: text ${first(text).toPrecision(8)}, binary ${first(binary).toPrecision(8)}`);
}
JS
cat >wanted <<'TEXT'
WANTED
TEXT

node grid.mjs | tee seen
diff wanted seen
