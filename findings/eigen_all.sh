#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: Eigen 3.4.0 (Debian libeigen3-dev 3.4.0-4), Eigen 5.0.1 (libeigen3-dev 5.0.1-3).
# Expected: x(Eigen::all, columns) compiles with both. The header of 3.4.0 deprecates the other spelling,
# Eigen::placeholders::all, and asks for Eigen::all.
# Seen: 5.0.1 has the deprecated spelling and not the other. Whoever follows the advice of 3.4.0 does not
# compile with 5.0.1, and what 5.0.1 documents is warned of by 3.4.0. Only Eigen::indexing::all, to which
# neither header points, compiles with both without a warning.
# Met: columns of blocks; mesh/Mesh_component.cpp, flow/fair_region.cpp.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
pool=http://deb.debian.org/debian/pool/main/e/eigen3
for version in 3.4.0-4 5.0.1-3; do
  curl --silent --show-error --fail --location --remote-name "$pool/libeigen3-dev_${version}_all.deb"
  dpkg-deb --extract "libeigen3-dev_${version}_all.deb" "$version"
done

cat >all.cpp <<'CPP'
#include <Eigen/Core>

#include <cstdio>
#include <vector>

int main()
{
  const Eigen::Matrix3d x = Eigen::Vector3d(1, 2, 3).asDiagonal();
  const std::vector<int> columns = {2, 0};
  const Eigen::MatrixXd y = x(ALL, columns);
  return y(2, 0) == 3 && y(0, 1) == 1 ? 0 : 1;
}
CPP
cat >wanted <<'TEXT'
3.4.0-4, Eigen::all: compiles
3.4.0-4, Eigen::placeholders::all: warns
3.4.0-4, Eigen::indexing::all: compiles
5.0.1-3, Eigen::all: does not compile
5.0.1-3, Eigen::placeholders::all: compiles
5.0.1-3, Eigen::indexing::all: compiles
TEXT

for version in 3.4.0-4 5.0.1-3; do
  for all in Eigen::all Eigen::placeholders::all Eigen::indexing::all; do
    compile=(g++ -std=c++17 -I "$version/usr/include/eigen3" "-DALL=$all" all.cpp -o all)
    if "${compile[@]}" -Werror=deprecated-declarations 2>/dev/null && ./all; then
      echo "$version, $all: compiles"
    elif "${compile[@]}" 2>/dev/null && ./all; then
      echo "$version, $all: warns"
    else
      echo "$version, $all: does not compile"
    fi
  done
done | tee seen
diff wanted seen
