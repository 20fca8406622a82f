#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: numpy-stl 2.9.0 (Debian python3-stl 2.9.0-2+b3), ADMesh 0.98.4 (admesh 0.98.4-2).
# Expected: binary STL written as text has the same floats, as both forms hold them.
# Seen: numpy-stl writes six digits after the point, whatever the size: a surface of micrometres in metres
# is zero, and one of unit size has short edges of wrong length. ADMesh writes a mantissa and an exponent,
# nine digits, and keeps each float.
# Met: STL as input: points that merge are faces without area.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install python3-stl=2.9.0-2+b3 \
    admesh=0.98.4-2 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >write.py <<'PY'
import sys

import numpy
import stl

size = float(sys.argv[1])
corners = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]) * .7654321 * size
mesh = stl.mesh.Mesh(numpy.zeros(4, dtype=stl.mesh.Mesh.dtype))
mesh.vectors[:] = corners[[[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]]
mesh.save("binary.stl", mode=stl.Mode.BINARY)
mesh.save("numpy-stl.stl", mode=stl.Mode.ASCII)
PY
cat >wanted <<'TEXT'
size 1: numpy-stl 0.765432
size 1: admesh 7.65432119E-01
size 1e-06: numpy-stl 0.000001
size 1e-06: admesh 7.65432105E-07
size 1e-07: numpy-stl 0.000000
size 1e-07: admesh 7.65432091E-08
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
export LD_LIBRARY_PATH=$library:$library/blas:$library/lapack
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
for size in 1 1e-06 1e-07; do
  /usr/bin/python3 -W ignore write.py $size 2>log
  root/usr/bin/admesh --no-check --write-ascii-stl=admesh.stl binary.stl >log
  for name in numpy-stl admesh; do
    # The largest x of all corners.
    echo "size $size: $name $(awk '$1 == "vertex" { print $2 }' $name.stl | sort -g | tail -1)"
  done
done | tee seen
diff wanted seen
