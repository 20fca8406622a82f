#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: OpenVDB 10.0.1 (Debian python3-openvdb 10.0.1-2).
# Expected: a closed surface goes through a level set of OpenVDB and comes back with its faces outwards.
# Seen: they come back inwards, whichever way they looked before; those of a level set made by OpenVDB
# itself do so, too. Volumes have the other sign, quadrilaterals and triangles alike.
# Met: surfaces from volumes: mean curvature changes its sign, and what ought to grow out grows in, unless
# a program turns them, as this one does.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install python3-openvdb=10.0.1-2 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >volumes.py <<'PY'
import math

import numpy
import pyopenvdb

print("OpenVDB", ".".join(map(str, pyopenvdb.LIBRARY_VERSION)))
points = 10 * numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], numpy.float32)
outwards = numpy.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]], numpy.uint32)


def volume(points, faces):
    return sum(numpy.linalg.det(points[[face[0], face[i], face[i + 1]]].astype(float)) / 6
               for face in faces for i in range(1, len(face) - 1))


def told(name, grid, expected):
    points, quads = grid.convertToQuads()
    print(f"{name}, quadrilaterals: {volume(points, quads) / expected:.0f} of the volume")
    points, triangles, quads = grid.convertToPolygons(adaptivity=.5)
    total = volume(points, triangles) + volume(points, quads)
    print(f"{name}, with triangles: {total / expected:.0f} of the volume")


for name, faces in ("outwards", outwards), ("inwards", numpy.ascontiguousarray(outwards[:, ::-1])):
    grid = pyopenvdb.FloatGrid.createLevelSetFromPolygons(
        points, triangles=faces, transform=pyopenvdb.createLinearTransform(.5))
    told(f"tetrahedron, faces {name}", grid, abs(volume(points, faces)))
told("sphere of OpenVDB", pyopenvdb.createLevelSetSphere(10., voxelSize=.5), 4 / 3 * math.pi * 1000)
PY
cat >wanted <<'TEXT'
OpenVDB 10.0.1
tetrahedron, faces outwards, quadrilaterals: -1 of the volume
tetrahedron, faces outwards, with triangles: -1 of the volume
tetrahedron, faces inwards, quadrilaterals: -1 of the volume
tetrahedron, faces inwards, with triangles: -1 of the volume
sphere of OpenVDB, quadrilaterals: -1 of the volume
sphere of OpenVDB, with triangles: -1 of the volume
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
export LD_LIBRARY_PATH=$library:$library/blas:$library/lapack
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
/usr/bin/python3 volumes.py | tee seen
diff wanted seen
