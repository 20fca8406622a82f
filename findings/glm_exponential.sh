#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: GLM 0.9.9.8 (Debian libglm-dev 0.9.9.8+ds-6).
# Expected: exp(log(q)) = q, as log has the logarithm of the length in its real part.
# Seen: exp leaves the real part out, so that exp(log(q)) has length one, and where there is no other
# part it is zero: exp(0) = 0, exp(1) = 0. pow, which does not use it, is right.
# Met: spins, whose length is the scale of the surface.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install libglm-dev=0.9.9.8+ds-6 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >exponential.cpp <<'CPP'
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/quaternion.hpp>

#include <cstdio>

void print(const char* what, const glm::dquat& q)
{
  std::printf("%s = %.4f, %.4f, %.4f, %.4f\n", what, q.w, q.x, q.y, q.z);
}

int main()
{
  std::printf("GLM %d.%d.%d.%d\n", GLM_VERSION_MAJOR, GLM_VERSION_MINOR, GLM_VERSION_PATCH, GLM_VERSION_REVISION);
  const glm::dquat q(1, 2, 3, 4);
  print("log(q)", glm::log(q));
  print("exp(log(q))", glm::exp(glm::log(q)));
  print("pow(q, 1)", glm::pow(q, 1.));
  print("exp(0)", glm::exp(glm::dquat(0, 0, 0, 0)));
  print("exp(1)", glm::exp(glm::dquat(1, 0, 0, 0)));
}
CPP
cat >wanted <<'TEXT'
GLM 0.9.9.8
log(q) = 1.7006, 0.5152, 0.7728, 1.0304
exp(log(q)) = 0.1826, 0.3651, 0.5477, 0.7303
pow(q, 1) = 1.0000, 2.0000, 3.0000, 4.0000
exp(0) = 0.0000, 0.0000, 0.0000, 0.0000
exp(1) = 0.0000, 0.0000, 0.0000, 0.0000
TEXT

g++ -std=c++17 -w -I root/usr/include exponential.cpp -o exponential
./exponential | tee seen
diff wanted seen
