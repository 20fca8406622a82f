#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: MRtrix3 3.0.3 (Debian mrtrix3 3.0.3-3+b1).
# Expected: voxel2mesh makes a surface around the voxels above -threshold, smooth or, by -blocky, along the
# sides of voxels.
# Seen: with -blocky the threshold is not used, and negative voxels count as inside: the signed distance
# of a ball gives the surface of the whole image but a shell of voxels next to zero. Triangles share no
# vertices.
# Met: surfaces from segmentations; exact boundaries of voxels are closed only where vertices are shared.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install mrtrix3=3.0.3-3+b1 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >image.py <<'PY'
import struct

n = 24
middle = (n - 1) / 2
with open("ball.dat", "wb") as out:
    for k in range(n):
        for j in range(n):
            for i in range(n):
                r = sum((x - middle)**2 for x in (i, j, k))**.5
                out.write(struct.pack("<f", 8.3 - r))
with open("ball.mih", "w") as out:
    out.write(f"mrtrix image\ndim: {n},{n},{n}\nvox: 1,1,1\nlayout: +0,+1,+2\n"
              "datatype: Float32LE\nfile: ball.dat\n")
PY
cat >volume.py <<'PY'
points, volume = [], 0
for line in open("ball.obj"):
    word = line.split()
    if word and word[0] == "v":
        points.append([float(x) for x in word[1:4]])
    if word and word[0] == "f":
        a, b, c = (points[int(corner.split("/")[0]) - 1] for corner in word[1:])
        volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
                   + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
print(f"volume {volume:.0f}, {len(points)} vertices")
PY
cat >wanted <<'TEXT'
threshold 0 : volume 2375, 1296 vertices
threshold 0 -blocky: volume 12960, 36576 vertices
threshold 4 : volume 322, 312 vertices
threshold 4 -blocky: volume 12960, 36576 vertices
TEXT

export LD_LIBRARY_PATH=$work/root/usr/lib/$(gcc -dumpmachine):$work/root/usr/lib/mrtrix3/lib
python3 image.py
for threshold in 0 4; do
  for kind in "" -blocky; do
    root/usr/lib/mrtrix3/bin/voxel2mesh ball.mih ball.obj -threshold $threshold $kind -quiet -force
    echo "threshold $threshold $kind: $(python3 volume.py)"
  done
done | tee seen
diff wanted seen
