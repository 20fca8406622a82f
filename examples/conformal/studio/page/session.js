/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// One shape while it is edited: its states, and who computes them. A state has the points `base`, the
// `steps` that led there, and one step from there on: either `rho`, times `amplitude`, or `targets`, a
// list of {vertex, to}, both within `bound`, or `flowed`, a number of steps of the flow. Once that is computed, it `isDone`, with what came of it.

const isZero = rho => rho.every(value => value === 0);

function freshState(base, faceCount, steps, bound) {
  return {base, steps, rho: new Float64Array(base.length / 3), amplitude: 1, bound, targets: [], flowed: 0,
          after: base, quality: new Float32Array(faceCount).fill(1), report: null, isDone: true};
}

/** The steps from the shape of the page to what a state shows. */
function stepsOf(state) {
  const {steps, rho, amplitude, bound, targets, flowed} = state, kind = kindOf(state);
  const step = {flow: {kind, steps: flowed}, deform: {kind, targets, bound}, spin: {kind, rho, amplitude, bound}}[kind];
  return step ? [...steps, step] : steps;
}

/** What the last step of a state is, if there is one. */
function kindOf({rho, targets, flowed}) {
  return flowed > 0 ? 'flow' : targets.length ? 'deform' : isZero(rho) ? null : 'spin';
}

const amounts = ({rho, amplitude}) => rho.map(value => value * amplitude);

/** `show(state, stage)` is called whenever there is something else to see, with the stage `preview`,
    `computing` or `exact`; `fail(error)` when nothing came of it. */
class Session {
  #version = 0;     // of what may be shown
  #isHeld = false;
  #computed = null; // the state of which the exact result is being computed
  #started = 0;
  #isPreviewing = false;
  #wanted = null;   // the state of the next preview
  #continues = false;
  #seen = {};       // what the last preview has shown

  constructor(shape, kernels, bound, {show, fail}) {
    this.shape = shape;
    this.kernels = kernels; // {quick, exact}
    this.show = show;
    this.fail = fail;
    this.history = new History(freshState(shape.points, shape.faces.length / 3, [], bound));
  }

  get state() { return this.history.state; }

  /** The state with which an edit of that kind begins: what was done in another way is its base. */
  ground(kind) {
    const state = this.state, {length} = this.shape.faces;
    return ![null, kind].includes(kindOf(state)) ? freshState(state.after, length / 3, stepsOf(state), state.bound) : state;
  }

  /** An edit begins: what is still computed is not shown until it ends. */
  hold() {
    ++this.#version;
    this.#isHeld = true;
    this.#seen = {};
  }

  /** Ends an edit that came to nothing. */
  release() {
    if (this.#isHeld) this.refresh();
  }

  /** Another session is shown from here on, until the next refresh(). */
  leave() {
    this.hold();
    if (this.#computed) this.kernels.exact.restart();
  }

  /** Approximates an edit that is under way. */
  preview(state) {
    this.#wanted = state;
    if (!this.#isPreviewing) this.#previewNext();
  }

  async #previewNext() {
    const state = this.#wanted, version = this.#version;
    this.#wanted = null;
    this.#isPreviewing = true;
    const goesOn = ({after, quality, report}) => {
      if (version !== this.#version) return false;
      this.#seen = {after, quality, report};
      this.show({...state, ...this.#seen}, 'preview');
      return !this.#wanted;
    };
    try {
      goesOn(await this.#approximate(state, goesOn));
      this.#continues = true;
    } catch {
      this.#continues = false; // the exact result tells what is wrong
    }
    this.#isPreviewing = false;
    if (this.#wanted) this.#previewNext();
  }

  #approximate(state, goesOn) {
    const {base, flowed, targets, bound} = state, {faces} = this.shape, {quick} = this.kernels;
    const continues = this.#continues, kind = kindOf(state);
    return kind === 'flow' ? quick.flow(base, faces, flowed, goesOn)
        : kind === 'deform' ? quick.deform(base, faces, targets, bound, continues)
        : quick.preview(base, faces, amounts(state), bound, continues);
  }

  /** Takes an edit over, and computes it. One of nothing, after what was done in another way, is none. */
  commit(state) {
    if (!kindOf(state) && state.base !== this.state.base) return this.refresh();
    this.history.add({...state, ...this.#seen, isDone: false});
    this.#seen = {};
    this.refresh();
  }

  undo() {
    if (!this.history.canUndo) return;
    this.history.undo();
    this.refresh();
  }

  redo() {
    if (!this.history.canRedo) return;
    this.history.redo();
    this.refresh();
  }

  /** Shows the present state, computed if it is not. */
  refresh() {
    ++this.#version;
    this.#isHeld = false;
    this.#wanted = null;
    this.#continues &&= !this.state.isDone;
    if (!this.state.isDone && !kindOf(this.state))
      this.history.complete(this.state, {...freshState(this.state.base, this.shape.faces.length / 3,
                                                       this.state.steps, this.state.bound)});
    this.show(this.state, this.state.isDone ? 'exact' : 'computing');
    this.#computeNext();
  }

  /** Computes the present state; what has taken long for another one is given up. */
  #computeNext() {
    if (this.#isHeld || this.state.isDone || this.#computed === this.state) return;
    if (!this.#computed) this.#compute();
    else if (performance.now() - this.#started > 1500) this.kernels.exact.restart();
  }

  async #compute() {
    const state = this.#computed = this.state, isShown = () => this.state === state && !this.#isHeld;
    this.#started = performance.now();
    try {
      const tell = answer => {
        if (isShown()) this.show({...state, ...answer}, 'computing');
        return true;
      };
      const {after, quality, report, memory} = await this.#exact(state, tell), wasShown = isShown();
      const completed = this.history.complete(state, {after, quality, report, memory, isDone: true});
      if (wasShown) {
        ++this.#version; // previews come too late now
        this.show(completed, 'exact');
      }
    } catch (error) {
      if (isShown()) this.fail(error);
    }
    this.#computed = null;
    if (this.state !== state) this.#computeNext();
  }

  #exact(state, tell) {
    const {base, flowed, bound, targets} = state, {faces} = this.shape, {exact} = this.kernels;
    return {flow: () => exact.flow(base, faces, flowed, tell), deform: () => exact.deform(base, faces, targets, bound, false),
            spin: () => exact.transform(base, faces, amounts(state), bound)}[kindOf(state)]();
  }
}
