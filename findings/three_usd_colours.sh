#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: three.js 0.187.0 and 0.170.0 (npm three).
# Expected: the loader for USD of three.js shows the colours that a mesh has at its vertices, as
# `primvars:displayColor` with the interpolation "vertex", which its own exporter writes.
# Seen: version 187 paints the whole mesh with the colour of the first vertex, and says nothing. Version
# 170 shows no colours, and no mesh at all that is not inside of another prim.
# Met: painted surfaces in USD files; the program puts its mesh into an Xform.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm install --silent --no-audit --no-fund new@npm:three@0.187.0 old@npm:three@0.170.0 >/dev/null

cat >show.mjs <<'JS'
import { readFileSync } from "node:fs";

const mesh = `def Mesh "mesh"
{
    point3f[] points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
    int[] faceVertexCounts = [4]
    int[] faceVertexIndices = [0, 1, 2, 3]
    color3f[] primvars:displayColor = [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0)] (
        interpolation = "vertex"
    )
}
`;
const files = { "on its own": mesh, "in an Xform": `def Xform "root"\n{\n${mesh}}\n` };
for (const version of ["old", "new"]) {
  const folder = `./node_modules/${version}`, add = `${folder}/examples/jsm`;
  const { zipSync } = await import(`${add}/libs/fflate.module.js`);
  const name = version === "old" ? "USDZLoader" : "USDLoader";
  const Loader = (await import(`${add}/loaders/${name}.js`))[name];
  console.log("three", JSON.parse(readFileSync(`${folder}/package.json`)).version);
  for (const [where, body] of Object.entries(files)) {
    const text = new TextEncoder().encode(`#usda 1.0\n(\n    upAxis = "Y"\n)\n\n${body}`);
    const seen = [];
    new Loader().parse(zipSync({ "a.usda": text }, { level: 0 }).buffer).traverse(object => {
      const { geometry, material } = object;
      if (geometry) seen.push(`${geometry.attributes.position.count} corners, `
        + `#${material.color.getHexString()}, colours of vertices ${material.vertexColors}`);
    });
    console.log(`  ${where}: ${seen[0] ?? "no mesh"}`);
  }
}
JS
sed -i "s/from 'three'/from '..\/..\/..\/build\/three.module.js'/" \
  node_modules/{old,new}/examples/jsm/loaders/USD*.js
find node_modules/new/examples/jsm/loaders/usd -name '*.js' -exec \
  sed -i "s/from 'three'/from '..\/..\/..\/..\/build\/three.module.js'/" {} +
cat >wanted <<'TEXT'
three 0.170.0
  on its own: no mesh
  in an Xform: 6 corners, #ffffff, colours of vertices false
three 0.187.0
  on its own: 6 corners, #ff0000, colours of vertices false
  in an Xform: 6 corners, #ff0000, colours of vertices false
TEXT

node show.mjs | tee seen
diff wanted seen
