#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: stlcmd 1.1 (Debian 1.1-1).
# Expected: the spheres, tori and cylinders that it makes are closed, as stl_borders says.
# Seen: the sphere and the cone are not. Where a turn ends, and at a pole, points differ in the last
# digit from those at which it began; stl_borders says 0 of all. STL has no numbers of vertices:
# who joins equal points gets a boundary.
# Met: STL as input, whose equal points are joined.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install stlcmd=1.1-1 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >open.py <<'PY'
import struct
import sys
from collections import Counter

with open(sys.argv[1], "rb") as file:
    data = file.read()
count, = struct.unpack_from("<I", data, 80)
points, sides = set(), Counter()
for i in range(count):
    x = struct.unpack_from("<9f", data, 84 + 50 * i + 12)
    corners = [x[0:3], x[3:6], x[6:9]]
    points.update(corners)
    sides.update(zip(corners, corners[1:] + corners[:1]))
alone = [(a, b) for a, b in sides if (b, a) not in sides]
near = {tuple(round(number, 4) + 0. for number in p) for p in points}
print(f"{len(points)} points, {len(points) - len(near)} of them next to others, "
      f"{len(alone)} edges of one triangle", end="")
PY
cat >wanted <<'TEXT'
torus: 512 points, 0 of them next to others, 0 edges of one triangle; stl_borders: 0
cylinder: 64 points, 0 of them next to others, 0 edges of one triangle; stl_borders: 0
sphere: 528 points, 46 of them next to others, 94 edges of one triangle; stl_borders: 0
cone: 34 points, 1 of them next to others, 4 edges of one triangle; stl_borders: 0
TEXT

for shape in "torus -o 2 -i 0.5" "cylinder -r 1 -h 2" "sphere -r 1" "cone -r 1 -h 2"; do
  set -- $shape
  root/usr/bin/stl_"$1" "${@:2}" "$1.stl" >/dev/null
  echo "$1: $(python3 open.py "$1.stl"); stl_borders: $(root/usr/bin/stl_borders "$1.stl")"
done | tee seen
diff wanted seen
