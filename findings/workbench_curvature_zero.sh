#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: Connectome Workbench 1.5.0 (Debian connectome-workbench 1.5.0-2+b1), nibabel 5.0.0.
# Expected: wb_command -surface-curvature gives curvatures near 1 at each vertex of an icosahedral unit
# sphere.
# Seen: exactly 0 at more than a quarter of the vertices, mean and Gaussian, and 1 at the others,
# without a message, however the sphere is turned. Both principal curvatures of a sphere are equal, so
# that the term under their root is zero, and rounding makes it negative at some vertices.
# Met: curvature of brain surfaces as rho, from files of that program; a zero is not missing data.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install connectome-workbench=1.5.0-2+b1 \
    python3-nibabel=5.0.0-2 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >sphere.py <<'PY'
import sys

import nibabel
import numpy

t = (1 + 5**.5) / 2
points = [(-1, t, 0), (1, t, 0), (-1, -t, 0), (1, -t, 0), (0, -1, t), (0, 1, t), (0, -1, -t),
          (0, 1, -t), (t, 0, -1), (t, 0, 1), (-t, 0, -1), (-t, 0, 1)]
faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2),
         (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5),
         (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
middles, finer = {}, []
for face in faces:
    inner = []
    for a, b in zip(face, face[1:] + face[:1]):
        if (min(a, b), max(a, b)) not in middles:
            middles[min(a, b), max(a, b)] = len(points)
            points.append(numpy.add(points[a], points[b]))
        inner.append(middles[min(a, b), max(a, b)])
    finer += [inner] + [(face[i], inner[i], inner[i - 1]) for i in range(3)]
points = numpy.array([numpy.array(p) / numpy.linalg.norm(p) for p in points])
c, s = numpy.cos(.1), numpy.sin(.1)
turn = numpy.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ numpy.array([[1, 0, 0], [0, c, -s], [0, s, c]])
for name, matrix in (("straight", numpy.eye(3)), ("turned", turn)):
    if len(sys.argv) == 1:
        arrays = [nibabel.gifti.GiftiDataArray((points @ matrix.T).astype("f4"), "NIFTI_INTENT_POINTSET"),
                  nibabel.gifti.GiftiDataArray(numpy.array(finer, "i4"), "NIFTI_INTENT_TRIANGLE")]
        nibabel.save(nibabel.gifti.GiftiImage(darrays=arrays), name + ".surf.gii")
        continue
    for kind in ("mean", "gauss"):
        values = nibabel.load(f"{name}.{kind}.shape.gii").darrays[0].data
        other = values[values != 0]
        print(f"{name}, {kind}: zero at more than a quarter of the vertices: {4 * sum(values == 0) > len(values)},",
              f"{min(other):.2f} to {max(other):.2f} at the others")
PY
cat >wanted <<'TEXT'
straight, mean: zero at more than a quarter of the vertices: True, 1.00 to 1.00 at the others
straight, gauss: zero at more than a quarter of the vertices: True, 1.00 to 1.00 at the others
turned, mean: zero at more than a quarter of the vertices: True, 1.00 to 1.00 at the others
turned, gauss: zero at more than a quarter of the vertices: True, 1.00 to 1.00 at the others
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
export LD_LIBRARY_PATH=$library:$library/blas:$library/lapack:$work/root/usr/lib QT_QPA_PLATFORM=offscreen
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
/usr/bin/python3 sphere.py
for name in straight turned; do
  root/usr/bin/wb_command -surface-curvature $name.surf.gii -mean $name.mean.shape.gii \
    -gauss $name.gauss.shape.gii
done
root/usr/bin/wb_command -version | grep -E '^Version'
/usr/bin/python3 sphere.py read | tee seen
diff wanted seen
