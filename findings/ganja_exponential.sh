#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: ganja.js 1.0.204 (npm).
# Expected: exp(i t) = cos t + i sin t for each of the three imaginary units of the quaternions, which
# are Algebra(0, 2) there, and exp(a + b) = exp(a) exp(b) for a real number a.
# Seen: exp is 1 for the units e1 and e2, and right for e12 alone. With a real part the sum of a series
# is taken that cancels: exp(.5 + 16 e12) has length 600,000 in place of 1.6.
# Met: spins as exponentials, and quaternions of any length.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm install --silent --no-audit --no-fund ganja.js@1.0.204 >/dev/null

cat >exponential.mjs <<'JS'
import Algebra from "ganja.js";

const Quaternions = Algebra(0, 2);
for (const [name, q] of [["2 e1", [0, 2, 0, 0]], ["2 e2", [0, 0, 2, 0]], ["2 e12", [0, 0, 0, 2]],
                         ["0.5 + 16 e12", [0.5, 0, 0, 16]]]) {
  const angle = Math.hypot(q[1], q[2], q[3]), size = Math.exp(q[0]);
  const right = [Math.cos(angle), ...q.slice(1).map(x => x / angle * Math.sin(angle))].map(x => size * x);
  const text = numbers => Array.from(numbers, x => (Math.round(1e4 * x) / 1e4 + 0).toPrecision(4) * 1).join(", ");
  console.log(`exp(${name}) = ${text(new Quaternions(q).Exp())} for ${text(right)}`);
}
JS
cat >wanted <<'TEXT'
exp(2 e1) = 1, 0, 0, 0 for -0.4161, 0.9093, 0, 0
exp(2 e2) = 1, 0, 0, 0 for -0.4161, 0, 0.9093, 0
exp(2 e12) = -0.4161, 0, 0, 0.9093 for -0.4161, 0, 0, 0.9093
exp(0.5 + 16 e12) = -229600, 0, 0, 597200 for -1.579, 0, 0, -0.4747
TEXT

node exponential.mjs | tee seen
diff wanted seen
