#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: mathjs 15.2.0 (npm).
# Expected: the determinant and the eigenvalues of s A are s^n and s times those of A, to rounding, for
# any s that does not underflow.
# Seen: for s = 1e-9 the determinant of a 3 x 3 matrix is nearly a thousand million times too large,
# while its inverse and solutions with it are right. The eigenvalues of a symmetric matrix lose digits
# with s, and from 1e-12 on they are wrong by half or more. Numbers below 1e-12 count as zero, whatever
# the others are.
# Met: stiffness in the units of a mesh of some micrometres; eigenvalues of its Laplacian.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm install --silent --no-audit --no-fund mathjs@15.2.0 >/dev/null

cat >small.mjs <<'JS'
import * as math from "mathjs";

const A = [[2, 1, 0], [1, 2, 1], [0, 1, 2]];
for (const s of [1, 1e-6, 1e-9, 1e-12, 1e-14]) {
  const B = math.multiply(s, A);
  const relative = (a, b) => Math.abs(a / b - 1).toExponential(0);
  const wanted = [2 - Math.SQRT2, 2, 2 + Math.SQRT2], found = math.eigs(B).values;
  const worst = Math.max(...wanted.map((x, i) => Math.abs(found[i] / s / x - 1))).toPrecision(1);
  console.log(`s = ${s}: determinant / s^3 ${(math.det(B) / s ** 3).toPrecision(2)} of 4,`,
    `inverse * s ${(math.inv(B)[0][0] * s).toPrecision(4)} of 0.75,`,
    `eigenvalues wrong by ${worst < 1e-12 ? "rounding" : worst}`);
}
JS
cat >wanted <<'TEXT'
s = 1: determinant / s^3 4.0 of 4, inverse * s 0.7500 of 0.75, eigenvalues wrong by rounding
s = 0.000001: determinant / s^3 4.0 of 4, inverse * s 0.7500 of 0.75, eigenvalues wrong by rounding
s = 1e-9: determinant / s^3 3.0e+9 of 4, inverse * s 0.7500 of 0.75, eigenvalues wrong by 2e-10
s = 1e-12: determinant / s^3 3.0e+12 of 4, inverse * s 0.7500 of 0.75, eigenvalues wrong by 0.5
s = 1e-14: determinant / s^3 3.0e+14 of 4, inverse * s 0.7500 of 0.75, eigenvalues wrong by 2
TEXT

node small.mjs | tee seen
diff wanted seen
