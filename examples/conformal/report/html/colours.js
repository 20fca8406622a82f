/* Copyright (c) 2026 The Conformal Geometry Processing authors
   SPDX-License-Identifier: LGPL-3.0-or-later */

// The colours of surfaces and charts, and how numbers are written.

const heat = ['#f4f1e6', '#f8d884', '#f0913f', '#c8372f', '#5a1230'];
const cold = ['#2c5a9c', '#8fb4d9', '#f4f1ec', '#f0ab72', '#a8441a'];

/** The colour at a share in [0, 1] between the stops. */
function colour(stops, share) {
  const place = Math.min(Math.max(share, 0), 1) * (stops.length - 1);
  const i = Math.min(Math.floor(place), stops.length - 2), t = place - i;
  const channel = k => [stops[i], stops[i + 1]]
      .map(stop => parseInt(stop.slice(1 + 2 * k, 3 + 2 * k), 16));
  const mixed = [0, 1, 2].map(channel).map(([a, b]) => Math.round(a + t * (b - a)));
  return `rgb(${mixed.join(' ')})`;
}

/** Six digits, as short as can be. */
const number = (value, digits = 6) =>
    typeof value === 'number' ? String(Number(value.toPrecision(digits))) : String(value);

const escape = words => String(words).replace(/[&<>"]/g, c => `&#${c.charCodeAt(0)};`);

/** Shows colours between the words for their ends, or nothing; the policy of the pages forbids styles in
    HTML. */
function showLegend(legend) {
  const bar = document.createElement('i');
  if (legend) bar.style.background = `linear-gradient(90deg,${legend[1]})`;
  document.getElementById('legend').replaceChildren(...(legend ? [legend[0], bar, legend[2]] : []));
}
