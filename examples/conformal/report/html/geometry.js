/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// Edges, areas and shares of surfaces, from their faces (3 numbers each) and points (3 each).

/** Vector from corner a to corner b of a face. */
function edge(faces, points, face, a, b) {
  const i = 3 * faces[3 * face + a], j = 3 * faces[3 * face + b];
  return [points[j] - points[i], points[j + 1] - points[i + 1], points[j + 2] - points[i + 2]];
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                         a[0] * b[1] - a[1] * b[0]];

/** The vector areas, three numbers a face, and the areas of the faces. */
function areasOf(faces, points) {
  const count = faces.length / 3;
  const vectors = new Float32Array(3 * count), areas = new Float64Array(count);
  for (let f = 0; f < count; ++f) {
    const vector = cross(edge(faces, points, f, 0, 1), edge(faces, points, f, 0, 2));
    vectors.set(vector, 3 * f);
    areas[f] = Math.hypot(...vector) / 2;
  }
  return {vectors, areas, total: areas.reduce((sum, area) => sum + area, 0)};
}

/** Lengths after by lengths before, of each face, in the frames where both have the same area. */
function scalesOf(before, after) {
  return before.areas.map((area, f) =>
      Math.sqrt(after.areas[f] / after.total / (area / before.total)));
}

/** The value below which that share of the area has its values. */
function quantile(values, share, {areas, total}) {
  const order = Uint32Array.from(values, (_, f) => f).sort((a, b) => values[a] - values[b]);
  let sum = 0;
  for (const f of order) {
    sum += areas[f];
    if (sum >= share * total) return values[f];
  }
  return values[order[order.length - 1]];
}
