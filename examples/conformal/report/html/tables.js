/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// The report in words: heading, certificate, seconds, and the way there.

const names = {
  'quasi_conformal/mean': 'Quasi-conformal error Q, mean', 'quasi_conformal/p99': 'Q, 99 % of the area',
  'quasi_conformal/max': 'Q, largest', 'length_cross_ratio/rms': 'Log length cross-ratio change, rms',
  'length_cross_ratio/max': 'Log length cross-ratio change, largest',
  'scale/min': 'Scale of lengths, least', 'scale/max': 'Scale of lengths, largest',
  'flipped_faces': 'Flipped faces', 'eigenvalue': 'Eigenvalue γ (1/length)',
  'next_eigenvalue': 'Next eigenvalue', 'residual': 'Residual of the eigenvector',
  'gap': 'Gap to the next eigenvalue', 'iterations': 'Iterations',
  'closure_residual': 'Closure residual', 'period_defect': 'Period defect',
  'min_spin_ratio': 'Least by largest |λ|', 'overlap': 'Overlap with the start',
  'substeps': 'Substeps', 'spectral_shift': 'Spectral shift', 'generalized': 'Generalized problem',
  'steps': 'Steps', 'reached': 'Share of the change reached',
  'missing_share': 'Left out to close handles, share of the norm of rho',
  'realised_curvature/share': 'Measured change of curvature, share of the norm of rho',
  'realised_curvature/correlation': 'Correlation of that change with rho',
  'realised_curvature/wrong_sign': 'Share of the area where that change has the wrong sign',
  'realised_share': 'Realised share of the norm of rho', 'stop': 'Stopped because',
  'converged': 'Energy has settled', 'energy/initial': 'Willmore energy before',
  'energy/final': 'Willmore energy after', 'radius/mean': 'Mean radius',
  'radius/deviation': 'Deviation of the radius by its mean',
  'willmore_energy/before': 'Willmore energy before', 'willmore_energy/after': 'Willmore energy after',
  'similarity_distance/rms': 'Distance from similar, rms', 't': 't'
};

/** The places of all numbers and words below a place, in their order. */
function leaves(value, place) {
  if (value === null || typeof value !== 'object' || Array.isArray(value)) return [place];
  return Object.keys(value).flatMap(key => leaves(value[key], `${place}/${key}`));
}

const words = value => value === null ? 'not a number'
  : Array.isArray(value) ? value.map(v => number(v)).join(' ')
  : typeof value === 'boolean' ? (value ? 'yes' : 'no') : number(value);

const cell = (place, value) => `<td data-place="${escape(place)}">${escape(words(value))}</td>`;

function certificate() {
  const known = Object.keys(names).map(name => `result/${name}`);
  const all = leaves(report.result ?? {}, 'result');
  const sorted = known.filter(place => all.includes(place))
      .concat(all.filter(place => !known.includes(place)));
  const label = place => names[place.slice(7)] ?? place.slice(7).replace(/[/_]/g, ' ');
  const rows = sorted.map(place => `<tr><td>${escape(label(place))}</td>${cell(place, at(place))}</tr>`);
  const again = mean(recomputedQuality());
  rows.push(`<tr><td>Q, mean, computed again by this page from both shapes</td>
    ${cell('recomputed/quasi_conformal/mean', again)}</tr>`);
  return rows.join('');
}

function seconds() {
  const stages = Object.entries(report.seconds ?? {});
  return stages.map(([stage, value]) =>
      `<tr><td>${escape(stage)}</td><td data-place="seconds/${escape(stage)}">${number(value, 3)} s</td></tr>`).join('');
}

function options() {
  return Object.entries(report.options ?? {}).map(([name, value]) =>
      `<tr><td>--${escape(name)}</td><td>${escape(words(value))}</td></tr>`).join('');
}

function lead() {
  const {vertices, faces: count, boundary_loops: loops, genus} = report.input ?? {};
  const shape = [];
  if (loops !== null && loops !== undefined)
    shape.push(loops === 0 ? 'closed' : loops === 1 ? 'one boundary loop' : `${loops} boundary loops`);
  if (genus !== null && genus !== undefined) shape.push(`genus ${genus}`);
  const counts = `${Number(vertices).toLocaleString('en')} vertices, ${Number(count).toLocaleString('en')} faces`;
  return [counts, ...shape].join(', ') + '.';
}

/** Curves of the steps of a flow, or of the frames of a blend; empty if there are none. */
function way() {
  const steps = (report.steps ?? []).filter(step => typeof step.energy === 'number');
  const isBlend = steps.length > 1 && steps.every(step => typeof step.t === 'number');
  const start = at('result/energy/initial');
  const energies = steps.map((step, i) =>
      ({x: isBlend ? step.t : step.step ?? i + 1, y: step.energy / (4 * Math.PI)}));
  if (!isBlend && typeof start === 'number') energies.unshift({x: 0, y: start / (4 * Math.PI)});
  if (energies.length < 2) return '';
  const errors = steps.map((step, i) =>
      ({x: energies[energies.length - steps.length + i].x,
        y: step.quasi_conformal?.total?.mean ?? step.quasi_conformal?.mean}));
  if (!isBlend) errors.unshift({x: 0, y: 1});
  const name = isBlend ? 't' : 'step';
  return curve(energies, name, 'Willmore energy / 4π') +
      (errors.every(point => typeof point.y === 'number') ? curve(errors, name, 'mean Q since the input') : '');
}
