#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: Eigen 3.4.0 (Debian libeigen3-dev 3.4.0-4).
# Expected: Eigen::GeneralizedSelfAdjointEigenSolver reports a failure where B is not positive definite, as
# Eigen::LLT, which it factors B with, does.
# Seen: it reports success, with values and vectors that do not satisfy A x = B x theta. The factorization is
# not asked whether it has failed. Where B is singular the values are NaN, which is reported.
# Met: pencils with masses, which are negative at vertices with obtuse triangles in some schemes.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install libeigen3-dev=3.4.0-4 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >pencil.cpp <<'CPP'
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <cstdio>

int main()
{
  std::printf("Eigen %d.%d.%d\n", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION);
  const Eigen::Matrix3d A = (Eigen::Matrix3d() << 2, 1, 0, 1, 3, 1, 0, 1, 4).finished();
  for(const double mass : {1., 0., -1.}) {
    const Eigen::Matrix3d B = Eigen::Vector3d(1, mass, 1).asDiagonal();
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix3d> solver(A, B);
    const Eigen::Matrix3d X = solver.eigenvectors();
    const Eigen::Vector3d theta = solver.eigenvalues();
    const bool is_solved = (A * X - B * X * theta.asDiagonal()).norm() < 1e-9;
    std::printf("mass %g: Cholesky %s, eigenvalues %s, equation %s\n", mass,
                B.llt().info() == Eigen::Success ? "succeeds" : "fails",
                solver.info() == Eigen::Success ? "succeed" : "fail", is_solved ? "holds" : "does not hold");
  }
}
CPP
cat >wanted <<'TEXT'
Eigen 3.4.0
mass 1: Cholesky succeeds, eigenvalues succeed, equation holds
mass 0: Cholesky fails, eigenvalues fail, equation does not hold
mass -1: Cholesky fails, eigenvalues succeed, equation does not hold
TEXT

g++ -std=c++17 -w -O1 -I root/usr/include/eigen3 pencil.cpp -o pencil
./pencil | tee seen
diff wanted seen
