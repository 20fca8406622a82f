#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: the quaternion package 2.4.0 of Octave (Debian octave-quaternion 2.4.0-10), Octave 7.3.0.
# Expected: exp, log and powers of a quaternion without imaginary part are those of the real number.
# Seen: their imaginary parts are NaN, for exp(0), log(1) and even 1^2: each divides by the length of the
# imaginary part. Just beside them log and powers leave out a small imaginary part, or get half of its
# digits: the angle is the arc cosine of the real part. Products are right for any quaternion.
# Met: the spin of a surface that has not moved is 1 at each vertex; the logarithm of spins, for means and
# for interpolation.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install octave=7.3.0-2 \
    octave-quaternion=2.4.0-10 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >real.m <<'M'
printf("Octave %s\n", version)
function tell(name, q)
  printf("%s = %.4g %.4g %.4g %.4g\n", name, q.w, q.x, q.y, q.z)
end
one = quaternion(1, 0, 0, 0);
tell("exp(0)", exp(0 * one))
tell("log(1)", log(one))
tell("1^2", one^2)
tell("1 * 1", one * one)
for part = [1e-9, 1e-7, 1e-3]
  q = quaternion(1, part, 0, 0);
  printf("log(1 + %g i) = %g i, (1 + %g i)^2 = 1 + %g i\n", part, log(q).x, part, (q^2).x)
end
M
cat >wanted <<'TEXT'
Octave 7.3.0
exp(0) = 1 NaN NaN NaN
log(1) = 0 NaN NaN NaN
1^2 = 1 NaN NaN NaN
1 * 1 = 1 0 0 0
log(1 + 1e-09 i) = 0 i, (1 + 1e-09 i)^2 = 1 + 0 i
log(1 + 1e-07 i) = 9.88431e-08 i, (1 + 1e-07 i)^2 = 1 + 1.97686e-07 i
log(1 + 0.001 i) = 0.001 i, (1 + 0.001 i)^2 = 1 + 0.002 i
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
export LD_LIBRARY_PATH=$library:$library/blas:$library/lapack:$library/octave/7.3.0:$library/hdf5/serial:$work/root/usr/lib
export OCTAVE_HOME=$work/root/usr
package=quaternion-2.4.0
root/usr/bin/octave-cli --quiet --norc --path "$work/root/usr/share/octave/packages/$package" \
  --path "$(echo "$library/octave/packages/$package"/*)" real.m 2>log | tee seen
diff wanted seen
