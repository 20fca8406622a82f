#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: TetGen 1.5.0 (Debian tetgen 1.5.0-5).
# Expected: the faces at the boundary of the tetrahedra, which are those of the surface that was given,
# have their orientation, with normals outward.
# Seen: all of them are turned: the surface in the .face file is inside out, consistently. The tetrahedra
# have positive volumes, and vertices keep their numbers.
# Met: the signs of mean curvature and rho, on surfaces of solids.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install tetgen=1.5.0-5 libtet1.5=1.5.0-5 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >volume.py <<'PY'
import subprocess
import sys
from itertools import product

def six_volumes(points, faces):
    return sum(sum(a[i] * (b[i - 2] * c[i - 1] - b[i - 1] * c[i - 2]) for i in range(3))
               for a, b, c in ([points[v] for v in face] for face in faces))

def rows(name, first):
    lines = [line.split() for line in open(name) if not line.startswith("#")]
    return [[float(x) for x in line[1:1 + first]] for line in lines[1:1 + int(lines[0][0])]]

points = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]]
faces = []
for x, y, z in product((0, 1), repeat=3):
    a, b, c = x, 2 + y, 4 + z
    faces.append([a, b, c] if (x + y + z) % 2 == 0 else [b, a, c])
with open("a.off", "w") as out:
    print("OFF\n6 8 0", *(" ".join(map(str, p)) for p in points), sep="\n", file=out)
    for face in faces:
        print(3, *face, file=out)
subprocess.run([sys.argv[1], "-p", "a.off"], stdout=subprocess.DEVNULL, check=True)
written = [[int(v) for v in face] for face in rows("a.1.face", 3)]
print("vertices are the same:", rows("a.1.node", 3) == points)
print("six times the volume: given %g, written %g" % (six_volumes(points, faces), six_volumes(points, written)))
PY
cat >wanted <<'TEXT'
vertices are the same: True
six times the volume: given 8, written -8
TEXT

export LD_LIBRARY_PATH=$work/root/usr/lib/$(gcc -dumpmachine)
{ /usr/bin/python3 volume.py root/usr/bin/tetgen || true; } | tee seen
diff wanted seen
