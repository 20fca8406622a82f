/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// What the page holds.

const element = id => document.getElementById(id);
const text = id => element(id).textContent;

function numbers(id, Type) {
  const characters = atob(text(id));
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = characters.charCodeAt(i);
  return new Type(bytes.buffer);
}

const studio = JSON.parse(text('studio'));

/** A shape of the page, or of a file that was opened: name, file, fileVertices, isRepaired, points, faces, squares,
    and where its vertices are in the file. */
function shapeOf(k) {
  if (studio.shapes[k].points) return studio.shapes[k];
  return {...studio.shapes[k], points: numbers(`positions-${k}`, Float64Array),
          faces: numbers(`faces-${k}`, Uint32Array), squares: numbers(`squares-${k}`, Float32Array),
          origin: numbers(`origin-${k}`, Uint32Array)};
}
