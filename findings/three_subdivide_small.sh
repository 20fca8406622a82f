#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: three-subdivide 1.1.5, three.js 0.170.0 (npm).
# Expected: one step of Loop's scheme on a sphere of radius r gives r times what it gives on the unit
# sphere.
# Seen: from r = 0.01 on the vertices are elsewhere, by up to a fifth of the radius, without a word:
# vertices whose coordinates agree to three places after the point count as one when neighbours are
# looked up.
# Met: subdivided surfaces have dents that were not there, and curvature.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm install --silent --no-audit --no-fund three-subdivide@1.1.5 three@0.170.0 >/dev/null

cat >subdivide.mjs <<'JS'
import { IcosahedronGeometry } from "three";
import { LoopSubdivision } from "three-subdivide";

for (const r of [1, 0.1, 0.01, 0.001]) {
  const points = LoopSubdivision.modify(new IcosahedronGeometry(r, 2), 1, { split: false }).attributes.position;
  const radii = [...Array(points.count).keys()].map(i =>
    Math.hypot(points.getX(i), points.getY(i), points.getZ(i)) / r);
  console.log(`r = ${r}: ${points.count / 3} triangles, radii`,
    `${Math.min(...radii).toFixed(3)} r to ${Math.max(...radii).toFixed(3)} r`);
}
JS
cat >wanted <<'TEXT'
r = 1: 720 triangles, radii 0.968 r to 0.974 r
r = 0.1: 720 triangles, radii 0.968 r to 0.974 r
r = 0.01: 720 triangles, radii 0.848 r to 0.968 r
r = 0.001: 720 triangles, radii 0.749 r to 0.766 r
TEXT

node subdivide.mjs | tee seen
diff wanted seen
