#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: Boost 1.74 (Debian libboost1.74-dev 1.74.0+ds1-21).
# Expected: dividing by a small quaternion is as safe as taking its absolute value, which scales by the
# largest component, and as dividing by a complex number.
# Seen: 1 / q is infinite where |q| < 1e-155, and zero where |q| > 1e155, because the division takes the
# sum of squares as it is; abs(q) is right for both, and std::complex divides right.
# Met: spin transformations divide by the quaternions of a solution, which has any scale.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install libboost1.74-dev=1.74.0+ds1-21 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >divide.cpp <<'CPP'
#include <boost/math/quaternion.hpp>
#include <boost/version.hpp>

#include <complex>
#include <cstdio>

int main()
{
  std::printf("Boost %s\n", BOOST_LIB_VERSION);
  for(double scale : {1e-150, 1e-170, 1e150, 1e170}) {
    const boost::math::quaternion<double> q(scale, 0, scale, 0), one(1), inverse = one / q;
    const std::complex<double> z = 1. / std::complex<double>(scale, scale);
    std::printf("%g: abs %.3g, 1/q = %.3g %.3g, 1/z = %.3g %.3g\n", scale, abs(q),
                inverse.R_component_1(), inverse.R_component_3(), z.real(), z.imag());
  }
}
CPP
cat >wanted <<'TEXT'
Boost 1_74
1e-150: abs 1.41e-150, 1/q = 5e+149 -5e+149, 1/z = 5e+149 -5e+149
1e-170: abs 1.41e-170, 1/q = inf -inf, 1/z = 5e+169 -5e+169
1e+150: abs 1.41e+150, 1/q = 5e-151 -5e-151, 1/z = 5e-151 -5e-151
1e+170: abs 1.41e+170, 1/q = 0 -0, 1/z = 5e-171 -5e-171
TEXT

g++ -std=c++17 -I root/usr/include divide.cpp -o divide
./divide | tee seen
diff wanted seen
