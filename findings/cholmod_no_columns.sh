#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: Eigen 3.4.0 (Debian libeigen3-dev 3.4.0-4), CHOLMOD 3.0.14 (libsuitesparse-dev 1:5.12.0+dfsg-2).
# Expected: solving for a matrix of no columns gives one of no columns, as Eigen::SimplicialLLT does.
# Seen: Eigen passes the null pointer of such a matrix, for which cholmod_solve() reports an invalid
# xtype. CholmodSupernodalLLT is then at NumericalIssue, and stays there: solve() sets it on failure
# only, so that later right-hand sides are solved, and reported as failed, until the next factorize().
# Met: a projection on an empty set of constraints; linear_algebra/adapters/Embedded_hermitian_solver.h.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get download libeigen3-dev=3.4.0-4 libsuitesparse-dev=1:5.12.0+dfsg-2 libcholmod3=1:5.12.0+dfsg-2 \
  libamd2=1:5.12.0+dfsg-2 libcamd2=1:5.12.0+dfsg-2 libcolamd2=1:5.12.0+dfsg-2 \
  libccolamd2=1:5.12.0+dfsg-2 libsuitesparseconfig5=1:5.12.0+dfsg-2 libmetis5 libblas3 liblapack3 \
  libgfortran5 libgomp1 libquadmath0 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >solve.cpp <<'CPP'
#include <Eigen/CholmodSupport>
#include <Eigen/SparseCholesky>

#include <cstdio>

int main()
{
  Eigen::SparseMatrix<double> A(3, 3);
  A.setIdentity();
  A *= 2;
  const Eigen::MatrixXd one = Eigen::MatrixXd::Ones(3, 1), none(3, 0);
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> eigen(A);
  Eigen::MatrixXd x = eigen.solve(none);
  std::printf("SimplicialLLT, no column: info %d, %d columns\n", eigen.info(), int(x.cols()));

  Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>> cholmod(A);
  cholmod.cholmod().print = 0;
  x = cholmod.solve(one);
  std::printf("CHOLMOD, one column: info %d, x %g\n", cholmod.info(), x(0, 0));
  x = cholmod.solve(none);
  std::printf("CHOLMOD, no column: info %d, status %d\n", cholmod.info(), cholmod.cholmod().status);
  x = cholmod.solve(one);
  std::printf("CHOLMOD, one column again: info %d, x %g\n", cholmod.info(), x(0, 0));
  cholmod.factorize(A);
  std::printf("CHOLMOD, factorized again: info %d\n", cholmod.info());
}
CPP
cat >wanted <<'TEXT'
SimplicialLLT, no column: info 0, 0 columns
CHOLMOD, one column: info 0, x 0.5
CHOLMOD, no column: info 1, status -4
CHOLMOD, one column again: info 1, x 0.5
CHOLMOD, factorized again: info 0
TEXT

library=$work/root/usr/lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH 2>/dev/null || gcc -dumpmachine)
export LD_LIBRARY_PATH=$library:$library/blas:$library/lapack
g++ -std=c++17 -w -I root/usr/include/eigen3 -I root/usr/include/suitesparse solve.cpp \
  -L "$library" -Wl,-rpath-link,"$LD_LIBRARY_PATH" -l:libcholmod.so.3 -o solve
ls -- *.deb
./solve | tee seen
diff wanted seen
