/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// Formulas as --rho-expression takes them: arithmetic, comparisons, functions, and the choice a ? b : c.

const functions = {
  sin: Math.sin, cos: Math.cos, tan: Math.tan, asin: Math.asin, acos: Math.acos, atan: Math.atan,
  atan2: Math.atan2, sinh: Math.sinh, cosh: Math.cosh, tanh: Math.tanh, asinh: Math.asinh,
  acosh: Math.acosh, atanh: Math.atanh, exp: Math.exp, log2: Math.log2, log10: Math.log10,
  log: Math.log, ln: Math.log, sqrt: Math.sqrt, sign: Math.sign, rint: Math.round, abs: Math.abs,
  min: Math.min, max: Math.max, sum: (...all) => all.reduce((a, b) => a + b),
  avg: (...all) => all.reduce((a, b) => a + b) / all.length,
  gauss: (d, s) => Math.exp(-d * d / (2 * s * s)),
  bump: (d, r) => d * d < r * r ? Math.exp(1 - 1 / (1 - d * d / (r * r))) : 0
};
const constants = {pi: Math.PI, e: Math.E, _pi: Math.PI, _e: Math.E};
const variables = ['x', 'y', 'z', 'nx', 'ny', 'nz'];

const binary = [
  {'||': (a, b) => +(a !== 0 || b !== 0)}, {'&&': (a, b) => +(a !== 0 && b !== 0)},
  {'<=': (a, b) => +(a <= b), '>=': (a, b) => +(a >= b), '!=': (a, b) => +(a !== b),
   '==': (a, b) => +(a === b), '<': (a, b) => +(a < b), '>': (a, b) => +(a > b)},
  {'+': (a, b) => a + b, '-': (a, b) => a - b}, {'*': (a, b) => a * b, '/': (a, b) => a / b}
];

/** The function of (x, y, z, nx, ny, nz) that a formula is. Throws an Error in words. */
function parseFormula(formula) {
  const tokens = formula.match(/\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?|[A-Za-z_]\w*|\|\||&&|[<>=!]=|\S/g) ?? [];
  let at = 0;
  const is = token => tokens[at] === token;
  const wrong = () => new Error(at < tokens.length ? `'${tokens[at]}' is not expected there` : 'the formula ends too early');
  const take = token => {
    if (!is(token)) throw wrong();
    ++at;
  };

  const choice = () => {
    const condition = level(0);
    if (!is('?')) return condition;
    take('?');
    const yes = choice();
    take(':');
    const no = choice();
    return p => condition(p) !== 0 ? yes(p) : no(p);
  };
  const level = k => {
    if (k === binary.length) return signed();
    let left = level(k + 1);
    while (at < tokens.length && Object.hasOwn(binary[k], tokens[at])) {
      const apply = binary[k][tokens[at++]], a = left, b = level(k + 1);
      left = p => apply(a(p), b(p));
    }
    return left;
  };
  const signed = () => {
    if (!is('-') && !is('+')) return power();
    const sign = tokens[at++] === '-' ? -1 : 1, value = signed();
    return p => sign * value(p);
  };
  const power = () => {
    const base = atom();
    if (!is('^')) return base;
    take('^');
    const exponent = signed();
    return p => base(p) ** exponent(p);
  };
  const call = apply => {
    take('(');
    const list = [choice()];
    while (is(',')) {
      take(',');
      list.push(choice());
    }
    take(')');
    if (apply.length > list.length) throw new Error('a function has too few arguments');
    return p => apply(...list.map(value => value(p)));
  };
  const atom = () => {
    const token = tokens[at] ?? '';
    if (is('(')) {
      take('(');
      const value = choice();
      take(')');
      return value;
    }
    if (/^[\d.]*\d/.test(token)) {
      ++at;
      return () => Number(token);
    }
    if (!/^[A-Za-z_]/.test(token)) throw wrong();
    ++at;
    if (Object.hasOwn(functions, token)) return call(functions[token]);
    if (Object.hasOwn(constants, token)) return () => constants[token];
    const k = variables.indexOf(token);
    if (k < 0) throw new Error(`'${token}' is not known; there are ${variables.join(', ')}`);
    return p => p[k];
  };

  const value = choice();
  if (at < tokens.length) throw wrong();
  return value;
}

/** The value of a formula at each vertex, in the frame where the bounding box has the middle 0 and the
    diagonal 2. */
function evaluate(formula, points, faces) {
  const value = parseFormula(formula);
  const low = [0, 1, 2].map(k => points.reduce((m, x, i) => i % 3 === k ? Math.min(m, x) : m, Infinity));
  const high = [0, 1, 2].map(k => points.reduce((m, x, i) => i % 3 === k ? Math.max(m, x) : m, -Infinity));
  const unit = Math.hypot(...high.map((h, k) => h / 2 - low[k] / 2));
  const normals = normalsOf(faces, areasOf(faces, points).vectors, points.length / 3);
  return Float64Array.from({length: points.length / 3}, (_, v) => {
    const place = [0, 1, 2].map(k => (points[3 * v + k] - (low[k] / 2 + high[k] / 2)) / unit);
    const result = value([...place, ...normals.subarray(3 * v, 3 * v + 3)]);
    if (!Number.isFinite(result)) throw new Error('the formula is not finite everywhere');
    return result;
  });
}
