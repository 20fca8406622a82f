/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// The colours of surfaces and charts, and how numbers are written.

const heat = ['#f4f1e6', '#f8d884', '#f0913f', '#c8372f', '#5a1230'];
const cold = ['#2c5a9c', '#8fb4d9', '#f4f1ec', '#f0ab72', '#a8441a'];

/** What is shown of faces whose lengths have shrunk below that share: nobody sees them on the surface after. */
const collapsed = {below: .1, colour: '#c400a8'};

/** Words on the share of the area that has collapsed, if there is any; `scales` as `areas` of faces. */
function wordsOnCollapse(scales, {areas, total}) {
  const share = scales.reduce((sum, scale, f) => sum + (scale < collapsed.below ? areas[f] : 0), 0) / total;
  return share > 0 ? `below a tenth: ${number(100 * share, 2)} % of the area` : '';
}

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

/** Shows colours between the words for their ends, or mere words, or nothing, and words on what has collapsed, if there are any;
    the policy of the pages forbids styles in HTML. */
function showLegend(legend, collapse = '') {
  const bar = document.createElement('i'), mark = document.createElement('b');
  const isRange = Array.isArray(legend);
  if (isRange) bar.style.background = `linear-gradient(90deg,${legend[1]})`;
  mark.style.background = collapsed.colour;
  document.getElementById('legend').replaceChildren(...(isRange ? [legend[0], bar, legend[2]] : [legend ?? '']),
                                                    ...(collapse ? [mark, collapse] : []));
}
