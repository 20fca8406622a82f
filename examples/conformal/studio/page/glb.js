/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// Binary glTF 2.0, in which coordinates are of single precision.

/** Bytes up to the next multiple of four. */
function aligned(bytes, filling) {
  const result = new Uint8Array(Math.ceil(bytes.length / 4) * 4).fill(filling);
  result.set(bytes);
  return result;
}

function chunk(kind, bytes) {
  return [Uint32Array.of(bytes.length, kind), bytes];
}

function toGlb(points, faces) {
  const positions = Float32Array.from(points), corners = Uint32Array.from(faces), ends = [Math.min, Math.max].map(end =>
      [0, 1, 2].map(k => positions.reduce((best, x, i) => i % 3 === k ? end(best, x) : best, positions[k])));
  const size = positions.byteLength + corners.byteLength;
  const content = {
    asset: {version: '2.0', generator: 'conformal studio'}, scene: 0, scenes: [{nodes: [0]}], nodes: [{mesh: 0}],
    meshes: [{primitives: [{attributes: {POSITION: 0}, indices: 1}]}], buffers: [{byteLength: size}],
    bufferViews: [{buffer: 0, byteLength: positions.byteLength, target: 34962},
                  {buffer: 0, byteOffset: positions.byteLength, byteLength: corners.byteLength, target: 34963}],
    accessors: [{bufferView: 0, componentType: 5126, type: 'VEC3', count: positions.length / 3, min: ends[0], max: ends[1]},
                {bufferView: 1, componentType: 5125, type: 'SCALAR', count: corners.length}]
  };
  const json = aligned(new TextEncoder().encode(JSON.stringify(content)), 32), body = new Uint8Array(size);
  body.set(new Uint8Array(positions.buffer));
  body.set(new Uint8Array(corners.buffer), positions.byteLength);
  return [Uint32Array.of(0x46546c67, 2, 28 + json.length + size), ...chunk(0x4e4f534a, json), ...chunk(0x004e4942, body)];
}
