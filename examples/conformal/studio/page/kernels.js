/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// A worker with the kernels, which computes one thing at a time.

const kernelsAddress = URL.createObjectURL(
    new Blob([text('kernels')], {type: 'text/javascript'}));

class Kernels {
  #worker = null;
  #waiting = new Map();
  #last = 0;
  #surface = null; // the points that the worker has open
  #flowed = [];    // what came of each step of their flow

  constructor() {
    this.#start();
  }

  #start() {
    this.#worker = new Worker(kernelsAddress);
    this.#worker.onmessage = ({data}) => {
      const {resolve, reject} = this.#waiting.get(data.id);
      this.#waiting.delete(data.id);
      if (data.error) reject(new Error(data.error));
      else resolve(data);
    };
    this.#worker.onerror = event => this.#fail(event.message);
    this.#surface = null;
  }

  #fail(message) {
    for (const {reject} of this.#waiting.values()) reject(new Error(message));
    this.#waiting.clear();
  }

  /** Gives up what is being computed. */
  restart() {
    this.#worker.terminate();
    this.#fail('given up');
    this.#start();
  }

  #ask(type, message) {
    const id = ++this.#last;
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, {resolve, reject});
      this.#worker.postMessage({id, type, ...message});
    });
  }

  /** The shape of a file: {name, bytes, isRepaired}. */
  read(file) {
    return this.#ask('read', file);
  }

  async #open(points, faces) {
    if (this.#surface === points) return;
    this.#surface = null;
    await this.#ask('open', {points, faces});
    this.#surface = points;
    this.#flowed = [];
  }

  async preview(points, faces, rho, bound, continues) {
    const isNew = this.#surface !== points;
    await this.#open(points, faces);
    return this.#ask('preview', {rho, bound, continues: continues && !isNew});
  }

  async transform(points, faces, rho, bound) {
    await this.#open(points, faces);
    return this.#ask('transform', {rho, bound});
  }

  /** With vertices at their targets, a list of {vertex, to}. */
  async deform(points, faces, targets, bound, continues) {
    const isNew = this.#surface !== points;
    await this.#open(points, faces);
    return this.#ask('deform', {vertices: Int32Array.from(targets, ({vertex}) => vertex),
                                targets: Float64Array.from(targets.flatMap(({to}) => to)), bound,
                                continues: continues && !isNew});
  }

  /** The surface after so many steps of the flow, or where it has converged. Each step on the way is
      told by `goesOn(answer)`, which returns whether to take more. */
  async flow(points, faces, steps, goesOn = () => true) {
    await this.#open(points, faces);
    const flowed = this.#flowed, isLast = answer => answer?.report.result.converged || answer?.report.error;
    while (flowed.length < steps && !isLast(flowed.at(-1))) {
      flowed.push(await this.#ask('flow', {}));
      if (!goesOn(flowed.at(-1))) break;
    }
    return flowed[Math.min(steps, flowed.length) - 1];
  }
}
