#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: ADMesh 0.98.4 (Debian admesh 0.98.4-2).
# Expected: told to write a binary STL file, and nothing else, ADMesh converts the file.
# Seen: it repairs, too: a bowl of 32 triangles with a rim becomes a closed solid of 46, and what pointed
# inwards is turned, by the sign of a volume that the bowl did not have. With one check asked for, such as
# --normal-values, the others are left out.
# Met: surfaces with boundary as STL: which side is outside, and that there is a boundary.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install admesh=0.98.4-2 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >bowl.py <<'PY'
import struct
import sys


def corner(i, j):
    return i / 4, j / 4, (i / 4 - .5) ** 2 + (j / 4 - .5) ** 2


if sys.argv[1] == "write":
    faces = [face for i in range(4) for j in range(4)
             for face in ([corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)],
                          [corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)])]
    with open("bowl.stl", "wb") as file:
        file.write(bytes(80) + struct.pack("<I", len(faces)))
        for a, b, c in faces:
            file.write(struct.pack("<12fH", 0, 0, 0, *a, *b, *c, 0))
else:
    data = open(sys.argv[2], "rb").read()
    up = 0
    for at in range(84, len(data), 50):
        n = struct.unpack("<12f", data[at:at + 48])
        (ax, ay), (bx, by), (cx, cy) = n[3:5], n[6:8], n[9:11]
        up += (bx - ax) * (cy - ay) > (by - ay) * (cx - ax)
    print(f"{sys.argv[2]}: {(len(data) - 84) // 50} triangles, of which {up} look up")
PY
cat >wanted <<'TEXT'
bowl.stl: 32 triangles, of which 32 look up
converted.stl: 46 triangles, of which 7 look up
checked.stl: 32 triangles, of which 32 look up
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
/usr/bin/python3 bowl.py write
LD_LIBRARY_PATH=$library root/usr/bin/admesh --write-binary-stl=converted.stl bowl.stl >log
LD_LIBRARY_PATH=$library root/usr/bin/admesh --normal-values --write-binary-stl=checked.stl bowl.stl >>log
grep --max-count=1 --only-matching "ADMesh version 0.98.4" log
for name in bowl converted checked; do /usr/bin/python3 bowl.py read $name.stl; done | tee seen
diff wanted seen
