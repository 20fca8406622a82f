#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: Eigen 3.4.0 (Debian libeigen3-dev 3.4.0-4), SuiteSparse 5.12.0 (libsuitesparse-dev 1:5.12.0+dfsg-2).
# Expected: whether Eigen's CholmodDecomposition succeeds for an indefinite matrix does not depend on how
# large the matrix is: a Cholesky factorization fails, one as L D L^T does not.
# Seen: by default it is the second for small matrices and the first for large ones. The Laplacian of a
# grid less .5, with many negative eigenvalues, is factored (and solved rightly) for 2,500 points, with
# NaN as the logarithm of its determinant, and refused for 10,000.
# Met: whether a matrix is definite, told by its factorization. A test on a small mesh does not see it;
# CholmodSupernodalLLT tells it at any size.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install libeigen3-dev=3.4.0-4 \
    libsuitesparse-dev=1:5.12.0+dfsg-2 libcholmod3=1:5.12.0+dfsg-2 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >indefinite.cpp <<'CPP'
#include <Eigen/CholmodSupport>
#include <Eigen/SparseCore>

#include <cmath>
#include <cstdio>
#include <vector>

using Matrix = Eigen::SparseMatrix<double>;

Matrix shifted_laplacian(int n)
{
  std::vector<Eigen::Triplet<double>> entries;
  for(int k = 0; k < n * n; ++k) {
    entries.emplace_back(k, k, 3.5);
    for(int j : {k % n + 1 < n ? k + 1 : -1, k + n < n * n ? k + n : -1})
      if(j >= 0) {
        entries.emplace_back(k, j, -1);
        entries.emplace_back(j, k, -1);
      }
  }
  Matrix A(n * n, n * n);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

template <typename Solver>
void tell(const char* name, const Matrix& A)
{
  Solver solver;
  solver.cholmod().print = 0;
  solver.compute(A);
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(A.rows());
  if(solver.info() != Eigen::Success)
    std::printf("%s: refused\n", name);
  else
    std::printf("%s: factored, solved %s, logarithm of the determinant is %s\n", name,
                (A * solver.solve(b) - b).norm() < 1e-9 * b.norm() ? "rightly" : "wrongly",
                std::isnan(solver.logDeterminant()) ? "NaN" : "a number");
}

int main()
{
  for(int n : {50, 100}) {
    std::printf("%d points\n", n * n);
    const Matrix A = shifted_laplacian(n);
    tell<Eigen::CholmodDecomposition<Matrix>>("  CholmodDecomposition", A);
    tell<Eigen::CholmodSimplicialLDLT<Matrix>>("  CholmodSimplicialLDLT", A);
    tell<Eigen::CholmodSupernodalLLT<Matrix>>("  CholmodSupernodalLLT", A);
  }
}
CPP
cat >wanted <<'TEXT'
2500 points
  CholmodDecomposition: factored, solved rightly, logarithm of the determinant is NaN
  CholmodSimplicialLDLT: factored, solved rightly, logarithm of the determinant is NaN
  CholmodSupernodalLLT: refused
10000 points
  CholmodDecomposition: refused
  CholmodSimplicialLDLT: factored, solved rightly, logarithm of the determinant is NaN
  CholmodSupernodalLLT: refused
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
export LD_LIBRARY_PATH=$library:$library/blas:$library/lapack
g++ -std=c++17 -w -O1 -I root/usr/include/eigen3 -I root/usr/include/suitesparse indefinite.cpp -L "$library" \
  -Wl,-rpath-link,"$LD_LIBRARY_PATH" -l:libcholmod.so.3 -o indefinite
./indefinite 2>log | tee seen
diff wanted seen
