#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: meshplex 0.17.1 (Debian python3-meshplex 0.17.1-2).
# Expected: flip_until_delaunay() of a surface in space changes the triangulation of a surface that
# stays where it is, to the size of its faces: the volume of an ellipsoid by less than one per cent.
# Seen: it flips edges over whatever angle their faces make. A prolate ellipsoid of 320 faces loses a
# thirtieth of its volume where it is five times as long as wide, and a sixth where it is twenty times.
# Met: triangulations on which a flow computes, whose new edges are chords.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install python3-meshplex=0.17.1-2 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >ellipsoid.py <<'PY'
import warnings

import meshplex
import numpy

warnings.simplefilter("ignore")  # that rounding leaves some edges of symmetric faces
print("meshplex", meshplex.__version__)
g = (1 + 5 ** .5) / 2
points = [numpy.roll([0, a, b], k) for k in range(3) for a in (-1, 1) for b in (-g, g)]
faces = [f for f in numpy.ndindex(12, 12, 12)
         if all(abs(numpy.linalg.norm(points[f[i]] - points[f[i - 1]]) - 2) < 1e-9 for i in range(3))
         and numpy.linalg.det([points[v] for v in f]) > 0 and f[0] == min(f)]
for _ in range(2):
    middles = {}

    def middle(a, b):
        key = min(a, b), max(a, b)
        if key not in middles:
            middles[key] = len(points)
            points.append(points[a] + points[b])
        return middles[key]

    points = [p / numpy.linalg.norm(p) for p in points]
    finer = []
    for a, b, c in faces:
        x, y, z = middle(a, b), middle(b, c), middle(c, a)
        finer += [(a, x, z), (b, y, x), (c, z, y), (x, y, z)]
    faces = finer
sphere = numpy.array([p / numpy.linalg.norm(p) for p in points])


def volume(p, f):
    return (p[f[:, 0]] * numpy.cross(p[f[:, 1]], p[f[:, 2]])).sum() / 6


for length in (1, 5, 20):
    p = sphere * [length, 1, 1]
    mesh = meshplex.MeshTri(p, numpy.array(faces))
    before = volume(p, mesh.cells("points"))
    flips = mesh.flip_until_delaunay()
    print(f"1 to {length}: {len(faces)} faces, {flips} flips,",
          f"volume {volume(p, mesh.cells('points')) / before:.2f} of what it was")
PY
cat >wanted <<'TEXT'
meshplex 0.17.1
1 to 1: 320 faces, 0 flips, volume 1.00 of what it was
1 to 5: 320 faces, 164 flips, volume 0.97 of what it was
1 to 20: 320 faces, 1491 flips, volume 0.82 of what it was
TEXT

export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
/usr/bin/python3 ellipsoid.py | tee seen
diff wanted seen
