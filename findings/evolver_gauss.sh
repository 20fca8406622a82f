#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: Surface Evolver 2.70 (Debian evolver-nox 2.70+ds-8+b1).
# Expected: gauss_curvature_integral, "the total Gaussian curvature", is the sum of what angles lack
# at inner vertices: 0 on a flat square, and some 4 pi of a sphere. Its manual says "plus 2 pi chi".
# Seen: minus 2 pi chi. A square has -2 pi, the upper half of an octahedron -4/3 pi in place of 2/3 pi,
# and a closed surface 0, since only fixed vertices are looked at. star_gauss_curvature is right there,
# and takes all that the angles at a boundary lack.
# Met: energies of surfaces in the Evolver, which minimises Willmore's as well.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install evolver-nox=2.70+ds-8+b1 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >surface.py <<'PY'
import sys

pole, foot = [0, 0, 1], [0, 0, -1]
ring = [[1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]]
top = [[0, 1 + i, 1 + (i + 1) % 4] for i in range(4)]
bottom = [[5, 1 + (i + 1) % 4, 1 + i] for i in range(4)]
kind, method = sys.argv[1:]
points, faces = {
    "square": ([[0, 0, 0]] + ring, top),
    "pyramid": ([pole] + ring, top),
    "octahedron": ([pole] + ring + [foot], top + bottom)}[kind]
edges, rows = {}, []
for face in faces:
    row = []
    for a, b in zip(face, face[1:] + face[:1]):
        sign = 1 if (a, b) in edges or (b, a) not in edges else -1
        row.append(sign * edges.setdefault((a, b) if sign > 0 else (b, a), len(edges) + 1))
    rows.append(row)
used = [abs(edge) for row in rows for edge in row]
print("quantity turning info_only method", method, "global")
print("vertices")
for i, point in enumerate(points):
    is_fixed = kind != "octahedron" and i > 0
    print(i + 1, *point, "fixed" if is_fixed else "")
print("edges")
for (a, b), number in edges.items():
    print(number, a + 1, b + 1, "fixed" if used.count(number) == 1 else "")
print("faces")
for i, row in enumerate(rows):
    print(i + 1, *row)
print('read\nprintf "%.4f\\n", turning.value / pi')
PY
cat >wanted <<'TEXT'
square: what angles lack inside is 0.0000 pi, gauss_curvature_integral -2.0000 pi
pyramid: what angles lack inside is 0.6667 pi, gauss_curvature_integral -1.3333 pi
octahedron: what angles lack inside is 4.0000 pi, gauss_curvature_integral 0.0000 pi
TEXT

value() {
  python3 surface.py "$1" "$2" >"$1.fe"
  root/usr/bin/evolver-nox-d "$1.fe" <<<q | grep -oE -- '-?[0-9]+\.[0-9]{4}$' | tail -1
}
exact() {
  case $1 in square) echo 0.0000 ;; pyramid) echo 0.6667 ;; *) value "$1" star_gauss_curvature ;; esac
}
echo q | root/usr/bin/evolver-nox-d 2>/dev/null | grep -m 1 Version || true
for kind in square pyramid octahedron; do
  echo "$kind: what angles lack inside is $(exact $kind) pi," \
    "gauss_curvature_integral $(value $kind gauss_curvature_integral) pi"
done | tee seen
diff wanted seen
