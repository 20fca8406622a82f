/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// Strokes of the brush, by mouse, pen, finger or key.

const breadth = 14; // of a finger, in pixels from its middle

function perimeter(corners) {
  return [0, 3, 6].reduce((sum, i) => sum + Math.hypot(...[0, 1, 2].map(k => corners[i + k] - corners[(i + 3) % 9 + k])), 0);
}

/** `tool()` has {tool, size, strength, symmetric}; `edit` begins with ground(), shows what is painted
    by paint(rho), and ends with finish(rho) or cancel(). */
class Strokes {
  #stroke = null;
  #links = null; // neighbours of the vertices of the faces at hand
  #faces = null;

  constructor(canvas, circle, viewer, tool, edit) {
    Object.assign(this, {canvas, circle, viewer, tool, edit});
    canvas.addEventListener('pointermove', event => this.#move(event));
    canvas.addEventListener('pointerup', event => this.#end(event));
    canvas.addEventListener('pointercancel', event => this.#end(event));
    canvas.addEventListener('pointerleave', () => this.#ring(null, {}));
  }

  /** Whether a stroke can begin there. */
  hits(event) { return this.#paints() && this.#near(event) !== null; }

  /** Whether a pointer that goes down paints. A second finger makes two that turn. */
  takes(event) {
    if (this.#stroke && this.#stroke.event.pointerId !== event.pointerId) {
      const first = this.#stroke.event;
      this.#stroke = null;
      this.edit.cancel();
      this.viewer.grab(first);
      return false;
    }
    if (event.button !== 0 || event.shiftKey || !this.#paints()) return false;
    const hit = this.#near(event);
    if (!hit) return false;
    this.canvas.setPointerCapture(event.pointerId);
    this.#begin(event);
    this.#dab(hit.point);
    this.#paint();
    return true;
  }

  /** Paints one dab in the middle of the surface, or else of the first shape. */
  dabInTheMiddle() {
    const places = this.viewer.rectangles().map(r => [r.left + r.width / 2, r.top + r.height / 2]);
    const hit = this.#hit(...places[1]) ?? this.#hit(...places[0]);
    if (!hit || !this.#paints()) return;
    this.#begin({pointerId: -1, offsetX: 0, offsetY: 0});
    this.#dab(hit.point);
    this.#end({pointerId: -1});
  }

  /** What is met there: its place on the first shape, the side, and the pixels of a unit of the first shape. */
  #hit(x, y) {
    const ray = this.viewer.ray(x, y), hit = ray && meet(ray);
    if (!hit) return null;
    const {home} = this.viewer, faces = this.edit.faces().subarray(3 * hit.face, 3 * hit.face + 3);
    const seen = Array.from(ray.corners.subarray(9 * hit.face, 9 * hit.face + 9));
    const scale = perimeter(seen) / perimeter(Array.from(faces).flatMap(v => placeOf(home, v)));
    return {point: pointOf(this.edit.faces(), home, hit), side: ray.side,
            pixels: scale * this.viewer.pixels(ray.side, hit.distance)};
  }

  /** Fingers are broad: they meet what is around them, too. */
  #near({offsetX: x, offsetY: y, pointerType}) {
    const reached = pointerType === 'touch' ? [0, 1, 2, 3, 4, 5].map(k => k * Math.PI / 3) : [];
    return [[x, y], ...reached.map(a => [x + breadth * Math.cos(a), y + breadth * Math.sin(a)])]
        .reduce((found, place) => found ?? this.#hit(...place), null);
  }

  #paints() { return ['bulge', 'dent', 'erase'].includes(this.tool().tool); }

  #radius() { return .3 * this.tool().size; }

  /** A circle around the pointer, whole beyond silhouettes, and what it covers on the other side. */
  #ring(hit, {offsetX, offsetY}) {
    const {viewer, circle} = this;
    viewer.ring = {side: hit?.side ?? -1, radius: hit ? this.#radius() : 0};
    viewer.uniforms.brush.value.set(...(hit?.point ?? [0, 0, 0]), 0);
    circle.hidden = !hit;
    if (hit) {
      const size = `${2 * this.#radius() * hit.pixels}px`;
      Object.assign(circle.style, {left: `${offsetX}px`, top: `${offsetY}px`, width: size, height: size});
    }
    viewer.redraw();
  }

  #begin(event) {
    const ground = this.edit.ground(), faces = this.edit.faces();
    if (this.#faces !== faces) this.#links = neighbours(faces, ground.length);
    this.#faces = faces;
    this.#stroke = {event, ground, cover: new Float64Array(ground.length)};
  }

  #dab(point) {
    const {cover} = this.#stroke, {home} = this.viewer;
    dab(cover, home, this.#links, point, this.#radius());
    if (this.tool().symmetric)
      dab(cover, home, this.#links, [-point[0], point[1], point[2]], this.#radius());
  }

  #rho() {
    const {tool, strength} = this.tool(), {ground, cover} = this.#stroke;
    return painted(ground, cover, tool === 'erase' ? 0 : tool === 'dent' ? -strength : strength);
  }

  #paint() {
    this.edit.paint(this.#rho());
  }

  #move(event) {
    if (this.#stroke?.event.pointerId !== event.pointerId) {
      const isFree = event.buttons === 0 && event.pointerType !== 'touch' && this.#paints();
      this.#ring(isFree ? this.#hit(event.offsetX, event.offsetY) : null, event);
      return;
    }
    const {offsetX: x, offsetY: y} = this.#stroke.event;
    const right = event.offsetX - x, down = event.offsetY - y;
    const parts = Math.min(Math.max(Math.ceil(Math.hypot(right, down) / 10), 1), 12);
    let hit = null;
    for (let i = 1; i <= parts; ++i) {
      hit = this.#hit(x + right * i / parts, y + down * i / parts);
      if (hit) this.#dab(hit.point);
    }
    this.#stroke.event = event;
    this.#ring(hit, event);
    this.#paint();
  }

  #end(event) {
    if (this.#stroke?.event.pointerId !== event.pointerId) return;
    const rho = this.#rho();
    this.#stroke = null;
    this.edit.finish(rho);
  }
}
