/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// Runs the kernels beside the page: opens surfaces, and answers {id, ...} to each message {id, type, ...}.

const ready = makeKernels();
let surface = null;

self.onmessage = async ({data}) => {
  const answer = {id: data.id};
  try {
    const module = await ready;
    if (data.type === 'open') surface = new OpenSurface(module, data.points, data.faces);
    else if (data.type === 'read') Object.assign(answer, readShape(module, data));
    else Object.assign(answer, surface[data.type](data));
  } catch (error) {
    answer.error = error instanceof Refusal ? error.message
                                            : `The kernels have failed: ${error.message ?? error}`;
  }
  self.postMessage(answer, [answer.after, answer.quality].filter(Boolean).map(a => a.buffer));
};
