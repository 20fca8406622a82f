#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: three.js 0.187.0 (npm three), glTF validator 2.0.0-dev.3.10 (gltf-validator).
# Expected: the exporter for glTF of three.js converts or refuses a signed 32-bit attribute: glTF has no
# such type of component.
# Seen: it writes a file with the type 5124, that of OpenGL, and tells success. Its own loader fails on
# it with a TypeError, and the validator reports an error. It reads unsigned ones, which the validator
# refuses for attributes, too.
# Met: labels of regions, with -1 for none, in GLB files.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm install --silent --no-audit --no-fund three@0.187.0 gltf-validator@2.0.0-dev.3.10 >/dev/null

cat >label.mjs <<'JS'
import { BufferAttribute, BufferGeometry, Mesh, REVISION } from "three";
import { GLTFExporter } from "three/examples/jsm/exporters/GLTFExporter.js";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import validator from "gltf-validator";

globalThis.self = globalThis;
globalThis.FileReader = class {
  readAsArrayBuffer(blob) {
    blob.arrayBuffer().then(result => { this.result = result; this.onloadend(); });
  }
};
console.log(`three ${REVISION}, validator ${validator.version()}`);
for (const labels of [new Uint32Array([0, 1, 2]), new Int32Array([0, 1, -1])]) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position",
    new BufferAttribute(new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]), 3));
  geometry.setAttribute("_label", new BufferAttribute(labels, 1));
  const glb = await new GLTFExporter().parseAsync(new Mesh(geometry), { binary: true });
  const json = JSON.parse(Buffer.from(glb, 20, new DataView(glb).getUint32(12, true)).toString());
  const type = json.accessors[json.meshes[0].primitives[0].attributes._LABEL].componentType;
  const read = await new GLTFLoader().parseAsync(glb, "").then(
    scene => "read as " + scene.scene.children[0].geometry.attributes._label.array.join(" "),
    error => "not read: " + error.name);
  const report = await validator.validateBytes(new Uint8Array(glb));
  console.log(`${labels.constructor.name}: type ${type}, ${read},`,
    `validator: ${report.issues.messages.filter(m => m.severity < 2).map(m => m.code)}`);
}
JS
cat >wanted <<'TEXT'
three 187, validator 2.0.0-dev.3.10
Uint32Array: type 5125, read as 0 1 2, validator: MESH_PRIMITIVE_ATTRIBUTES_ACCESSOR_UNSIGNED_INT
Int32Array: type 5124, not read: TypeError, validator: VALUE_NOT_IN_LIST
TEXT

node label.mjs | tee seen
diff wanted seen
