/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// Makes the page work.

const listen = (id, event, act) => element(id).addEventListener(event, act);

function listenToBrush() {
  for (const button of element('tools').querySelectorAll('button'))
    button.addEventListener('click', () => chooseTool(button.dataset.tool));
  for (const id of ['size', 'strength']) {
    element(id).value = brush[id];
    listen(id, 'input', () => brush[id] = Number(element(id).value));
  }
  listen('symmetric', 'change', () => brush.symmetric = element('symmetric').checked);
}

function applyFormula(event) {
  event.preventDefault();
  const help = element('formula-help');
  try {
    const state = session.ground('spin');
    const rho = evaluate(element('formula').value, state.base, session.shape.faces);
    help.textContent = 'in x, y, z and the normal nx, ny, nz';
    help.classList.remove('poor');
    element('invitation').hidden = true;
    session.commit({...state, rho, amplitude: 1});
  } catch (error) {
    help.textContent = error.message;
    help.classList.add('poor');
  }
}

function listenToPaint() {
  listen('undo', 'click', () => session.undo());
  listen('redo', 'click', () => session.redo());
  listen('clear', 'click', () => {
    if (kindOf(session.state) === 'deform') pull.finish([]);
    else edit.finish(new Float64Array(session.state.rho.length));
  });
  const scaled = () => ({...session.ground('spin'), amplitude: Number(element('amount').value)});
  listen('amount', 'input', () => {
    element('amount-value').textContent = number(scaled().amplitude, 3);
    session.hold();
    if (session.state.flowed === 0) session.preview(scaled());
  });
  listen('amount', 'change', () => session.commit(scaled()));
  listen('formula-form', 'submit', applyFormula);
  listen('bound', 'change', () => session.commit({...session.state, bound: Number(element('bound').value) || 0}));
}

function listenToFlow() {
  const flowed = steps => ({...session.ground('flow'), flowed: steps, report: null});
  const chosen = () => flowed(Number(element('time').value));
  listen('flow', 'click', () => session.commit(flowed(session.ground('flow').flowed + 1)));
  listen('time', 'input', () => {
    tellTime(chosen().flowed);
    session.hold();
    session.preview(chosen());
  });
  listen('time', 'change', () => session.commit(chosen()));
}

/** A slider that comes back to where it was held has no `change`. */
function listenToSliders() {
  for (const id of ['amount', 'time'])
    for (const event of ['pointerup', 'pointercancel'])
      listen(id, event, () => setTimeout(() => session.release()));
}

function listenToSaving() {
  const name = () => `${stem(session.shape.file)}_edited`;
  listen('save-ply', 'click', () => save(`${name()}.ply`, toPly(session.state.after, session.shape.faces, amounts(session.state))));
  listen('save-obj', 'click', () => save(`${name()}.obj`, [toObj(session.state.after, session.shape.faces)]));
  listen('save-glb', 'click', () => save(`${name()}.glb`, toGlb(session.state.after, session.shape.faces)));
  listen('save-before', 'click', () => save(`${stem(session.shape.file)}.obj`, [toObj(session.shape.points, session.shape.faces)]));
  listen('save-rho', 'click', () => stepsOf(session.state).forEach((step, i, steps) => {
    const content = {spin: toRhoFile, deform: toTargetFile}[step.kind]?.(session.shape, step.rho ?? step.targets);
    if (content) save(stepFile(session.shape, steps, i), [content]);
  }));
  listen('copy', 'click', () => navigator.clipboard?.writeText(element('command').textContent));
}

function listenToKeys() {
  const tools = {b: 'bulge', d: 'dent', e: 'erase', p: 'pull', t: 'turn'};
  const resize = factor => {
    brush.size = Math.min(Math.max(brush.size * factor, .04), .9);
    element('size').value = brush.size;
  };
  document.addEventListener('keydown', event => {
    if (event.target.matches('input[type=text], select')) return;
    const key = event.key.toLowerCase();
    if (event.ctrlKey || event.metaKey) {
      if (key === 'z' && !event.shiftKey) session.undo();
      else if (key === 'y' || key === 'z') session.redo();
      else return;
    } else if (tools[key]) chooseTool(tools[key]);
    else if (key === '[') resize(1 / 1.2);
    else if (key === ']') resize(1.2);
    else if (key === 'enter' && event.target === element('canvas')) strokes.dabInTheMiddle();
    else return;
    event.preventDefault();
  });
}

function listenToView() {
  for (const button of element('modes').querySelectorAll('button'))
    button.addEventListener('click', () => chooseMode(Number(button.dataset.mode)));
  listen('edges', 'change', () => {
    viewer.uniforms.edges.value = element('edges').checked;
    viewer.redraw();
  });
  for (const event of ['pointermove', 'pointerdown']) listen('canvas', event, tellDrag);
}

/** Shows what a drag that begins here does, by the pointer; while it turns, in words. */
function tellDrag(event) {
  if (event.type === 'pointermove' && event.buttons !== 0) return;
  const drag = strokes.hits(event) ? 'paint' : pulls.hits(event) ? 'pull' : 'turn';
  element('canvas').dataset.drag = drag;
  element('gesture').textContent = brush.tool === 'turn' ? '' : 'Turning. To edit, begin on the shape';
  element('gesture').hidden = brush.tool === 'turn';
}

function offerShapes() {
  element('shape-choice').hidden = studio.shapes.length < 2;
  studio.shapes.forEach(({name}, k) => element('shape').add(new Option(name, k)));
  listen('shape', 'change', () => {
    element('file-words').hidden = element('repair').hidden = true;
    chooseShape(Number(element('shape').value));
  });
}

async function start() {
  const code = URL.createObjectURL(new Blob([text('three')], {type: 'text/javascript'}));
  viewer = makeViewer(await import(code), element('canvas'), ranges, event => strokes.takes(event) || pulls.takes(event));
  strokes = new Strokes(element('canvas'), element('ring'), viewer, () => brush, edit);
  viewer.onDraw = placePins;
  pulls = new Pulls(element('canvas'), viewer, () => brush, pull);
  offerShapes();
  listenToBrush();
  listenToPaint();
  listenToFlow();
  listenToSliders();
  listenToSaving();
  listenToKeys();
  listenToView();
  listenToFiles();
  chooseTool('bulge');
  chooseShape(0);
  chooseMode(0);
}

start().catch(error => {
  element('no-canvas').hidden = false;
  element('no-canvas').textContent = `The shapes cannot be shown: ${error.message}`;
});
