#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: JSCAD 2.13.0 (npm @jscad/modeling), its writers for STL and OBJ 2.1.23 (@jscad/stl-
# serializer, @jscad/obj-serializer).
# Expected: the writers keep a point of a model as a double in OBJ and text, or as the nearest float in
# binary STL.
# Seen: all of them move each point to a grid whose step is 1e-5 of the mean size of the model. Of a
# coordinate four or five digits are left, where the format has seven or seventeen, and what is smaller
# than the step becomes flat.
# Met: curvature of such a surface is noise where its edges are short: the grid tilts faces.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm install --silent --no-audit --no-fund @jscad/modeling@2.13.0 @jscad/stl-serializer@2.1.23 @jscad/obj-serializer@2.1.23 >/dev/null

cat >grid.mjs <<'JS'
import modeling from "@jscad/modeling";
import obj from "@jscad/obj-serializer";
import stl from "@jscad/stl-serializer";

const x = 0.123456789;
const shape = modeling.primitives.polyhedron({
  points: [[x, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
  faces: [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]],
});
const binary = new DataView(stl.serialize({ binary: true }, shape)[2]);
const read = {
  "in memory": shape.polygons.flatMap(polygon => polygon.vertices.flat()),
  "STL text": stl.serialize({ binary: false }, shape).join("").match(/[-.\de]+/g).map(Number).filter(isFinite),
  "STL binary": [...Array(12 * 4).keys()].map(i =>
    binary.getFloat32(50 * Math.floor(i / 12) + 4 * (i % 12), true)),
  "OBJ": obj.serialize({}, shape).join("").match(/[-.\de]+/g).map(Number).filter(isFinite),
};
for (const name in read) {
  const y = read[name].reduce((a, b) => Math.abs(a - x) < Math.abs(b - x) ? a : b);
  console.log(`${name}: ${y.toFixed(9)}, moved by ${(y - x).toExponential(1)}`);
}
JS
cat >wanted <<'TEXT'
in memory: 0.123456789, moved by 0.0e+0
STL text: 0.123460000, moved by 3.2e-6
STL binary: 0.123460002, moved by 3.2e-6
OBJ: 0.123460000, moved by 3.2e-6
TEXT

node grid.mjs | tee seen
diff wanted seen
