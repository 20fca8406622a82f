/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// Where a ray meets a shape, and what a brush covers there.

/** The nearest face that a ray meets, and the place in it, as barycentric coordinates; or null.
    `corners` has 9 numbers a face [Moeller and Trumbore 1997]. */
function meet({origin, direction, corners}) {
  let best = null;
  for (let i = 0; i < corners.length; i += 9) {
    const a = [corners[i], corners[i + 1], corners[i + 2]];
    const e = [corners[i + 3] - a[0], corners[i + 4] - a[1], corners[i + 5] - a[2]];
    const f = [corners[i + 6] - a[0], corners[i + 7] - a[1], corners[i + 8] - a[2]];
    const p = cross(direction, f), determinant = dot(e, p);
    if (determinant === 0) continue;
    const s = [origin[0] - a[0], origin[1] - a[1], origin[2] - a[2]];
    const u = dot(s, p) / determinant;
    if (u < 0 || u > 1) continue;
    const q = cross(s, e), v = dot(direction, q) / determinant;
    if (v < 0 || u + v > 1) continue;
    const distance = dot(f, q) / determinant;
    if (distance > 0 && !(distance >= best?.distance))
      best = {distance, face: i / 9, shares: [1 - u - v, u, v]};
  }
  return best;
}

/** The point of the first shape where a face is met. */
function pointOf(faces, home, {face, shares}) {
  return [0, 1, 2].map(k =>
      shares.reduce((sum, share, c) => sum + share * home[3 * faces[3 * face + c] + k], 0));
}

/** The neighbours of the vertices, one after the other, from `first[v]` on. */
function neighbours(faces, count) {
  const first = new Uint32Array(count + 1);
  for (const v of faces) first[v + 1] += 2;
  for (let v = 0; v < count; ++v) first[v + 1] += first[v];
  const next = first.slice(), all = new Uint32Array(2 * faces.length);
  for (let c = 0; c < faces.length; ++c) {
    const f = c - c % 3;
    all[next[faces[c]]++] = faces[f + (c + 1) % 3];
    all[next[faces[c]]++] = faces[f + (c + 2) % 3];
  }
  return {first, all};
}

function nearestVertex(home, point) {
  let best = 0, least = Infinity;
  for (let v = 0; v < home.length / 3; ++v) {
    const d = Math.hypot(home[3 * v] - point[0], home[3 * v + 1] - point[1], home[3 * v + 2] - point[2]);
    if (d < least) {
      least = d;
      best = v;
    }
  }
  return best;
}

/** Raises the cover, a number in [0, 1] of each vertex, to that of one dab: what is connected to its
    middle within the radius. */
function dab(cover, home, {first, all}, point, radius) {
  const start = nearestVertex(home, point), seen = new Set([start]), queue = [start];
  while (queue.length) {
    const v = queue.pop();
    const d = Math.hypot(home[3 * v] - point[0], home[3 * v + 1] - point[1], home[3 * v + 2] - point[2]);
    if (d >= radius && v !== start) continue;
    const share = Math.max(0, 1 - d * d / (radius * radius));
    cover[v] = Math.max(cover[v], share * share);
    for (let i = first[v]; i < first[v + 1]; ++i)
      if (!seen.has(all[i])) {
        seen.add(all[i]);
        queue.push(all[i]);
      }
  }
}

/** rho after a stroke: painted by the strength where it is covered, or erased. */
function painted(rho, cover, strength) {
  return strength === 0 ? rho.map((value, v) => value * (1 - cover[v]))
                        : rho.map((value, v) => value + strength * cover[v]);
}
