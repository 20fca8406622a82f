#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: three.js 0.187.0 (npm three), loaders.gl 4.4.5 (npm @loaders.gl/core, @loaders.gl/ply).
# Expected: the PLY loaders, which split a quadrilateral into two triangles, split a face of five corners
# into three, or fail.
# Seen: both leave out each face of more than four corners without a word: a dodecahedron arrives as
# twenty points with no face. vtk.js 37.4.3 (npm @kitware/vtk.js) keeps them.
# Met: this program writes the polygons of the file that it reads.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm install --silent --no-audit --no-fund --legacy-peer-deps three@0.187.0 \
  @loaders.gl/core@4.4.5 @loaders.gl/ply@4.4.5 @kitware/vtk.js@37.4.3 >/dev/null

cat >polygons.mjs <<'JS'
import { parse } from "@loaders.gl/core";
import { PLYLoader as Loader } from "@loaders.gl/ply";
import { PLYLoader } from "three/examples/jsm/loaders/PLYLoader.js";

globalThis.window = globalThis;
const { default: Reader } = await import("@kitware/vtk.js/IO/Geometry/PLYReader.js");

for (const corners of [3, 4, 5, 6]) {
  const ids = [...Array(corners).keys()];
  const circle = ids.map(i => [Math.cos, Math.sin].map(f => f(2 * Math.PI * i / corners)) + "");
  const text = `ply
format ascii 1.0
element vertex ${corners}
property float x
property float y
property float z
element face 1
property list uchar int vertex_indices
end_header
${circle.map(point => point.replace(",", " ") + " 0\n").join("")}${corners} ${ids.join(" ")}
`;
  const bytes = new TextEncoder().encode(text).buffer;
  const reader = Reader.newInstance();
  reader.parseAsText(text);
  const seen = {
    "three.js": new PLYLoader().parse(text).index?.count ?? 0,
    "loaders.gl": (await parse(bytes, Loader, { worker: false })).indices?.value.length ?? 0,
  };
  for (const name in seen)
    seen[name] = `${seen[name] / 3} triangles`;
  const kept = reader.getOutputData().getPolys().getData()[0];
  console.log(`${corners} corners:`, ...Object.entries(seen).map(x => x.join(" ") + ","), `vtk.js ${kept} corners`);
}
JS
cat >wanted <<'TEXT'
3 corners: three.js 1 triangles, loaders.gl 1 triangles, vtk.js 3 corners
4 corners: three.js 2 triangles, loaders.gl 2 triangles, vtk.js 4 corners
5 corners: three.js 0 triangles, loaders.gl 0 triangles, vtk.js 5 corners
6 corners: three.js 0 triangles, loaders.gl 0 triangles, vtk.js 6 corners
TEXT

node polygons.mjs | tee seen
diff wanted seen
