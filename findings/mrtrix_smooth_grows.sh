#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: MRtrix3 3.0.3 (Debian mrtrix3 3.0.3-3+b1).
# Expected: smoothing a sphere shrinks it a little, or leaves it as it is.
# Seen: "meshfilter smooth" with its defaults makes spheres of 1 mm and of 10 mm larger by 16 %, their
# volume by more than half; one of 100 mm stays as it is.
# Met: brain surfaces smoothed before or after an edit: lengths are no longer those of the report.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install mrtrix3=3.0.3-3+b1 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >sphere.py <<'PY'
import sys

radius = float(sys.argv[1])
t = (1 + 5**.5) / 2
points = [(-1, t, 0), (1, t, 0), (-1, -t, 0), (1, -t, 0), (0, -1, t), (0, 1, t), (0, -1, -t),
          (0, 1, -t), (t, 0, -1), (t, 0, 1), (-t, 0, -1), (-t, 0, 1)]
faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2),
         (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5),
         (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
for _ in range(2):
    middles = {}

    def middle(i, j):
        key = (min(i, j), max(i, j))
        if key not in middles:
            middles[key] = len(points)
            points.append(tuple(a + b for a, b in zip(points[i], points[j])))
        return middles[key]
    split = []
    for a, b, c in faces:
        x, y, z = middle(a, b), middle(b, c), middle(c, a)
        split += [(a, x, z), (b, y, x), (c, z, y), (x, y, z)]
    faces = split
for p in points:
    length = sum(x * x for x in p)**.5
    print("v", *("%.9g" % (radius * x / length) for x in p))
for f in faces:
    print("f", *(i + 1 for i in f))
PY
cat >wanted <<'TEXT'
radius 1 mm: 1.17 times as large
radius 10 mm: 1.16 times as large
radius 100 mm: 1.00 times as large
TEXT

export LD_LIBRARY_PATH=$work/root/usr/lib/$(gcc -dumpmachine):$work/root/usr/lib/mrtrix3/lib
for radius in 1 10 100; do
  python3 sphere.py $radius >sphere.obj
  root/usr/lib/mrtrix3/bin/meshfilter sphere.obj smooth smooth.obj -quiet -force
  awk -v radius=$radius '$1 == "v" { sum += sqrt($2 * $2 + $3 * $3 + $4 * $4); n++ }
    END { printf "radius %d mm: %.2f times as large\n", radius, sum / n / radius }' smooth.obj
done | tee seen
diff wanted seen
