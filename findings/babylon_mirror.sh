#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: Babylon.js 9.28.0 (npm @babylonjs/core, @babylonjs/loaders, @babylonjs/serializers).
# Expected: a surface that is loaded from a GLB file is exported congruent to what it was, its outside
# outside, in any format.
# Seen: in a scene as it is by default, the OBJ file is the mirror image, and the faces of the STL file
# look inwards (its volume is negative). GLB is right, and so is OBJ if positions in the world are asked
# for. The loader mirrors by a node, as the scene is left-handed, and each exporter mirrors once more: OBJ
# does so without that node, STL with it, but not the order of the corners.
# Met: a surface as seen on a page, exported there: the sign of the mean curvature and of rho, and on which
# side something is.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm install --silent --no-audit --no-fund --legacy-peer-deps @babylonjs/core@9.28.0 \
  @babylonjs/loaders@9.28.0 @babylonjs/serializers@9.28.0 >/dev/null

cat >mirror.mjs <<'JS'
globalThis.XMLHttpRequest = class {};
const B = await import("@babylonjs/core/index.js");
await import("@babylonjs/loaders/glTF/index.js");
const { OBJExport, STLExport, GLTF2Export } = await import("@babylonjs/serializers/index.js");

const corners = [[0, 0, 0], [3, 0, 0], [0, 2, 0], [0, 0, 1]];
const faces = [0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2];

function glb()
{
  const binary = Buffer.concat([Buffer.from(new Float32Array(corners.flat()).buffer),
    Buffer.from(new Uint32Array(faces).buffer)]);
  let json = JSON.stringify({ asset: { version: "2.0" }, scene: 0, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }], buffers: [{ byteLength: 96 }],
    bufferViews: [{ buffer: 0, byteLength: 48 }, { buffer: 0, byteOffset: 48, byteLength: 48 }],
    accessors: [{ bufferView: 0, componentType: 5126, count: 4, type: "VEC3", min: [0, 0, 0], max: [3, 2, 1] },
      { bufferView: 1, componentType: 5125, count: 12, type: "SCALAR" }] });
  json += " ".repeat(-json.length & 3);
  const head = Buffer.alloc(20), chunk = Buffer.alloc(8);
  [0x46546c67, 2, 28 + json.length + 96, json.length, 0x4e4f534a].forEach((x, i) => head.writeUInt32LE(x, 4 * i));
  [96, 0x4e4942].forEach((x, i) => chunk.writeUInt32LE(x, 4 * i));
  return new Uint8Array(Buffer.concat([head, Buffer.from(json), chunk, binary]));
}
// Six times the volume, by the order of the corners.
const determinant = ([a, b, c]) => a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
  + a[2] * (b[0] * c[1] - b[1] * c[0]);
function told(name, points, triangles)
{
  // The edges from the right angle, the longest first: 6 in the input, -6 in a mirror image.
  const square = (p, q) => p.reduce((sum, x, i) => sum + (x - q[i]) ** 2, 0);
  const unique = [...new Map(points.map(p => [p.map(x => x || 0) + "", p])).values()];
  const origin = unique.find(p => !unique.some(q => ![0, 1, 4, 9].includes(Math.round(square(p, q)))));
  const edges = unique.filter(p => p != origin).sort((p, q) => square(q, origin) - square(p, origin))
    .map(p => p.map((x, i) => x - origin[i]));
  const volume = triangles.reduce((sum, triangle) => sum + determinant(triangle), 0);
  console.log(`${name}: ${determinant(edges) > 0 ? "congruent" : "mirror image"}, volume ${volume > 0 ? "positive" : "negative"}`);
}
const three = points => [...Array(points.length / 3).keys()].map(i => points.slice(3 * i, 3 * i + 3));
const numbers = (text, pattern) => [...text.matchAll(pattern)].map(match => match.slice(1, 4).map(Number));

async function scene(use)
{
  const s = new B.Scene(new B.NullEngine());
  await B.AppendSceneAsync(glb(), s, { pluginExtension: ".glb" });
  return use(s.meshes.filter(mesh => mesh.getTotalVertices() > 0), s);
}
function obj(name, text)
{
  const points = numbers(text, /^v (\S+) (\S+) (\S+)/gm);
  told(name, points, numbers(text, /^f (\d+)\S* (\d+)\S* (\d+)/gm).map(face => face.map(i => points[i - 1])));
}
console.log("Babylon.js", B.Engine.Version);
told("input", corners, three(faces.map(i => corners[i])));
await scene(meshes => obj("OBJ", OBJExport.OBJ(meshes)));
await scene(meshes => obj("OBJ, positions in the world", OBJExport.OBJ(meshes, false, "", true)));
await scene(meshes => {
  const points = numbers(STLExport.CreateSTL(meshes, false, "x"), /vertex (\S+) (\S+) (\S+)/g);
  told("STL", points, three(points));
});
await scene(async (meshes, s) => {
  const file = Object.values((await GLTF2Export.GLBAsync(s, "x")).files)[0];
  const bytes = Buffer.from(await file.arrayBuffer());
  const json = JSON.parse(bytes.subarray(20, 20 + bytes.readUInt32LE(12)));
  const end = json.accessors.find(accessor => accessor.max).max;
  console.log(`GLB: nodes ${JSON.stringify(json.nodes)}, positions up to ${end}`);
});
process.exit(0);
JS
cat >wanted <<'TEXT'
Babylon.js 9.28.0
input: congruent, volume positive
OBJ: mirror image, volume positive
OBJ, positions in the world: congruent, volume positive
STL: congruent, volume negative
GLB: nodes [{"name":"node0","mesh":0}], positions up to 3,2,1
TEXT

node mirror.mjs | grep -v '^BJS' | tee seen
diff wanted seen
