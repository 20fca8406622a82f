/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// A surface that is open in a module of the kernels. The worker of the studio and the npm package share it.

/** What the kernels refuse, in their words. */
class Refusal extends Error {}

/** Copies numbers into the memory of the module, calls a function with their place, and frees them. */
function withArrays(module, arrays, call) {
  const places = arrays.map(array => {
    const place = module._malloc(array.byteLength);
    module.HEAPU8.set(new Uint8Array(array.buffer, array.byteOffset, array.byteLength), place);
    return place;
  });
  try {
    return call(...places);
  } finally {
    places.forEach(place => module._free(place));
  }
}

/** The surface of a mesh file: points, faces, where squares are, the numbers of its vertices in the file, and notes
    on what was done to it. Throws what the readers of the program refuse. */
function readShape(module, {bytes, name, isRepaired}) {
  const isRead = withArrays(module, [bytes, new TextEncoder().encode(`${name}\0`)], (content, words) =>
      module._studio_read(content, bytes.length, words, isRepaired));
  const told = module.UTF8ToString(module._studio_text());
  if (!isRead) throw new Refusal(told);
  const {vertices, faces, ...rest} = JSON.parse(told);
  const copy = (heap, place, size) => heap.slice(place / heap.BYTES_PER_ELEMENT, place / heap.BYTES_PER_ELEMENT + size);
  return {...rest, points: copy(module.HEAPF64, module._studio_file_positions(), 3 * vertices),
          faces: copy(module.HEAPU32, module._studio_file_faces(), 3 * faces),
          squares: copy(module.HEAPF32, module._studio_file_squares(), 6 * faces),
          origin: copy(module.HEAPU32, module._studio_file_origin(), vertices)};
}

/** A module has one at a time. Points and rho are Float64Arrays; rho is in the user's frame, whose unit is
    half the diagonal of the bounding box. A bound of at most 1 is none. */
class OpenSurface {
  constructor(module, points, faces) {
    Object.assign(this, {module, vertices: points.length / 3, faces: faces.length / 3});
    this.#require(withArrays(module, [points, faces], (place, corners) =>
        module._studio_open(place, this.vertices, corners, this.faces)));
  }

  preview({rho, bound, continues}) {
    return this.#result(withArrays(this.module, [rho], place =>
        this.module._studio_preview(place, bound, continues)));
  }

  transform({rho, bound}) {
    return this.#result(withArrays(this.module, [rho], place => this.module._studio_transform(place, bound)));
  }

  /** `vertices`, an Int32Array, to `targets`, three numbers of each. */
  deform({vertices, targets, bound, continues}) {
    return this.#result(withArrays(this.module, [vertices, targets], (points, places) =>
        this.module._studio_deform(points, places, vertices.length, bound, continues)));
  }

  /** One more step of the flow. */
  flow() {
    return this.#result(this.module._studio_flow());
  }

  #require(isDone) {
    if (!isDone) throw new Refusal(this.module.UTF8ToString(this.module._studio_text()));
  }

  #result(isDone) {
    this.#require(isDone);
    const {module} = this, after = module._studio_positions() / 8, quality = module._studio_quality() / 4;
    return {
      after: module.HEAPF64.slice(after, after + 3 * this.vertices),
      quality: module.HEAPF32.slice(quality, quality + this.faces),
      report: JSON.parse(module.UTF8ToString(module._studio_text())),
      memory: module.HEAPU8.length
    };
  }
}
