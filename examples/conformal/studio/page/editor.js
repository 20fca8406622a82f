/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// Connects the inputs of the page with the session of the shape at hand.

const modes = ['squares', 'angles', 'sizes', 'paint', 'plain'];
const ranges = {highest: 1.1, widest: 3, deepest: 3};
const instructions = {
  bulge: 'Drag on a shape: where you paint, it bulges, and every angle stays as it was.',
  dent: 'Drag on a shape: where you paint, it is dented, and every angle stays as it was.',
  erase: 'Drag over paint to take it away again.',
  pull: 'Drag a point of the surface on the right; pins hold it elsewhere. Click to add a pin.', turn: 'Drag to turn both shapes.'
};

const brush = {tool: 'bulge', size: .5, strength: 4, symmetric: false};
const sessions = new Map(), kernels = {quick: new Kernels(), exact: new Kernels()};
let shownBase = null, shownPins = [], collapse = ''; // words on it
let session = null, viewer = null, strokes = null, pulls = null;

function press(group, isPressed) {
  for (const button of element(group).querySelectorAll('button'))
    button.setAttribute('aria-pressed', isPressed(button));
}

function chooseTool(tool) {
  brush.tool = tool;
  press('tools', button => button.dataset.tool === tool);
  element('instruction').textContent = instructions[tool];
}

function chooseMode(mode) {
  viewer.modes = [3, mode];
  press('modes', button => Number(button.dataset.mode) === mode);
  tellColours();
  viewer.redraw();
}

const legends = ['squares stay squares: no angle changes', ['1', heat, '1.1 and more'], ['÷ 3', cold, '× 3'],
                 ['dent', cold, 'bulge'], null];

/** What the colours of the surface mean; what has collapsed is marked where it was painted, too. */
function tellColours() {
  showLegend(legends[viewer.modes[1]], collapse);
}

function showPaint(rho) {
  viewer.uniforms.deepest.value = Math.max(ranges.deepest, rho.reduce((m, x) => Math.max(m, Math.abs(x)), 0));
  viewer.change({rho});
}

function showPoints(state) {
  const {faces} = session.shape, {base, after, quality} = state, isInPlace = kindOf(state) === 'deform';
  const areas = areasOf(faces, base), scales = Float32Array.from(scalesOf(areas, areasOf(faces, after)));
  viewer.change({after, quality, isInPlace, scales});
  collapse = wordsOnCollapse(scales, areas);
  tellColours();
}

/** Puts the pins where their targets are seen. */
function placePins() {
  element('pins').replaceChildren(...shownPins.map(({to}) => {
    const pin = document.createElement('i'), {x, y} = viewer.project(to);
    pin.style.left = `${x}px`;
    pin.style.top = `${y}px`;
    return pin;
  }));
}

/** Shows a state: what is known of it. */
function show(state, stage) {
  const {faces, squares} = session.shape;
  if (shownBase !== state.base) {
    const turn = shownBase ? viewer.pose.turn.clone() : null;
    viewer.show({faces, squares, before: state.base, after: state.base, quality: state.quality,
                 scales: new Float32Array(faces.length / 3).fill(1), rho: state.rho});
    if (turn) viewer.pose.turn.copy(turn);
    shownBase = state.base;
  }
  showPaint(amounts(state));
  showPoints(state);
  shownPins = state.targets;
  if (state.report) tellReport(state.report, faces.length / 3, stage);
  else if (stage === 'exact') tellNothing();
  else tellVerdict(stages[stage]);
  element('json').textContent = stage === 'exact' && state.report ? JSON.stringify(state.report, null, 1) : '';
  showInputs(stage === 'exact');
  if (stage !== 'preview') showSliders(); // which are under the hand until then
  if (stage === 'exact') viewer.fit();
  document.body.dataset.state = stage;
  if (state.memory) document.body.dataset.memory = state.memory;
}

function tellNothing() {
  fillTable(element('numbers'), []);
  tellVerdict({kind: '', words: 'Nothing painted yet', reason: 'What you paint is computed exactly when you let go.', isFirst: true});
}

function showInputs(isExact) {
  const {state, history, shape} = session, steps = stepsOf(state);
  const isGood = isExact && state.report?.verified === true;
  element('undo').disabled = !history.canUndo;
  element('redo').disabled = !history.canRedo;
  element('clear').disabled = !['spin', 'deform'].includes(kindOf(state));
  element('bound').value = state.bound > 1 ? String(state.bound) : 'none';
  element('flow').disabled = !isExact || state.report?.verified === false;
  element('energy').textContent = state.flowed > 0 && state.report?.result.energy ? wordsOnEnergy(state) : '';
  for (const id of ['save-ply', 'save-obj', 'save-glb']) element(id).disabled = !isGood;
  element('save-rho').disabled = element('clear').disabled;
  element('save-rho').textContent = kindOf(state) === 'deform' ? 'Pins' : 'Paint';
  element('command').textContent = steps.length ? commandsOf(shape, steps) : 'Paint something first.';
}

function showSliders() {
  const {state} = session;
  element('amount').disabled = kindOf(state) !== 'spin';
  element('amount').value = state.amplitude;
  element('amount-value').textContent = number(state.amplitude, 3);
  element('time').disabled = kindOf(state) !== 'flow' && state.report?.verified === false;
  element('time').max = Math.max(12, state.flowed);
  element('time').value = state.flowed;
  tellTime(state.flowed);
}

const tellTime = steps => element('time-value').textContent = steps === 1 ? '1 step' : `${steps} steps`;

function wordsOnEnergy({report: {result}}) {
  const [initial, final] = ['initial', 'final'].map(when => number(result.energy[when] / (4 * Math.PI), 3));
  const end = result.converged ? ` It has settled after ${result.steps} steps.` : '';
  return `Bending energy ${initial} → ${final} times that of a sphere.${end}`;
}

function fail(error) {
  tellVerdict({kind: 'poor', words: 'Refused', reason: error.message});
  document.body.dataset.state = 'failed';
}

/** Edits of rho, for strokes. */
const edit = {
  faces: () => session.shape.faces,
  ground: () => {
    element('invitation').hidden = true;
    session.hold();
    return session.ground('spin').rho;
  },
  paint: rho => {
    const state = {...session.ground('spin'), rho};
    if (state.base === shownBase) showPaint(amounts(state));
    session.preview(state);
  },
  finish: rho => session.commit({...session.ground('spin'), rho}),
  cancel: () => session.refresh()
};

/** Edits of targets, for pulls. */
const pull = {
  faces: () => session.shape.faces,
  ground: () => {
    element('invitation').hidden = true;
    session.hold();
    return session.ground('deform');
  },
  show: targets => {
    shownPins = targets;
    viewer.redraw();
    session.preview({...session.ground('deform'), targets});
  },
  finish: targets => session.commit({...session.ground('deform'), targets}),
  cancel: () => session.refresh()
};

function chooseShape(k) {
  if (!sessions.has(k)) sessions.set(k, new Session(shapeOf(k), kernels, studio.bound, {show, fail}));
  session?.leave();
  session = sessions.get(k);
  shownBase = null;
  session.refresh();
}
