#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: pyrr 0.10.3 (Debian 0.10.3-5).
# Expected: a quaternion, the matrix that is made of it, and the matrix for the same axis and angle turn
# a vector alike.
# Seen: pyrr's quaternions turn the x axis to y, its matrices to -y, by its own product of matrix and
# vector; turning a matrix back to a quaternion hides it.
# Met: frames of a surface turned by spins, and by matrices of these spins.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install python3-pyrr=0.10.3-5 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >turns.py <<'PY'
import math

import numpy
import pyrr
from pyrr import Matrix33, Matrix44, Quaternion, Vector3

print("pyrr", pyrr.__version__)
q = Quaternion.from_z_rotation(math.pi / 2)
turns = {"quaternion": q, "Matrix33 of the quaternion": Matrix33.from_quaternion(q),
         "Matrix44 of the quaternion": q.matrix44, "Matrix33 about z": Matrix33.from_z_rotation(math.pi / 2)}
for name, turn in turns.items():
    print(f"{name}: x goes to", (numpy.round(turn * Vector3([1., 0., 0.])) + 0).astype(int))
print("quaternion of its matrix is itself:", numpy.allclose(Quaternion.from_matrix(q.matrix33), q))
PY
cat >wanted <<'TEXT'
pyrr 0.10.3
quaternion: x goes to [0 1 0]
Matrix33 of the quaternion: x goes to [ 0 -1  0]
Matrix44 of the quaternion: x goes to [ 0 -1  0]
Matrix33 about z: x goes to [ 0 -1  0]
quaternion of its matrix is itself: True
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
export LD_LIBRARY_PATH=$library:$library/blas:$library/lapack
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
/usr/bin/python3 turns.py | tee seen
diff wanted seen
