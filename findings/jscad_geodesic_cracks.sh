#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: JSCAD 2.13.0 (npm @jscad/modeling), its OBJ writer 2.1.23 (@jscad/obj-serializer).
# Expected: geodesicSphere() is a closed surface: faces that meet have the same points.
# Seen: 92 points within 1e-9, but 132 if they are compared as numbers: each face of the icosahedron is
# divided by itself, and rounds the points of its edges its own way. The OBJ writer joins equal points
# only, so that the file has 132 vertices and a boundary along those edges. sphere() is closed.
# Met: points that differ in the last bit are a boundary; `--repair` merges equal points only.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm install --silent --no-audit --no-fund @jscad/modeling@2.13.0 @jscad/obj-serializer@2.1.23 >/dev/null

cat >sphere.mjs <<'JS'
import modeling from "@jscad/modeling";
import { serialize } from "@jscad/obj-serializer";

const { geodesicSphere, sphere } = modeling.primitives;
for (const [name, shape] of [["sphere", sphere({ radius: 1 })],
                             ["geodesicSphere", geodesicSphere({ radius: 1, frequency: 18 })]]) {
  const points = shape.polygons.flatMap(polygon => polygon.vertices);
  const near = new Set(points.map(p => p.map(x => Math.round(1e9 * x) + 0).join()));
  const lines = serialize({ triangulate: false }, shape).join("").split("\n");
  const edges = new Set(lines.filter(l => l.startsWith("f ")).flatMap(l => {
    const corners = l.trim().split(/ +/).slice(1);
    return corners.map((c, i) => `${c} ${corners[(i + 1) % corners.length]}`);
  }));
  const open = [...edges].filter(e => !edges.has(e.split(" ").reverse().join(" "))).length;
  console.log(`${name}: ${near.size} points, OBJ file with`,
    `${lines.filter(l => l.startsWith("v ")).length} vertices and ${open} edges of a boundary`);
}
JS
cat >wanted <<'TEXT'
WANTED
TEXT

node sphere.mjs | tee seen
diff wanted seen
