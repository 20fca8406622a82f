#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: webgl-obj-loader 2.0.8, three.js 0.187.0 (npm webgl-obj-loader, three).
# Expected: an OBJ file whose faces count vertices back from the last one, as the format allows, is read as its
# twin with numbers from the first one, or refused.
# Seen: all coordinates are NaN, the faces are there, and no error is reported. three.js reads both alike.
# Met: OBJ files that are written piece by piece; this program reads them, and writes numbers from the first.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm install --silent --no-audit --no-fund webgl-obj-loader@2.0.8 three@0.187.0 >/dev/null

cat >read.mjs <<'JS'
import loader from "webgl-obj-loader";
import { REVISION } from "three";
import { OBJLoader } from "three/examples/jsm/loaders/OBJLoader.js";

const points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
const files = { "from the first": points + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n",
                "from the last": points + "f -4 -2 -3\nf -4 -3 -1\nf -3 -2 -1\nf -4 -1 -2\n" };
console.log("three", REVISION);
for (const [name, text] of Object.entries(files)) {
  const mesh = new loader.Mesh(text), three = new OBJLoader().parse(text).children[0].geometry;
  const finite = array => Array.from(array).filter(Number.isFinite).length + " of " + array.length;
  console.log(`${name}: webgl-obj-loader ${mesh.indices.length / 3} faces, finite coordinates`,
    `${finite(mesh.vertices)}; three.js ${finite(three.attributes.position.array)}`);
}
JS
cat >wanted <<'TEXT'
three 187
from the first: webgl-obj-loader 4 faces, finite coordinates 12 of 12; three.js 36 of 36
from the last: webgl-obj-loader 4 faces, finite coordinates 0 of 12; three.js 36 of 36
TEXT

node read.mjs | tee seen
diff wanted seen
