/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// What has been done: states that are never changed, with undo and redo.

const deepest = 60; // states that can be undone

class History {
  #past = [];
  #future = [];

  constructor(state) {
    this.state = state;
  }

  add(state) {
    this.#past.push(this.state);
    if (this.#past.length > deepest) this.#past.shift();
    this.#future = [];
    this.state = state;
  }

  /** Completes a state by what was computed for it. */
  complete(state, result) {
    const completed = {...state, ...result}, of = other => other === state ? completed : other;
    this.state = of(this.state);
    this.#past = this.#past.map(of);
    this.#future = this.#future.map(of);
    return completed;
  }

  get canUndo() { return this.#past.length > 0; }
  get canRedo() { return this.#future.length > 0; }

  undo() {
    this.#future.push(this.state);
    this.state = this.#past.pop();
  }

  redo() {
    this.#past.push(this.state);
    this.state = this.#future.pop();
  }
}
