#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: conjugate-gradient 0.0.2 (npm).
# Expected: iterates until its tolerance is met, or says that it was not.
# Seen: takes twenty iterations at most and returns what it has then, as a plain array: for the Laplacian
# of a path the solution is right up to 20 unknowns, and 49 % wrong for 40. The tolerance is one of the
# residual itself: of a right-hand side of 1e-6, zero is the solution.
# Met: Poisson problems in a page.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm install --silent --no-audit --no-fund conjugate-gradient@0.0.2 >/dev/null

cat >iterations.mjs <<'JS'
import solve from "conjugate-gradient";

for (const n of [10, 20, 40, 100]) {
  const A = {
    rowCount: n,
    get: (i, j) => i === j ? 2 : Math.abs(i - j) === 1 ? -1 : 0,
    apply: (x, y) => {
      for (let i = 0; i < n; ++i) y[i] = 2 * x[i] - (i > 0 ? x[i - 1] : 0) - (i < n - 1 ? x[i + 1] : 0);
      return y;
    },
  };
  for (const size of [1, 1e-6]) {
    const b = new Float64Array(n);
    b[0] = size;
    const x = solve(A, b, new Float64Array(n));
    const error = Math.max(...x.map((value, i) => Math.abs(value / size - (n - i) / (n + 1))));
    console.log(`${n} unknowns, right-hand side ${size}: error ${error < 1e-12 ? "of rounding" : error.toFixed(2)}`);
  }
}
JS
cat >wanted <<'TEXT'
10 unknowns, right-hand side 1: error of rounding
10 unknowns, right-hand side 0.000001: error 0.82
20 unknowns, right-hand side 1: error of rounding
20 unknowns, right-hand side 0.000001: error 0.90
40 unknowns, right-hand side 1: error 0.49
40 unknowns, right-hand side 0.000001: error 0.95
100 unknowns, right-hand side 1: error 0.79
100 unknowns, right-hand side 0.000001: error 0.98
TEXT

node iterations.mjs | tee seen
diff wanted seen
