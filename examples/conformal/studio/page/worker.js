/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// Runs the kernels beside the page: opens surfaces, and answers {id, ...} to each message {id, type, ...}.

const ready = makeKernels();

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

const edits = {
  preview: (module, {rho, bound, continues}) =>
      withArrays(module, [rho], place => module._studio_preview(place, bound, continues)),
  transform: (module, {rho, bound}) =>
      withArrays(module, [rho], place => module._studio_transform(place, bound)),
  deform: (module, {vertices, targets, bound, continues}) =>
      withArrays(module, [vertices, targets], (points, places) =>
          module._studio_deform(points, places, vertices.length, bound, continues)),
  flow: module => module._studio_flow()
};

let vertices = 0, faceCount = 0;

function open(module, {points, faces}) {
  vertices = points.length / 3;
  faceCount = faces.length / 3;
  return withArrays(module, [points, faces], (place, corners) =>
      module._studio_open(place, vertices, corners, faceCount));
}

function result(module) {
  const after = module._studio_positions() / 8, quality = module._studio_quality() / 4;
  return {
    after: module.HEAPF64.slice(after, after + 3 * vertices),
    quality: module.HEAPF32.slice(quality, quality + faceCount),
    report: JSON.parse(module.UTF8ToString(module._studio_text())),
    memory: module.HEAPU8.length
  };
}

self.onmessage = async ({data}) => {
  const answer = {id: data.id};
  try {
    const module = await ready;
    const isDone = data.type === 'open' ? open(module, data) : edits[data.type](module, data);
    if (!isDone) answer.error = module.UTF8ToString(module._studio_text());
    else if (data.type !== 'open') Object.assign(answer, result(module));
  } catch (error) {
    answer.error = `The kernels have failed: ${error.message ?? error}`;
  }
  self.postMessage(answer, [answer.after, answer.quality].filter(Boolean).map(a => a.buffer));
};
