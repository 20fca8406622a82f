#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: cholesky-solve 0.2.1, cuthill-mckee 1.0.0 (npm).
# Expected: a symmetric matrix is given by its coefficients on and above the diagonal, or, since those
# below "do not need to be specified", by all of them.
# Seen: all of them are right without a permutation. With one, even the identity, the solution is wrong,
# by more the larger the matrix: each coefficient counts twice where a permutation turns it over.
# Met: Laplacians come as whole matrices from any loop over edges; fill needs the permutation.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm install --silent --no-audit --no-fund cholesky-solve@0.2.1 cuthill-mckee@1.0.0 >/dev/null

cat >solve.cjs <<'JS'
const { prepare } = require("cholesky-solve");
const cuthillMckee = require("cuthill-mckee");

for (const n of [10, 1000]) {
  const half = [], b = [];
  for (let i = 0; i < n; i++) {
    half.push([i, i, 2.1]);
    if (i + 1 < n) half.push([i, i + 1, -1]);
    b.push(Math.sin(i));
  }
  const whole = half.concat(half.filter(([i, j]) => i < j).map(([i, j, x]) => [j, i, x]));
  const orders = { none: undefined, identity: b.map((_, i) => i), "Cuthill-McKee": cuthillMckee(half, n) };
  for (const [kind, matrix] of Object.entries({ half, whole }))
    for (const [name, order] of Object.entries(orders)) {
      const x = prepare(matrix, n, order)(b.slice());
      const rest = b.map((y, i) => Math.abs(2.1 * x[i] - (x[i - 1] ?? 0) - (x[i + 1] ?? 0) - y));
      console.log(`${n} unknowns, ${kind} matrix, permutation ${name}:`,
        Math.max(...rest) < 1e-12 ? "right" : "wrong");
    }
}
JS
cat >wanted <<'TEXT'
10 unknowns, half matrix, permutation none: right
10 unknowns, half matrix, permutation identity: right
10 unknowns, half matrix, permutation Cuthill-McKee: right
10 unknowns, whole matrix, permutation none: right
10 unknowns, whole matrix, permutation identity: wrong
10 unknowns, whole matrix, permutation Cuthill-McKee: wrong
1000 unknowns, half matrix, permutation none: right
1000 unknowns, half matrix, permutation identity: right
1000 unknowns, half matrix, permutation Cuthill-McKee: right
1000 unknowns, whole matrix, permutation none: right
1000 unknowns, whole matrix, permutation identity: wrong
1000 unknowns, whole matrix, permutation Cuthill-McKee: wrong
TEXT

node solve.cjs | tee seen
diff wanted seen
