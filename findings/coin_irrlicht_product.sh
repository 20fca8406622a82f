#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: Coin 4.0.0 (Debian libcoin-dev 4.0.0+ds-3), Irrlicht 1.8.5 (libirrlicht-dev 1.8.5+ds2-1).
# Expected: i j = k, as Hamilton has it, and as it is in Eigen, Boost and three.js; and the inverse of 2
# is 1/2.
# Seen: both libraries multiply in the other order, i j = -k. The inverse of Irrlicht is the conjugate,
# so that of 2 is 2, and Coin makes every quaternion one of length one as soon as it is given.
# Met: products of spins and frames, and lengths of spins.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install \
    libcoin-dev=4.0.0+ds-3 libcoin80c=4.0.0+ds-3 libirrlicht-dev=1.8.5+ds2-1 libeigen3-dev=3.4.0-4 \
    >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >coin.cpp <<'CPP'
#include <Inventor/SbRotation.h>

#include <cstdio>

void print(const char* what, const SbRotation& q)
{
  const float* const v = q.getValue();
  std::printf("Coin, %s = %g, %g, %g, %g\n", what, v[3], v[0], v[1], v[2]);
}

int main()
{
  print("i j", SbRotation(1, 0, 0, 0) * SbRotation(0, 1, 0, 0));
  print("2", SbRotation(0, 0, 0, 2));
}
CPP
cat >irrlicht.cpp <<'CPP'
#include <irrlicht/quaternion.h>

#include <cstdio>

void print(const char* what, const irr::core::quaternion& q)
{
  std::printf("Irrlicht, %s = %g, %g, %g, %g\n", what, q.W, q.X, q.Y, q.Z);
}

int main()
{
  using Quaternion = irr::core::quaternion;
  print("i j", Quaternion(1, 0, 0, 0) * Quaternion(0, 1, 0, 0));
  print("1 / 2", Quaternion(0, 0, 0, 2).makeInverse());
}
CPP
cat >eigen.cpp <<'CPP'
#include <Eigen/Geometry>

#include <cstdio>

int main()
{
  const Eigen::Quaterniond q = Eigen::Quaterniond(0, 1, 0, 0) * Eigen::Quaterniond(0, 0, 1, 0);
  std::printf("Eigen, i j = %g, %g, %g, %g\n", q.w(), q.x(), q.y(), q.z());
}
CPP
cat >wanted <<'TEXT'
Coin, i j = 0, 0, 0, -1
Coin, 2 = 1, 0, 0, 0
Irrlicht, i j = 0, 0, 0, -1
Irrlicht, 1 / 2 = 2, -0, -0, -0
Eigen, i j = 0, 0, 0, 1
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
for name in coin irrlicht eigen; do
  g++ -std=c++17 -w -I root/usr/include -I root/usr/include/irrlicht -I root/usr/include/eigen3 "$name.cpp" \
    -L"$library" $([ "$name" != coin ] || echo "$library/libCoin.so.80c") -Wl,--allow-shlib-undefined -o "$name"
  LD_LIBRARY_PATH=$library "./$name"
done | tee seen
diff wanted seen
