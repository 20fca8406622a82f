#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: glTF Transform 4.5.1 (npm @gltf-transform/core, @gltf-transform/functions, @gltf-transform/extensions).
# Expected: quantize() treats an attribute of its own name, such as `_RHO`, as it treats positions, within
# the range of its values, or leaves it as it is.
# Seen: that depends on the unit. If all values are within -1 and 1 they are rounded to twelve bits of
# that range, whatever their own one is, so that the largest rho of 0.0005 is wrong by half of it; if one
# of them is beyond 1, all stay floats.
# Met: rho in GLB files, in 1/length: of a surface in metres it is kept, in millimetres it is lost.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm install --silent --no-audit --no-fund @gltf-transform/core@4.5.1 @gltf-transform/functions@4.5.1 \
  @gltf-transform/extensions@4.5.1 >/dev/null

cat >quantize.mjs <<'JS'
import { Document, Logger, NodeIO, VERSION } from "@gltf-transform/core";
import { ALL_EXTENSIONS } from "@gltf-transform/extensions";
import { quantize } from "@gltf-transform/functions";

const io = new NodeIO().registerExtensions(ALL_EXTENSIONS);
console.log("glTF Transform", VERSION);
for (const largest of [1.5, 0.5, 0.0005]) {
  const document = new Document().setLogger(new Logger(Logger.Verbosity.ERROR));
  const buffer = document.createBuffer(), count = 99;
  const accessor = (type, array) =>
    document.createAccessor().setType(type).setArray(array).setBuffer(buffer);
  const rho = Float32Array.from({ length: count }, (_, i) => largest * Math.sin(i));
  const points = Float32Array.from({ length: 3 * count }, (_, i) => Math.cos(i));
  const primitive = document.createPrimitive().setAttribute("POSITION", accessor("VEC3", points))
    .setAttribute("_RHO", accessor("SCALAR", rho));
  document.createScene().addChild(
    document.createNode().setMesh(document.createMesh().addPrimitive(primitive)));
  await document.transform(quantize());
  const read = await io.readBinary(await io.writeBinary(document));
  const again = read.getRoot().listMeshes()[0].listPrimitives()[0].getAttribute("_RHO");
  const error = Math.max(...rho.map((x, i) => Math.abs(x - again.getElement(i, [])[0])));
  console.log(`largest rho ${largest}: component type ${again.getComponentType()},`,
    `error ${Math.round(1000 * error / largest)} thousandths of it`);
}
JS
cat >wanted <<'TEXT'
glTF Transform v4.5.1
largest rho 1.5: component type 5126, error 0 thousandths of it
largest rho 0.5: component type 5122, error 1 thousandths of it
largest rho 0.0005: component type 5122, error 463 thousandths of it
TEXT

node quantize.mjs | tee seen
diff wanted seen
