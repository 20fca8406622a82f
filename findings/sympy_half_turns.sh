#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: SymPy 1.11.1 (Debian python3-sympy 1.11.1-1).
# Expected: Quaternion.from_rotation_matrix() gives a quaternion that turns as the matrix does.
# Seen: for half turns about any axis it is zero: the signs of its parts are those of differences that
# vanish, and the sign of zero is zero. Exact and floating numbers do the same; turns by less are right.
# Met: spins from frames: opposite directions are half a turn apart.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install python3-sympy=1.11.1-1 python3-mpmath=1.2.1-2 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >half_turns.py <<'PY'
import sympy
from sympy.algebras.quaternion import Quaternion

print("SymPy", sympy.__version__)
for axis in ((1, 0, 0), (1, 1, 0), (1, 2, 2)):
    a = sympy.Matrix(axis) / sympy.sqrt(sum(x * x for x in axis))
    for turns in (sympy.Rational(1, 2), sympy.Rational(1, 3)):
        wanted = Quaternion.from_axis_angle(tuple(a), 2 * sympy.pi * turns)
        found = Quaternion.from_rotation_matrix(wanted.to_rotation_matrix().applyfunc(sympy.simplify))
        text = [", ".join("%.4f" % float(x) for x in (q.a, q.b, q.c, q.d)) for q in (found, wanted)]
        print("axis", axis, "turns", turns, ":", text[0], "for", text[1])
PY
cat >wanted <<'TEXT'
SymPy 1.11.1
axis (1, 0, 0) turns 1/2 : 0.0000, 0.0000, 0.0000, 0.0000 for 0.0000, 1.0000, 0.0000, 0.0000
axis (1, 0, 0) turns 1/3 : 0.5000, 0.8660, 0.0000, 0.0000 for 0.5000, 0.8660, 0.0000, 0.0000
axis (1, 1, 0) turns 1/2 : 0.0000, 0.0000, 0.0000, 0.0000 for 0.0000, 0.7071, 0.7071, 0.0000
axis (1, 1, 0) turns 1/3 : 0.5000, 0.6124, 0.6124, 0.0000 for 0.5000, 0.6124, 0.6124, 0.0000
axis (1, 2, 2) turns 1/2 : 0.0000, 0.0000, 0.0000, 0.0000 for 0.0000, 0.3333, 0.6667, 0.6667
axis (1, 2, 2) turns 1/3 : 0.5000, 0.2887, 0.5774, 0.5774 for 0.5000, 0.2887, 0.5774, 0.5774
TEXT

{ PYTHONPATH=$work/root/usr/lib/python3/dist-packages /usr/bin/python3 half_turns.py || true; } | tee seen
diff wanted seen
