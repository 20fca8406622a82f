/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

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

const areasBefore = areasOf(faces, before), areasAfter = areasOf(faces, after);
const scales = scalesOf(areasBefore, areasAfter);

/** The ratio of the singular values of each face's map, from both shapes: Q = h + sqrt(h^2 - 1)
    where 2 h = |J|^2 / det J. It does not use the program's own. */
function recomputedQuality() {
  return quality.map((_, f) => {
    const [a, b, c, d] = [[before, 1], [before, 2], [after, 1], [after, 2]]
        .map(([points, corner]) => edge(faces, points, f, 0, corner));
    const [aa, ab, bb] = [dot(a, a), dot(a, b), dot(b, b)];
    const [cc, cd, dd] = [dot(c, c), dot(c, d), dot(d, d)];
    const h = (bb * cc - 2 * ab * cd + aa * dd) /
        (8 * areasBefore.areas[f] * areasAfter.areas[f]);
    return h + Math.sqrt(Math.max(0, h * h - 1));
  });
}

const mean = values => values.reduce((sum, value, f) => sum + value * areasBefore.areas[f], 0) /
    areasBefore.total;
