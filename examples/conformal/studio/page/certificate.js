/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// The report of a result in words.

function rowsFor(report, faceCount) {
  const r = report.result ?? {}, rows = [];
  const add = (name, value, place, meaning) => rows.push([name, value, place, meaning]);
  add('Mean Q (best: 1)', number(r.quasi_conformal.mean, 5), 'quasi_conformal/mean',
      'Q of a face: its largest stretch by its smallest; 1 where all angles are kept');
  add('Q of the worst face', number(r.quasi_conformal.max, 4), 'quasi_conformal/max', 'That of the most distorted face');
  const scales = r.scale_control ?? {low: r.scale.min, high: r.scale.max};
  add('Lengths', `× ${number(scales.low, 2)} – ${number(scales.high, 3)}`, 'scale', 'How lengths on the surface have changed');
  if (r.closure_residual !== undefined) add('Closing error', number(r.closure_residual, 2), 'closure_residual',
      'How much the triangles had to give way to fit together');
  add('Flipped faces', `${r.flipped_faces} of ${faceCount.toLocaleString('en')}`, 'flipped_faces',
      'Faces that look into the body');
  const realised = r.realised_curvature;
  if (realised && report.command !== 'deform') add('Realised of the paint', `${number(100 * realised.share, 3)} %`, 'realised_curvature',
      `Measured on the new surface; correlation with the paint: ${number(realised.correlation, 2)}`);
  const control = r.scale_control;
  if (control?.weight > 0 && report.command !== 'deform') add('Kept of the paint', `${number(100 * control.kept_norm, 3)} %`, 'kept',
      'Sizes are bounded: this much of the paint is possible within the bound');
  if (r.realised_share < .995) add('Kept, with handles closed', `${number(100 * r.realised_share, 3)} %`, 'realised',
      'A paint that would tear handles or holes open is replaced by the nearest one that does not');
  return rows;
}

/** What a verdict says: its kind, its words, and the reason. */
function verdictOf(report) {
  if (report.verified) return {kind: 'good', words: 'Verified: angles are kept', reason: ''};
  const [reason, advice] = (report.error ?? 'the result is not finite').split('; try: ');
  const help = advice ? 'Undo, paint less or more softly, or let sizes change less.' : '';
  return {kind: 'poor', words: 'Refused: this is not a conformal surface',
          reason: `${reason[0].toUpperCase()}${reason.slice(1)}. ${help}`};
}

function fillTable(table, rows) {
  table.replaceChildren(...rows.map(([name, value, place, meaning]) => {
    const row = document.createElement('tr');
    row.title = meaning;
    row.insertCell().textContent = name;
    const cell = row.insertCell();
    cell.textContent = value;
    cell.dataset.place = place;
    return row;
  }));
}

/** Beside the numbers, and below the view where those are further down. */
function tellVerdict({kind, words, reason, isFirst}) {
  element('verdict').className = element('told').className = `verdict ${kind}`;
  element('verdict').textContent = words;
  element('told').textContent = isFirst ? '' : words;
  element('reason').textContent = reason;
}

const stages = {
  preview: {kind: '', words: 'Preview', reason: 'It becomes exact when you let go.'},
  computing: {kind: '', words: 'Computing exactly …', reason: ''}
};

/** Shows a report at a stage of the computation; only what is exact is judged. */
function tellReport(report, faceCount, stage) {
  fillTable(element('numbers'), rowsFor(report, faceCount));
  tellVerdict(stages[stage] ?? verdictOf(report));
}
