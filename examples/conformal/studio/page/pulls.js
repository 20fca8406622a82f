/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// Control points, pulled on the surface after, by mouse, pen or finger.

const holds = 7, reach = 14; // points that hold the rest; pixels around a pin

/** Vertices far from each other and from the first ones. */
function spreadOut(points, first, count) {
  const chosen = [...first], distances = new Float64Array(points.length / 3).fill(Infinity);
  const approach = v => distances.forEach((d, u) => distances[u] = Math.min(d, Math.hypot(
      points[3 * u] - points[3 * v], points[3 * u + 1] - points[3 * v + 1], points[3 * u + 2] - points[3 * v + 2])));
  chosen.forEach(approach);
  while (chosen.length < count) {
    chosen.push(distances.reduce((best, d, v) => d > distances[best] ? v : best, 0));
    approach(chosen.at(-1));
  }
  return chosen;
}

const placeOf = (points, v) => Array.from(points.subarray(3 * v, 3 * v + 3));

/** `pull` begins with ground(), a state; shows targets by show(targets), and ends with
    finish(targets) or cancel(). */
class Pulls {
  #pull = null;

  constructor(canvas, viewer, tool, pull) {
    Object.assign(this, {canvas, viewer, tool, pull});
    canvas.addEventListener('pointermove', event => this.#move(event));
    canvas.addEventListener('pointerup', event => this.#end(event));
    canvas.addEventListener('pointercancel', event => this.#end(event));
  }

  /** Whether a pull can begin there. */
  hits(event) {
    const ray = this.tool().tool === 'pull' && this.viewer.ray(event.offsetX, event.offsetY);
    return Boolean(ray) && ray.side === 1 && meet(ray) !== null;
  }

  /** Whether a pointer that goes down pulls. */
  takes(event) {
    if (event.button !== 0 || event.shiftKey || this.tool().tool !== 'pull' || this.#pull) return false;
    const ray = this.viewer.ray(event.offsetX, event.offsetY);
    if (ray?.side !== 1) return false;
    const state = this.pull.ground(), vertex = this.#pinAt(event, state) ?? this.#vertexAt(ray);
    if (vertex === null) {
      this.pull.cancel();
      return false;
    }
    this.canvas.setPointerCapture(event.pointerId);
    this.#pull = {pointer: event.pointerId, vertex, targets: this.#targetsWith(state, vertex)};
    return true;
  }

  #pinAt({offsetX, offsetY}, {targets, after}) {
    const distance = ({vertex}) => {
      const {x, y} = this.viewer.project(placeOf(after, vertex));
      return Math.hypot(x - offsetX, y - offsetY);
    };
    return targets.filter(pin => distance(pin) < reach).sort((a, b) => distance(a) - distance(b))[0]?.vertex ?? null;
  }

  #vertexAt(ray) {
    const hit = meet(ray);
    return hit && this.pull.faces()[3 * hit.face + hit.shares.indexOf(Math.max(...hit.shares))];
  }

  /** Those of the state; the first one is held by others all over the surface. */
  #targetsWith({targets, after}, vertex) {
    if (targets.some(pin => pin.vertex === vertex)) return targets;
    const added = targets.length ? [vertex] : spreadOut(after, [vertex], holds + 1);
    return [...targets, ...added.map(v => ({vertex: v, to: placeOf(after, v)}))];
  }

  #move(event) {
    if (this.#pull?.pointer !== event.pointerId) return;
    const {targets, vertex} = this.#pull, last = targets.find(pin => pin.vertex === vertex).to;
    const to = this.viewer.unproject(event.offsetX, event.offsetY, last);
    this.#pull.targets = targets.map(pin => pin.vertex === vertex ? {vertex, to} : pin);
    this.pull.show(this.#pull.targets);
  }

  #end(event) {
    if (this.#pull?.pointer !== event.pointerId) return;
    const {targets} = this.#pull;
    this.#pull = null;
    if (event.type === 'pointercancel') this.pull.cancel();
    else this.pull.finish(targets);
  }
}
