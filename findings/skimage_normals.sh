#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: scikit-image 0.19.3 (Debian python3-skimage 0.19.3-8).
# Expected: with a spacing of the voxels, marching_cubes gives the points and the normals of the
# surface in space: those of an ellipsoid, to a few degrees as for the ball without a spacing.
# Seen: the points have the spacing, the normals are those of the ball: up to 39 degrees off where a
# voxel is four times as long as it is wide.
# Met: surfaces from scans, whose slices are farther apart than their pixels, and their normals.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install python3-skimage=0.19.3-8 \
  python3-skimage-lib=0.19.3-8+b1 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >ellipsoid.py <<'PY'
import numpy
import skimage
from skimage.measure import marching_cubes

print("scikit-image", skimage.__version__)
x, y, z = numpy.mgrid[-1:1:25j, -1:1:25j, -1:1:25j]
radius = numpy.sqrt(x ** 2 + y ** 2 + z ** 2)
for spacing in ((1, 1, 1), (1, 1, 4)):
    points, faces, normals, _ = marching_cubes(-radius, -.7, spacing=spacing)
    points -= 12 * numpy.array(spacing)
    wanted = points / numpy.array(spacing) ** 2
    wanted /= numpy.linalg.norm(wanted, axis=1)[:, None]
    a, b, c = points[faces].transpose(1, 0, 2)
    sums = numpy.zeros_like(points, dtype=float)
    numpy.add.at(sums, faces, -numpy.cross(b - a, c - a)[:, None, :])
    of_faces = sums / numpy.linalg.norm(sums, axis=1)[:, None]

    def angle(n):
        return numpy.degrees(numpy.arccos(numpy.clip((n * wanted).sum(axis=1), -1, 1))).max()

    print("spacing", *spacing, f"{numpy.ptp(points, axis=0).round(1)}: normals up to "
          f"{angle(normals):.0f} degrees off, those of the triangles {angle(of_faces):.0f}")
PY
cat >wanted <<'TEXT'
scikit-image 0.19.3
spacing 1 1 1 [16.8 16.8 16.8]: normals up to 3 degrees off, those of the triangles 5
spacing 1 1 4 [16.8 16.8 67.2]: normals up to 39 degrees off, those of the triangles 6
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
export LD_LIBRARY_PATH=$library:$library/blas:$library/lapack
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
/usr/bin/python3 ellipsoid.py | tee seen
diff wanted seen
