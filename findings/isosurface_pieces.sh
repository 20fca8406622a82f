#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: isosurface 1.0.0 (npm).
# Expected: its three methods give a closed surface of a ball, with its normals outward.
# Seen: surfaceNets does. The surfaces of marchingCubes and marchingTetrahedra have vertices of their own
# in each cell, so that every cell is a piece with a boundary.
# Met: surfaces from volumes. A piece has no handles, no curvature at its boundary and no room for rho.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm install --silent --no-audit --no-fund isosurface@1.0.0 >/dev/null

cat >pieces.mjs <<'JS'
import isosurface from "isosurface";

const ball = (x, y, z) => x * x + y * y + z * z - 1, box = [[-1.5, -1.5, -1.5], [1.5, 1.5, 1.5]];
for (const method of ["surfaceNets", "marchingCubes", "marchingTetrahedra"]) {
  const { positions, cells } = isosurface[method]([20, 20, 20], ball, box);
  const edges = new Set(cells.flatMap(c => c.map((v, i) => `${v} ${c[(i + 1) % c.length]}`)));
  const open = [...edges].filter(e => !edges.has(e.split(" ").reverse().join(" "))).length;
  const places = new Set(positions.map(p => p.map(x => x.toFixed(9)).join()));
  console.log(`${method}: ${positions.length} vertices at ${places.size} places, ${cells.length} faces, ${open} edges at a boundary`);
}
JS
cat >wanted <<'TEXT'
surfaceNets: 824 vertices at 824 places, 1644 faces, 0 edges at a boundary
marchingCubes: 3288 vertices at 822 places, 1640 faces, 3288 edges at a boundary
marchingTetrahedra: 12680 vertices at 2498 places, 3844 faces, 12680 edges at a boundary
TEXT

node pieces.mjs | tee seen
diff wanted seen
