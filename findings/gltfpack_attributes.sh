#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: gltfpack 1.3.0 (npm gltfpack), glTF Transform 4.5.1 (npm @gltf-transform/core).
# Expected: gltfpack -kv, "keep source vertex attributes even if they aren't used", keeps the attributes
# of an application, whose names begin with an underscore.
# Seen: _RHO is dropped whatever the options are; a warning tells, the exit code is 0. The option is
# about texture coordinates and colours that no material uses. glTF Transform reads and writes it.
# Met: rho and quality in GLB files have no other place than such attributes.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm install --silent --no-audit --no-fund gltfpack@1.3.0 @gltf-transform/core@4.5.1 >/dev/null

cat >pack.mjs <<'JS'
import { execFileSync } from "node:child_process";
import { Document, NodeIO, VERSION } from "@gltf-transform/core";

const names = document => document.getRoot().listMeshes()[0].listPrimitives()[0].listSemantics();
const document = new Document(), buffer = document.createBuffer(), io = new NodeIO();
const accessor = (type, array) => document.createAccessor()
  .setType(type).setArray(array).setBuffer(buffer);
const primitive = document.createPrimitive()
  .setIndices(accessor("SCALAR", new Uint32Array([0, 1, 2])))
  .setAttribute("POSITION", accessor("VEC3", new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0])))
  .setAttribute("_RHO", accessor("SCALAR", new Float32Array([1, 2, 3])));
document.createScene().addChild(
  document.createNode().setMesh(document.createMesh().addPrimitive(primitive)));
await io.write("in.glb", document);
console.log(`glTF Transform ${VERSION}: ${names(await io.read("in.glb"))}`);
for (const options of [["-noq"], ["-noq", "-kv"]]) {
  execFileSync("node_modules/.bin/gltfpack", ["-i", "in.glb", "-o", "out.glb", ...options]);
  console.log(`gltfpack ${options.join(" ")}: ${names(await io.read("out.glb"))}`);
}
JS
cat >wanted <<'TEXT'
glTF Transform v4.5.1: POSITION,_RHO
gltfpack -noq: POSITION
gltfpack -noq -kv: POSITION
TEXT

node pack.mjs | tee seen
diff wanted seen
