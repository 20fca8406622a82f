#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: Manifold 3.5.4 (npm manifold-3d).
# Expected: the mean curvature of a unit sphere by calculateCurvature() is 1, and so is the Gaussian one.
# Seen: the mean curvature is 2. It is the sum of the principal curvatures, as the text of the declaration says,
# not their mean; the Gaussian one is 1.
# Met: mean curvature as input, as a check, or as rho: a change by it is twice what is meant.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm install --silent --no-audit --no-fund manifold-3d@3.5.4 >/dev/null

cat >curvature.mjs <<'JS'
import { readFileSync } from "fs";
import Module from "manifold-3d";

const manifold = await Module();
manifold.setup();
console.log("Manifold", JSON.parse(readFileSync("node_modules/manifold-3d/package.json")).version);
for (const radius of [1, 2]) {
  const mesh = manifold.Manifold.sphere(radius, 128).calculateCurvature(0, 1).getMesh();
  const mean = channel => {
    let sum = 0;
    for (let v = 0; v < mesh.numVert; ++v) sum += mesh.vertProperties[v * mesh.numProp + 3 + channel];
    return (sum / mesh.numVert).toFixed(3);
  };
  console.log(`radius ${radius}, ${mesh.numVert} vertices: Gaussian ${mean(0)}, mean ${mean(1)}`);
}
JS
cat >wanted <<'TEXT'
Manifold 3.5.4
radius 1, 4098 vertices: Gaussian 1.000, mean 2.000
radius 2, 4098 vertices: Gaussian 0.250, mean 1.000
TEXT

node curvature.mjs | tee seen
diff wanted seen
