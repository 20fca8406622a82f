#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: normals 1.1.0 (npm).
# Expected: normals of length one for a mesh of any size.
# Seen: the unit sphere of 288 triangles has them. Of the same sphere in a tenth of the size, those of
# two thirds of the faces are zero, and in a twentieth all of them, at vertices, too: products of lengths
# below a limit that does not depend on the mesh count as zero, unless another limit is given.
# Met: a mesh in metres with edges of millimetres has no normals, and offsets along them do nothing.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm install --silent --no-audit --no-fund normals@1.1.0 >/dev/null

cat >normals.mjs <<'JS'
import normals from "normals";

// an octahedron of radius one whose faces are divided n times
function sphere(n) {
  const places = new Map(), points = [], faces = [];
  const vertex = p => {
    const length = Math.hypot(...p), key = p.join();
    if (!places.has(key)) places.set(key, points.push(p.map(x => x / length)) - 1);
    return places.get(key);
  };
  for (const a of [1, -1]) for (const b of [1, -1]) for (const c of [1, -1])
    for (let i = 0; i < n; ++i) for (let j = 0; i + j < n; ++j) {
      const at = (i, j) => vertex([a * i, b * j, c * (n - i - j)]);
      const add = face => faces.push(a * b * c > 0 ? face : face.reverse());
      add([at(i, j), at(i + 1, j), at(i, j + 1)]);
      if (i + j < n - 1) add([at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
    }
  return { points, faces };
}

const { points, faces } = sphere(6);
for (const size of [1, 0.1, 0.05]) {
  const scaled = points.map(p => p.map(x => size * x));
  const zeros = list => list.filter(v => !(Math.hypot(...v) > 0.5)).length;
  console.log(`radius ${size}: zero at ${zeros(normals.vertexNormals(faces, scaled))} of ${points.length} vertices,`,
    `${zeros(normals.faceNormals(faces, scaled))} of ${faces.length} faces`);
}
JS
cat >wanted <<'TEXT'
radius 1: zero at 0 of 146 vertices, 0 of 288 faces
radius 0.1: zero at 54 of 146 vertices, 192 of 288 faces
radius 0.05: zero at 146 of 146 vertices, 288 of 288 faces
TEXT

node normals.mjs | tee seen
diff wanted seen
