/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// What users of the package call: see index.d.ts.

import makeKernels from './kernels.js';
import {OpenSurface, Refusal, readShape} from './surface.js';

export {Refusal};

const require = (isTrue, message) => {
  if (!isTrue) throw new Refusal(message);
};

/** Numbers in one array: `lists` may be an array of rows. */
function flat(Type, rows, size, name) {
  const isTyped = ArrayBuffer.isView(rows);
  require(isTyped || Array.isArray(rows), `${name}: wanted an array of numbers`);
  const numbers = isTyped ? rows : rows.flat();
  require(numbers.length % size === 0, `${name}: wanted ${size} numbers each, got ${numbers.length} in all`);
  require(numbers.every(Number.isFinite), `${name}: not all are finite numbers`);
  return Type.from(numbers);
}

/** Half the diagonal of the bounding box: the unit of rho in the kernels. */
function unitOf(points) {
  let squares = 0;
  for (let k = 0; k < 3; ++k) {
    let low = Infinity, high = -Infinity;
    for (let i = k; i < points.length; i += 3) {
      low = Math.min(low, points[i]);
      high = Math.max(high, points[i]);
    }
    squares += ((high - low) / 2) ** 2;
  }
  return Math.sqrt(squares);
}

export class Surface {
  #open; #unit; #triangles;

  /** Private: `Surface.open()` makes surfaces. */
  constructor(module, points, triangles) {
    this.#open = new OpenSurface(module, points, triangles);
    this.#unit = unitOf(points);
    this.#triangles = triangles;
  }

  static async open(positions, triangles) {
    const points = flat(Float64Array, positions, 3, 'positions');
    const corners = flat(Int32Array, triangles, 3, 'triangles');
    return new Surface(await makeKernels(), points, corners);
  }

  transform(rho, {maxScale} = {}) {
    return this.#result(this.#open.transform({rho: this.#rho(rho), bound: this.#bound(maxScale)}));
  }

  preview(rho, {maxScale, continues = false} = {}) {
    return this.#result(this.#open.preview({rho: this.#rho(rho), bound: this.#bound(maxScale), continues}));
  }

  deform(targets, {maxScale, continues = false} = {}) {
    const vertices = flat(Int32Array, targets.map(({vertex}) => vertex), 1, 'vertices of targets');
    require(vertices.every(v => v >= 0 && v < this.#open.vertices), 'targets: no such vertex');
    const places = flat(Float64Array, targets.map(({to}) => Array.from(to)), 3, 'places of targets');
    require(places.length === 3 * vertices.length, 'targets: wanted 3 coordinates of each');
    return this.#result(this.#open.deform({vertices, targets: places, bound: this.#bound(maxScale), continues}));
  }

  flow(steps = 1) {
    require(Number.isInteger(steps) && steps > 0, `flow: ${steps} is not a number of steps`);
    let result = this.#open.flow();
    for (let i = 1; i < steps && !result.report.result.converged && result.report.verified; ++i)
      result = this.#open.flow();
    return this.#result(result);
  }

  #rho(rho) {
    const values = flat(Float64Array, rho, 1, 'rho');
    require(values.length === this.#open.vertices,
            `rho: wanted a number of each of ${this.#open.vertices} vertices, got ${values.length}`);
    return values.map(value => value * this.#unit);
  }

  #bound(maxScale = this.#open.module._studio_default_bound()) {
    require(maxScale === null || maxScale > 1, `maxScale: wanted more than 1, or null, got ${maxScale}`);
    return maxScale ?? 0;
  }

  #result({after, quality, report}) {
    return {positions: after, triangles: Uint32Array.from(this.#triangles), quality, report};
  }
}

export async function readSurface(bytes, name, {repair = false} = {}) {
  const {points, faces, origin, notes} = readShape(await makeKernels(), {bytes, name, isRepaired: repair});
  return {positions: points, triangles: faces, vertexInFile: origin, notes};
}

export async function spinTransform(positions, triangles, rho, options) {
  return (await Surface.open(positions, triangles)).transform(rho, options);
}

export async function deform(positions, triangles, targets, options) {
  return (await Surface.open(positions, triangles)).deform(targets, options);
}

export async function willmoreFlow(positions, triangles, {steps = 10} = {}) {
  return (await Surface.open(positions, triangles)).flow(steps);
}
