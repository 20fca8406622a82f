/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// Fills the page in. `#squares`, `#quality`, `#scale`, `#rho` or `#plain` at the end of its address chooses
// what is shown first.

const show = (id, html) => document.getElementById(id).innerHTML = html;
const roundUp = value => 1 + Math.max(.02, Number(((value - 1) * 1.05).toPrecision(2)));

const highest = roundUp(quantile(quality, .995, areasBefore));
const widest = Math.max(1.1, quantile(scales.map(s => Math.max(s, 1 / s)), .99, areasBefore));
const deepest = rho.length ? Math.max(quantile(rho.map(Math.abs), .995, areasBefore), 1e-9) : 1;

const file = report.input?.file ?? report.before?.file ?? '';
document.title = `conformal ${report.command} ${file}`;
show('command', `conformal ${escape(report.command)} · version ${escape(report.version)}`);
show('heading', escape(file.split('/').pop() || 'standard input'));
show('lead', escape(lead()));
show('asked', escape(asked()));
show('tiles', tiles());
show('remarks', remarks());
show('certificate', certificate());
show('seconds', seconds());
show('options', options());
show('histogram', histogramOfAngles(highest));
show('scales', histogramOfScales());
show('json', escape(JSON.stringify(report, null, 2)));
show('squares-note', `The squares are from ${escape(text('squares-of'))}.`);
const curves = way();
if (curves) {
  document.getElementById('way').hidden = false;
  show('way-heading', report.command === 'flow' ? 'Convergence of the flow' : 'The way there');
  show('curves', curves);
}

const legends = {
  squares: null, plain: null,
  quality: ['1', heat, `${number(highest, 3)} and more`],
  rho: [number(-deepest, 3), cold, number(deepest, 3)],
  scale: [`÷ ${number(widest, 3)}`, cold, `× ${number(widest, 3)}`]
};

async function view() {
  const canvas = document.getElementById('canvas');
  const code = URL.createObjectURL(new Blob([text('three')], {type: 'text/javascript'}));
  const viewer = makeViewer(await import(code), canvas, {highest, widest, deepest});
  viewer.show({faces, before, after, squares, quality, scales,
               rho: rho.length ? rho : new Float32Array(faceCount)});
  const buttons = [...document.querySelectorAll('#modes button')];
  buttons.find(button => button.dataset.mode === 'rho').hidden = rho.length === 0;
  const choose = mode => {
    buttons.forEach(button => button.setAttribute('aria-pressed', button.dataset.mode === mode));
    viewer.modes.fill(['squares', 'quality', 'scale', 'rho', 'plain'].indexOf(mode));
    showLegend(legends[mode], wordsOnCollapse(scales, areasBefore));
    viewer.redraw();
  };
  buttons.forEach(button => button.addEventListener('click', () => choose(button.dataset.mode)));
  const wanted = location.hash.slice(1);
  choose(wanted in legends ? wanted : 'squares');
  document.getElementById('edges').addEventListener('change', event => {
    viewer.uniforms.edges.value = event.target.checked;
    viewer.redraw();
  });
  viewer.draw();
  canvas.dataset.drawn = 'yes';
}

view().catch(error => {
  const message = document.getElementById('no-canvas');
  message.hidden = false;
  message.textContent = `The shapes cannot be shown: ${error.message}`;
});
