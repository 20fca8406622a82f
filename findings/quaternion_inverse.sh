#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: pyrr 0.10.3 (Debian 0.10.3-5), transforms3d 0.4 (Debian 0.4+ds-2).
# Expected: a quaternion times its inverse is 1, whatever its length; exp(2) and log(2) are those of
# the real number.
# Seen: both packages divide the conjugate by the length in place of its square: q times the inverse of
# q has the length of q. transforms3d says that exp and log of any real quaternion are 1.
# Met: spins have lengths, which are scales; the spin of a surface that is only scaled is real.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install python3-pyrr=0.10.3-5     python3-transforms3d=0.4+ds-2 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >inverse.py <<'PY'
import numpy
import pyrr
import transforms3d
from transforms3d import quaternions

print("pyrr", pyrr.__version__, "transforms3d", transforms3d.__version__)


def text(q):
    return " ".join("%.4g" % (x + 0) for x in q)


for scale in (1, 2, 1000):
    q = scale * numpy.array([.5, .5, .5, .5])
    one = quaternions.qmult(q, quaternions.qinverse(q))
    last = pyrr.quaternion.cross(q, pyrr.quaternion.inverse(q))
    print(f"length {scale}: q times its inverse:", text(one), "(transforms3d, real part first),",
          text(last), "(pyrr, real part last)")
for real in (1, 2, .5):
    q = [real, 0, 0, 0]
    print(f"exp({real}) = {text(quaternions.qexp(q))}, log({real}) = {text(quaternions.qlog(q))}",
          "(transforms3d)")
PY
cat >wanted <<'TEXT'
pyrr 0.10.3 transforms3d 0.4
length 1: q times its inverse: 1 0 0 0 (transforms3d, real part first), 0 0 0 1 (pyrr, real part last)
length 2: q times its inverse: 2 0 0 0 (transforms3d, real part first), 0 0 0 2 (pyrr, real part last)
length 1000: q times its inverse: 1000 0 0 0 (transforms3d, real part first), 0 0 0 1000 (pyrr, real part last)
exp(1) = 1 0 0 0, log(1) = 1 0 0 0 (transforms3d)
exp(2) = 1 0 0 0, log(2) = 1 0 0 0 (transforms3d)
exp(0.5) = 1 0 0 0, log(0.5) = 1 0 0 0 (transforms3d)
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
export LD_LIBRARY_PATH=$library:$library/blas:$library/lapack
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
/usr/bin/python3 inverse.py | tee seen
diff wanted seen
