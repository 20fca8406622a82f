#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: three.js 0.187.0 and 0.170.0 (npm three).
# Expected: what the PLY loader of three.js makes of a file, its exporter takes for glTF, whatever
# number types the file has.
# Seen: 0.170.0 makes floats of doubles. 0.187.0 keeps them in a Float64Array, which the exporter for
# glTF refuses, as WebGL, which has no doubles, does.
# Met: a viewer on three.js that takes a newer release no longer shows the PLY files of this program,
# which have doubles.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm install --silent --no-audit --no-fund three@0.187.0 old@npm:three@0.170.0 >/dev/null

cat >doubles.mjs <<'JS'
const ply = kind => `ply
format ascii 1.0
element vertex 3
property ${kind} x
property ${kind} y
property ${kind} z
element face 1
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
0 1 0
3 0 1 2
`;
globalThis.FileReader = class {
  readAsArrayBuffer(blob) {
    blob.arrayBuffer().then(result => { this.result = result; this.onloadend(); });
  }
};
for (const release of ["old", "three"]) {
  const { Mesh, REVISION } = await import(release);
  const { PLYLoader } = await import(`${release}/examples/jsm/loaders/PLYLoader.js`);
  const { GLTFExporter } = await import(`${release}/examples/jsm/exporters/GLTFExporter.js`);
  for (const kind of ["float", "double"]) {
    const mesh = new Mesh(new PLYLoader().parse(ply(kind)));
    const array = mesh.geometry.attributes.position.array.constructor.name;
    const end = await new GLTFExporter().parseAsync(mesh, { binary: true })
      .then(() => "exported", error => error.message);
    console.log(`three ${REVISION}, ${kind}: ${array}, ${end}`);
  }
}
JS
cat >wanted <<'TEXT'
three 170, float: Float32Array, exported
three 170, double: Float32Array, exported
three 187, float: Float32Array, exported
three 187, double: Float64Array, THREE.GLTFExporter: Unsupported bufferAttribute component type: Float64Array
TEXT

# The old release imports itself by the name of the new one, unless it is told.
sed -i "s/'three'/'old'/" node_modules/old/examples/jsm/*/{PLYLoader,GLTFExporter,TextureUtils,BufferGeometryUtils}.js 2>/dev/null || true
node doubles.mjs | tee seen
diff wanted seen
