/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// Charts as SVG.

/** Round numbers, about five, that cover an interval. */
function ticks(low, high) {
  const rough = (high - low) / 5 || 1;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map(k => k * power).find(s => s >= rough * .999);
  const first = Math.ceil(low / step - 1e-9), last = Math.floor(high / step + 1e-9);
  return Array.from({length: last - first + 1}, (_, i) => (first + i) * step);
}

const frame = {width: 560, height: 240, left: 58, right: 14, top: 26, bottom: 42};

/** Where values are in a chart, x and y from `low` to `high`. */
function axes(x, y) {
  const place = (value, {low, high}, begin, end) =>
      begin + (value - low) / (high - low || 1) * (end - begin);
  return {
    x: value => place(value, x, frame.left, frame.width - frame.right),
    y: value => place(value, y, frame.height - frame.bottom, frame.top)
  };
}

/** The grid of a chart with its labels, around what it shows. */
function chart(x, y, to, content) {
  const base = frame.height - frame.bottom, end = frame.width - frame.right;
  const rows = (y.ticks ?? ticks(y.low, y.high)).map(value => `
    <line class="grid" x1="${frame.left}" x2="${end}" y1="${to.y(value)}" y2="${to.y(value)}"/>
    <text x="${frame.left - 8}" y="${to.y(value) + 4}" text-anchor="end">${y.words(value)}</text>`);
  const columns = (x.ticks ?? ticks(x.low, x.high)).map(value => `
    <text x="${to.x(value)}" y="${base + 17}" text-anchor="middle">${x.words(value)}</text>`);
  return `<svg viewBox="0 0 ${frame.width} ${frame.height}" role="img" aria-label="${y.name}">
    ${rows.join('')}${content}
    <line class="axis" x1="${frame.left}" x2="${end}" y1="${base}" y2="${base}"/>
    ${columns.join('')}
    <text x="${frame.left}" y="11">${y.name}</text>
    <text x="${end}" y="${base + 35}" text-anchor="end">${x.name}</text></svg>`;
}

/** Where words go beside a mark: to its right, if there is room. */
const besides = x => x < frame.width - 110 ? `x="${x + 5}"` : `x="${x - 5}" text-anchor="end"`;

/** How much of the area has which value, with marks [name, value]; the first and the last bar also
    have what is beyond. */
function histogram(values, x, ramp, marks) {
  const bins = 40, share = new Array(bins).fill(0), step = (x.high - x.low) / bins;
  values.forEach((value, f) => {
    const bin = Math.floor((value - x.low) / step);
    share[Math.min(Math.max(bin, 0), bins - 1)] += 100 * areasBefore.areas[f] / areasBefore.total;
  });
  const y = {low: 0, high: Math.max(...share) * 1.08, name: '% of the area', words: number};
  const to = axes(x, y), width = to.x(x.low + step) - to.x(x.low);
  const bars = share.map((value, i) => `<rect x="${to.x(x.low + step * i) + .5}" width="${width - 1}"
      y="${to.y(value)}" height="${to.y(0) - to.y(value)}" fill="${colour(ramp, (i + .5) / bins)}"
      stroke="rgb(29 39 51 / .25)" stroke-width=".5"/>`);
  const lines = marks.filter(([, value]) => value >= x.low && value <= x.high)
      .map(([name, value], i) => `
    <line class="mark" x1="${to.x(value)}" x2="${to.x(value)}" y1="${frame.top - 8}" y2="${to.y(0)}"/>
    <text class="strong" ${besides(to.x(value))} y="${frame.top + 2 + 15 * i}">${name}
      ${x.words(value)}</text>`);
  return chart(x, y, to, bars.join('') + lines.join(''));
}

const histogramOfAngles = high => histogram(quality,
  {low: 1, high, name: 'Q, the ratio of stretches (1: angles are kept)', words: value => number(value, 4)},
  heat, [['mean', at('result/quasi_conformal/mean')], ['99 %', at('result/quasi_conformal/p99')]]);

/** On a logarithmic scale, in octaves. */
const histogramOfScales = () => histogram(scales.map(Math.log2),
  {low: -4, high: 4, name: 'scale of lengths, at equal total area', words: value => number(2 ** value, 3),
   ticks: [-4, -3, -2, -1, 0, 1, 2, 3, 4]},
  cold, [['1 %', Math.log2(quantile(scales, .01, areasBefore))],
         ['99 %', Math.log2(quantile(scales, .99, areasBefore))]]);

/** A curve through points {x, y}, on a logarithmic scale where y spans more than a factor of 30. */
function curve(points, xName, yName) {
  const values = points.map(point => point.y);
  const least = Math.min(...values), most = Math.max(...values);
  const isWide = least > 0 && most > 30 * least;
  const scaled = isWide ? Math.log10 : value => value;
  const spread = scaled(most) - scaled(least) || Math.abs(scaled(most)) * .1 || 1;
  const y = {low: scaled(least) - .06 * spread, high: scaled(most) + .08 * spread, name: yName,
             words: value => number(isWide ? 10 ** value : value, 3)};
  const x = {low: points[0].x, high: points[points.length - 1].x, name: xName, words: number};
  const isSteps = points.every(point => Number.isInteger(point.x));
  if (isSteps) x.ticks = ticks(x.low, x.high).filter(Number.isInteger);
  const to = axes(x, y);
  const places = points.map(point => [to.x(point.x), to.y(scaled(point.y))]);
  return chart(x, y, to, `<polyline class="line" points="${places.join(' ')}"/>` +
    places.map(([left, top], i) => `<circle class="dot" cx="${left}" cy="${top}" r="3.5">
      <title>${number(points[i].x)}: ${number(points[i].y)}</title></circle>`).join(''));
}
