/* Copyright (c) 2026 The Conformal Geometry Processing authors
   SPDX-License-Identifier: LGPL-3.0-or-later */

// What the page holds, and what follows from it.

const text = id => document.getElementById(id).textContent;

function numbers(id, Type) {
  const characters = atob(text(id));
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = characters.charCodeAt(i);
  return new Type(bytes.buffer);
}

const report = JSON.parse(text('report'));
const faces = numbers('faces', Uint32Array);
const before = numbers('before', Float32Array);
const after = numbers('after', Float32Array);
const quality = numbers('quality', Float32Array);
const squares = numbers('squares', Float32Array);
const rho = numbers('rho', Float32Array); // of each face; empty if there is none
const faceCount = quality.length;

/** The number or word at a place such as `result/scale/min`; undefined if there is none. */
function at(place) {
  return place.split('/').reduce((part, key) => part?.[key], report);
}

/** Vector from corner a to corner b of a face. */
function edge(points, face, a, b) {
  const i = 3 * faces[3 * face + a], j = 3 * faces[3 * face + b];
  return [points[j] - points[i], points[j + 1] - points[i + 1], points[j + 2] - points[i + 2]];
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                         a[0] * b[1] - a[1] * b[0]];

/** The vector areas, three numbers a face, and the areas of the faces. */
function areasOf(points) {
  const vectors = new Float32Array(3 * faceCount), areas = new Float64Array(faceCount);
  for (let f = 0; f < faceCount; ++f) {
    const vector = cross(edge(points, f, 0, 1), edge(points, f, 0, 2));
    vectors.set(vector, 3 * f);
    areas[f] = Math.hypot(...vector) / 2;
  }
  return {vectors, areas, total: areas.reduce((sum, area) => sum + area, 0)};
}

const areasBefore = areasOf(before), areasAfter = areasOf(after);

/** Lengths after by lengths before, of each face, in the frames where both have the same area. */
const scales = areasBefore.areas.map((area, f) =>
    Math.sqrt(areasAfter.areas[f] / areasAfter.total / (area / areasBefore.total)));

/** The value below which that share of the area has its values. */
function quantile(values, share) {
  const order = Uint32Array.from(values, (_, f) => f).sort((a, b) => values[a] - values[b]);
  let sum = 0;
  for (const f of order) {
    sum += areasBefore.areas[f];
    if (sum >= share * areasBefore.total) return values[f];
  }
  return values[order[order.length - 1]];
}

/** The ratio of the singular values of each face's map, from both shapes: Q = h + sqrt(h^2 - 1)
    where 2 h = |J|^2 / det J. It does not use the program's own. */
function recomputedQuality() {
  return quality.map((_, f) => {
    const [a, b, c, d] = [[before, 1], [before, 2], [after, 1], [after, 2]]
        .map(([points, corner]) => edge(points, f, 0, corner));
    const [aa, ab, bb] = [dot(a, a), dot(a, b), dot(b, b)];
    const [cc, cd, dd] = [dot(c, c), dot(c, d), dot(d, d)];
    const h = (bb * cc - 2 * ab * cd + aa * dd) /
        (8 * areasBefore.areas[f] * areasAfter.areas[f]);
    return h + Math.sqrt(Math.max(0, h * h - 1));
  });
}

const mean = values => values.reduce((sum, value, f) => sum + value * areasBefore.areas[f], 0) /
    areasBefore.total;
