/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// What was asked, and what came out, for the head of the page. A tile is {value, name, limit, holds}: it is green
// where its limit holds, and has no colour where nothing judges it.

const isNumber = value => typeof value === 'number';
const percent = share => `${number(100 * share, 3)} %`;
const optionAt = name => Number(at(`options/${name}`));
const bound = () => Number(at('result/scale_control/bound') ?? at('options/max-scale'));

/** What the user wanted, in a sentence. */
function asked() {
  const {command, options = {}} = report, {min, max} = at('result/rho') ?? {};
  const from = [['rho-expression', ''], ['rho-file', 'the file '], ['rho-property', 'the property '],
                ['rho-image', 'the picture '], ['paint', 'the picture ']].find(([name]) => options[name]);
  const range = isNumber(min) ? `, from ${number(min, 3)} to ${number(max, 3)} (positive: bulges)` : '';
  const within = bound() > 1 ? `, with lengths within a factor of ${number(bound(), 3)}` : '';
  if (command === 'spin')
    return `Asked: a change of mean curvature ρ${from ? ` = ${from[1]}${options[from[0]]}` : ''}${range}${within}.`;
  if (command === 'flow') return `Asked: at most ${options.steps} steps of the Willmore flow, which smoothes.`;
  if (command === 'flatten') return `Asked: ${askedOfPlane()}.`;
  if (isNumber(at('result/targets/count')))
    return `Asked: ${at('result/targets/count')} vertices at their targets${within}.`;
  return '';
}

function askedOfPlane() {
  const cones = at('result/cones/vertices')?.length, tips = at('result/tips');
  const cut = cones ? `, through ${cones} cones, which keep areas` : tips ? `, cut open through ${tips} tips` : '';
  return `a map to the plane${at('result/method') === 'planar' ? ' by curvature' : ''} that keeps angles${cut}`;
}

/** A number that an upper limit judges, an option of the command. */
function below(value, name, option, show, showLimit = show) {
  const limit = optionAt(option);
  if (!isNumber(value)) return [];
  return [{value: show(value), name, ...limit > 0 && {limit: `limit: ${showLimit(limit)}`, holds: value <= limit}}];
}

/** What is measured on the new surface of the change that was asked for. */
function realisedTiles() {
  const {share, agreement, least_agreement: least, wrong_sign: wrong, left_out: leftOut} =
      at('result/realised_curvature') ?? {};
  if (!isNumber(agreement)) return [];
  const all = [{value: percent(share), name: 'of ρ realised, measured on the new surface',
                limit: `agreement ${percent(agreement)}; limit: at least ${percent(least)}`, holds: agreement >= least},
               {value: percent(wrong), name: 'of the area curves against ρ'}];
  if (leftOut > .005) {
    const isClosing = at('result/missing_share') >= leftOut;
    const [kept, limit] = isClosing ? [at('result/realised_share'), optionAt('realised_share')]
                                    : [at('result/scale_control/kept_norm'), optionAt('kept_norm')];
    all.push({value: percent(leftOut), name: `of ρ left out, for ${isClosing ? 'handles to close' : 'the bound on lengths'}`,
              limit: `kept ${percent(kept)}; limit: at least ${percent(limit)}`, holds: kept >= limit});
  }
  return all;
}

/** By how much lengths change: on 98 % of the area where there is a bound on that, or in all. */
function lengthTile() {
  const {low, high} = at('result/scale_control') ?? {}, {min, max} = at('result/scale') ?? {};
  const words = (a, b) => `× ${number(a, 2)} – ${number(b, 3)}`;
  if (isNumber(low))
    return [{value: words(low, high), name: 'lengths, on 98 % of the area',
             limit: `limit: a factor of ${number(bound(), 3)}`,
             holds: Math.max(high, 1 / low) <= (1 + 1e-9) * bound()}];
  return isNumber(min) ? [{value: words(min, max), name: 'lengths'}] : [];
}

function energyTile() {
  const unit = 4 * Math.PI, [initial, final] = [at('result/energy/initial'), at('result/energy/final')];
  if (!isNumber(final)) return [];
  const settled = at('result/converged');
  return [{value: `${number(initial / unit, 3)} → ${number(final / unit, 3)}`,
           name: `bending energy, 1 for a round sphere${settled ? '; settled' : ''}`}];
}

function targetTile() {
  const largest = at('result/targets/distance/max');
  return isNumber(largest) ? [{value: number(largest, 2), name: 'largest distance from a target'}] : [];
}

function overlapTile() {
  const share = at('result/overlap/share'), charts = at('result/charts');
  const name = charts ? `of the image would overlap: cut into ${charts} charts` : 'of the image overlaps';
  return share > 0 ? [{value: percent(share), name}] : [];
}

function verdictTile() {
  if (typeof report.verified !== 'boolean') return [];
  return [report.verified ? {value: 'Verified', name: 'all limits hold', holds: true}
                          : {value: 'Not verified', name: 'written by --force', holds: false}];
}

function allTiles() {
  const count = at('input/faces') ?? faceCount, flips = at('result/flipped_faces');
  const flipped = below(isNumber(flips) ? flips / count : null, `of ${count.toLocaleString('en')} faces are flipped`,
                        'flipped_share', share => String(Math.round(share * count)), percent);
  return [...verdictTile(), ...realisedTiles(), ...targetTile(), ...energyTile(), ...lengthTile(),
          ...below(at('result/quasi_conformal/mean'), 'mean shear Q; 1 is none', 'quasi_conformal',
                   value => number(value, 4), value => number(value, 3)),
          ...flipped, ...overlapTile(),
          ...below(at('result/scale/collapsed_share') || null, 'of the area shrank below a tenth', 'collapsed_share',
                   percent),
          ...below(at('result/boundary/direction_error/mean'), 'that directions at the boundary are missed by, in the mean',
                   'direction_error', value => `${number(value, 3)}°`),
          ...below(at('result/closure_residual'), 'gap before the surface was closed', 'closure', percent)];
}

function tiles() {
  return allTiles().map(({value, name, limit, holds}) => {
    const kind = holds === undefined ? '' : holds ? 'good' : 'poor';
    const judged = limit ? `<small>${escape(limit)}</small>` : '';
    return `<li class="${kind}"><b>${escape(value)}</b><span>${escape(name)}</span>${judged}</li>`;
  }).join('');
}

/** Why it is not verified, and what was changed without being asked for. */
function remarks() {
  return [report.error, ...report.notes ?? []].filter(Boolean).map(text => `<li>${escape(text)}</li>`).join('');
}
