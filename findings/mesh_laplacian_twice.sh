#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: mesh-laplacian 1.0.0 (npm).
# Expected: the Laplacian of x^2 on a flat mesh is 2 at vertices inside, in any unit.
# Seen: it is 4: the weights are twice the cotangent weights of a third of the area. Where triangles are
# smaller than 1e-8 it is 0, because they count as thin, and no message is given.
# Met: mean curvature and Willmore energy from the Laplacian of the positions, as checks in a page.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm install --silent --no-audit --no-fund mesh-laplacian@1.0.0 >/dev/null

cat >flat.cjs <<'JS'
const laplacian = require("mesh-laplacian");

console.log("mesh-laplacian", require("mesh-laplacian/package.json").version);
for (const unit of [1, 0.01, 0.0001]) {
  const n = 6, points = [], faces = [], at = (i, j) => j * (n + 1) + i;
  for (let j = 0; j <= n; ++j)
    for (let i = 0; i <= n; ++i) points.push([unit * i, unit * j, 0]);
  for (let j = 0; j < n; ++j)
    for (let i = 0; i < n; ++i)
      faces.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
  let sum = 0;
  for (const [row, column, weight] of laplacian(faces, points))
    if (row === at(3, 3)) sum += weight * points[column][0] ** 2;
  console.log(`edges of ${unit}: the Laplacian of x^2 is ${sum.toPrecision(3)}`);
}
JS
cat >wanted <<'TEXT'
mesh-laplacian 1.0.0
edges of 1: the Laplacian of x^2 is 4.00
edges of 0.01: the Laplacian of x^2 is 4.00
edges of 0.0001: the Laplacian of x^2 is 0.00
TEXT

node flat.cjs | tee seen
diff wanted seen
