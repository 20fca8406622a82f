#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: scikit-image 0.19.3 (Debian python3-skimage 0.19.3-8).
# Expected: the triangles of marching_cubes around what has large values, which is the default, face
# outward, as the normals do that it gives with them.
# Seen: the triangles face inward, with both methods, and the normals outward. Where small values are
# inside, normals face inward and triangles outward. gradient_direction turns only the triangles.
# Met: surfaces from volumes, and the sign of curvature and rho.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install python3-skimage=0.19.3-8 \
  python3-skimage-lib=0.19.3-8+b1 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >ball.py <<'PY'
import numpy
import skimage
from skimage.measure import marching_cubes

print("scikit-image", skimage.__version__)
x, y, z = numpy.mgrid[-1:1:25j, -1:1:25j, -1:1:25j]
radius = numpy.sqrt(x ** 2 + y ** 2 + z ** 2)
for name, values in (("large", -radius), ("small", radius)):
    for direction in ("descent", "ascent"):
        sides = set()
        for method in ("lewiner", "lorensen"):
            points, faces, normals, _ = marching_cubes(
                values, .7 if name == "small" else -.7, gradient_direction=direction, method=method)
            points -= 12
            a, b, c = points[faces].transpose(1, 0, 2)
            volume = (a * numpy.cross(b, c)).sum() / 6
            along = (points * normals).sum(axis=1)
            assert (along > 0).all() or (along < 0).all()
            sides.add(tuple("outward" if number > 0 else "inward" for number in (volume, along[0])))
        (triangles, normals), = sides
        print(f"{name} values inside, {direction}: triangles {triangles}, normals {normals}")
PY
cat >wanted <<'TEXT'
scikit-image 0.19.3
large values inside, descent: triangles inward, normals outward
large values inside, ascent: triangles outward, normals outward
small values inside, descent: triangles outward, normals inward
small values inside, ascent: triangles inward, normals inward
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
export LD_LIBRARY_PATH=$library:$library/blas:$library/lapack
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
/usr/bin/python3 ball.py | tee seen
diff wanted seen
