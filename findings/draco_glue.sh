#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: Draco 1.5.5 (Debian draco 1.5.5+dfsg-2).
# Expected: without quantization (-qp 0) and with the method that keeps the order (-cl 0), a mesh goes
# through Draco as it is, with its vertex properties.
# Seen: vertices at one position become one, whatever the options. A square ring that is cut open
# closes; of two tetrahedra that touch, the vertex between them is no manifold. A property beside
# the position is gone without a word.
# Met: surfaces that were cut for a flat image; rho and quality.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install draco=1.5.5+dfsg-2 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >meshes.py <<'PY'
import sys


def write(name, points, faces):
    with open(name, "w") as file:
        print("ply\nformat ascii 1.0\nelement vertex", len(points), file=file)
        print("property float x\nproperty float y\nproperty float z\nproperty float rho", file=file)
        print("element face", len(faces), file=file)
        print("property list uchar int vertex_indices\nend_header", file=file)
        for point in points:
            print(*point, .5, file=file)
        for face in faces:
            print(3, *face, file=file)


corner = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
sides = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]
write("touching.ply", corner + [[-x for x in p] for p in corner],
      sides + [[a + 4, c + 4, b + 4] for a, b, c in sides])
turn = [[1, 0], [0, 1], [-1, 0], [0, -1], [1, 0]]
write("ring.ply", [[x, y, z] for x, y in turn for z in (0, 1)],
      [face for i in range(0, 8, 2) for face in ([i, i + 2, i + 1], [i + 1, i + 2, i + 3])])
PY
cat >count.py <<'PY'
import sys

with open(sys.argv[1], "rb") as file:
    header = file.read().split(b"end_header")[0].decode().split("\n")
print(*[line.split(" ", 1)[1] for line in header if line.startswith("element")],
      *[line.split()[-1] for line in header if line.startswith("property float")])
PY
cat >wanted <<'TEXT'
touching before: vertex 8 face 8 x y z rho
touching after: vertex 7 face 8 x y z
ring before: vertex 10 face 8 x y z rho
ring after: vertex 8 face 8 x y z
TEXT

python3 meshes.py
for mesh in touching ring; do
  root/usr/bin/draco_encoder -i $mesh.ply -o $mesh.drc -qp 0 -cl 0 >/dev/null
  root/usr/bin/draco_decoder -i $mesh.drc -o after.ply >/dev/null
  echo "$mesh before: $(python3 count.py $mesh.ply)"
  echo "$mesh after: $(python3 count.py after.ply)"
done | tee seen
diff wanted seen
