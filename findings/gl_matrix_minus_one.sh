#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: gl-matrix 3.4.4 (npm gl-matrix).
# Expected: exp(ln(q)) is q for all quaternions, as it is for (1, 2, 2, 0), of length 3; the square of
# a root of q is q; half way from q to q is q.
# Seen: ln(-1) is 0, so that exp(ln(-1)) is 1, and so is the root of -1. Half way from a quaternion of
# length 1/1000 to itself is its multiple by the square root of 2.
# Met: spins after a full turn, which are -1, and their lengths, which are scales.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm install --silent --no-audit --no-fund gl-matrix@3.4.4 >/dev/null

cat >roots.mjs <<'JS'
import { glMatrix, quat } from "gl-matrix";
glMatrix.setMatrixArrayType(Array);
const text = (q) => q.map((x) => Number(x.toPrecision(4)) + 0).join(" ");
const result = (f, ...q) => f(quat.create(), ...q);
console.log("the real part is the last number");
for (const q of [[2, 2, 0, 1], [0, 0, 0, -1]]) {
  const root = result(quat.pow, q, 0.5);
  console.log(`(${text(q)}): exp(ln) ${text(result(quat.exp, result(quat.ln, q)))},`,
    `square of the root ${text(result(quat.mul, root, root))}`);
}
for (const length of [1, 1e-3]) {
  const q = [0.6 * length, 0, 0, 0.8 * length];
  console.log(`half way from (${text(q)}) to itself: ${text(result(quat.slerp, q, q, 0.5))}`);
}
JS
cat >wanted <<'TEXT'
the real part is the last number
(2 2 0 1): exp(ln) 2 2 0 1, square of the root 2 2 0 1
(0 0 0 -1): exp(ln) 0 0 0 1, square of the root 0 0 0 1
half way from (0.6 0 0 0.8) to itself: 0.6 0 0 0.8
half way from (0.0006 0 0 0.0008) to itself: 0.0008485 0 0 0.001131
TEXT

node roots.mjs | tee seen
diff wanted seen
