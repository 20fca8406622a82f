/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// Strokes of the brush, by mouse, pen, finger or key.

/** `tool()` has {tool, size, strength, symmetric}; `edit` begins with ground(), shows what is painted
    by paint(rho), and ends with finish(rho) or cancel(). */
class Strokes {
  #stroke = null;
  #links = null; // neighbours of the vertices of the faces at hand
  #faces = null;

  constructor(canvas, viewer, tool, edit) {
    Object.assign(this, {canvas, viewer, tool, edit});
    canvas.addEventListener('pointermove', event => this.#move(event));
    canvas.addEventListener('pointerup', event => this.#end(event));
    canvas.addEventListener('pointercancel', event => this.#end(event));
    canvas.addEventListener('pointerleave', () => this.#ring(null));
  }

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
    const point = this.#point(event.offsetX, event.offsetY);
    if (!point) return false;
    this.canvas.setPointerCapture(event.pointerId);
    this.#begin(event);
    this.#dab(point);
    this.#paint();
    return true;
  }

  /** Paints one dab in the middle of the surface, or else of the first shape. */
  dabInTheMiddle() {
    const places = this.viewer.rectangles().map(r => [r.left + r.width / 2, r.top + r.height / 2]);
    const point = this.#point(...places[1]) ?? this.#point(...places[0]);
    if (!point || !this.#paints()) return;
    this.#begin({pointerId: -1, offsetX: 0, offsetY: 0});
    this.#dab(point);
    this.#end({pointerId: -1});
  }

  #point(x, y) {
    const ray = this.viewer.ray(x, y), hit = ray && meet(ray);
    return hit && pointOf(this.edit.faces(), this.viewer.home, hit);
  }

  #paints() { return ['bulge', 'dent', 'erase'].includes(this.tool().tool); }

  #radius() { return .3 * this.tool().size; }

  #ring(point) {
    this.viewer.uniforms.brush.value.set(...(point ?? [0, 0, 0]), point ? this.#radius() : 0);
    this.viewer.redraw();
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
      this.#ring(isFree ? this.#point(event.offsetX, event.offsetY) : null);
      return;
    }
    const {offsetX: x, offsetY: y} = this.#stroke.event;
    const right = event.offsetX - x, down = event.offsetY - y;
    const parts = Math.min(Math.max(Math.ceil(Math.hypot(right, down) / 10), 1), 12);
    let point = null;
    for (let i = 1; i <= parts; ++i) {
      point = this.#point(x + right * i / parts, y + down * i / parts);
      if (point) this.#dab(point);
    }
    this.#stroke.event = event;
    this.#ring(point);
    this.#paint();
  }

  #end(event) {
    if (this.#stroke?.event.pointerId !== event.pointerId) return;
    const rho = this.#rho();
    this.#stroke = null;
    this.edit.finish(rho);
  }
}
