#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: numeric 1.2.6 (npm).
# Expected: eig() of a symmetric matrix gives as many independent eigenvectors as the matrix has rows.
# Seen: all copies of a repeated eigenvalue get the same eigenvector, even those of diag(2, 2, 3). As
# residuals are zero, a check of A x = theta x sees nothing.
# Met: eigenvalues of the Dirac operator come in fours, and those of symmetric surfaces in more.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm install --silent --no-audit --no-fund numeric@1.2.6 >/dev/null

cat >copies.cjs <<'JS'
const numeric = require("numeric");

console.log("numeric", numeric.version);
const matrices = {
  "diag(2, 2, 3)": [[2, 0, 0], [0, 2, 0], [0, 0, 3]],
  "diag(2, 4, 3)": [[2, 0, 0], [0, 4, 0], [0, 0, 3]],
  "1 + ones": [[2, 1, 1, 1], [1, 2, 1, 1], [1, 1, 2, 1], [1, 1, 1, 2]],
};
for (const [name, matrix] of Object.entries(matrices)) {
  const { lambda, E } = numeric.eig(matrix);
  const rest = numeric.norm2(numeric.sub(numeric.dot(matrix, E.x),
    numeric.dot(E.x, numeric.diag(lambda.x))));
  const columns = numeric.transpose(E.x);
  const copies = columns.filter((x, i) =>
    columns.slice(0, i).some(y => Math.abs(numeric.dot(x, y)) > 1 - 1e-9));
  console.log(`${name}: values ${lambda.x.map(x => x.toFixed(3)).join(" ")},`,
    rest < 1e-12 ? "residual zero," : "residual,", copies.length, "vectors are copies");
}
JS
cat >wanted <<'TEXT'
numeric 1.2.6
diag(2, 2, 3): values 2.000 2.000 3.000, residual zero, 1 vectors are copies
diag(2, 4, 3): values 2.000 4.000 3.000, residual zero, 0 vectors are copies
1 + ones: values 5.000 1.000 1.000 1.000, residual zero, 2 vectors are copies
TEXT

node copies.cjs | tee seen
diff wanted seen
