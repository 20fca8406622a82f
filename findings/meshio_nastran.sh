#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: meshio 5.0.0 (Debian python3-meshio 7.0.0-3).
# Expected: every finite double can be written as a number of a Nastran file, rounded where need be.
# Seen: an AssertionError, and a file without its vertices: the text of the number must fit into 16
# characters, and -0.5257311121191336, a coordinate of the icosahedron, has 19. Digits are neither
# counted nor cut.
# Met: conversion of results for solvers; every transformed surface has such numbers.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install python3-meshio=7.0.0-3 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >write.py <<'PY'
import meshio

print("meshio", meshio.__version__)
for x in (.5, -.5257311121, -.5257311121191336):
    mesh = meshio.Mesh([[x, 0, 0], [1, 0, 0], [0, 1, 0]], [("triangle", [[0, 1, 2]])])
    try:
        mesh.write("mesh.nas")
        print(x, "is written, and read as", meshio.read("mesh.nas").points[0][0])
    except Exception as error:
        print(x, "is not written:", type(error).__name__)
PY
cat >wanted <<'TEXT'
meshio 5.0.0
0.5 is written, and read as 0.5
-0.5257311121 is written, and read as -0.5257311121
-0.5257311121191336 is not written: AssertionError
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
export LD_LIBRARY_PATH=$library:$library/blas:$library/lapack
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
/usr/bin/python3 write.py | tee seen
diff wanted seen
