/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// How large the squares are. Conformal maps to the plane stretch much where a surface bulges, so
// there squares are cut into 4 x 4, or so many made one: they stay squares, of half to
// twice the usual size.

/** log2 of the lengths on the checkerboard by those on the surface, of each corner: the mean of
    the faces around its vertex that are together on the checkerboard. `areas` are of the faces. */
function stretches({faces, squares, before}, {areas}) {
  const faceCount = faces.length / 3, first = new Int32Array(before.length / 3).fill(-1), next = [], where = [];
  const copy = new Int32Array(3 * faceCount), sum = [], weight = [];
  for (let f = 0; f < faceCount; ++f) {
    const [ax, ay, bx, by, cx, cy] = squares.subarray(6 * f, 6 * f + 6);
    const area = Math.abs((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2;
    for (let k = 3 * f; k < 3 * f + 3; ++k) {
      let c = first[faces[k]];
      while (c >= 0 && (squares[2 * where[c]] !== squares[2 * k] ||
                        squares[2 * where[c] + 1] !== squares[2 * k + 1])) c = next[c];
      if (c < 0) {
        c = where.length;
        next.push(first[faces[k]]);
        where.push(k);
        sum.push(0);
        weight.push(0);
        first[faces[k]] = c;
      }
      copy[k] = c;
      sum[c] += area;
      weight[c] += areas[f];
    }
  }
  return Float32Array.from(copy, c => Math.log2(Math.max(sum[c] / weight[c], 1e-30)) / 2);
}

/** How many squares there are by unit of the checkerboard where it is stretched as usual, and how
    much more it is stretched at each corner: log2 of lengths. */
function squareSizes(exhibit, areas) {
  const levels = stretches(exhibit, areas), across = 26;
  const faceLevels = Float32Array.from(areas.areas, (_, f) => (levels[3 * f] + levels[3 * f + 1] + levels[3 * f + 2]) / 3);
  const usual = quantile(faceLevels, .5, areas);
  return {frequency: across / Math.sqrt(areas.total) / 2 ** usual,
          levels: levels.map(level => level - usual)};
}
