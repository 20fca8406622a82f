#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: SciPy 1.10.1 (Debian python3-scipy 1.10.1-2), Eigen 3.4.0 (libeigen3-dev 3.4.0-4).
# Expected: what scipy.io.mmwrite() writes, scipy.io.mmread() reads back bit by bit: both are of
# doubles, and the format is text of any length.
# Seen: more than half of the entries of a sparse matrix differ in the last bits: sixteen digits are
# written. A dense matrix in the same format gets seventeen and comes back exactly. Eigen's saveMarket()
# keeps sparse ones, too. mmwrite(..., precision=17) does.
# Met: comparing eigenvalues and solutions between programs to the last digits.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install python3-scipy=1.10.1-2 \
    libeigen3-dev=3.4.0-4 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >market.py <<'PY'
import numpy
import scipy.io
import scipy.sparse

values = 1 / numpy.arange(1., 1001)
sparse = scipy.sparse.diags(values).tocsr()
print("SciPy", scipy.__version__)
for name, matrix, more in (("sparse", sparse, {}), ("dense", values.reshape(40, 25), {}),
                           ("sparse, precision=17", sparse, {"precision": 17})):
    scipy.io.mmwrite("matrix.mtx", matrix, **more)
    print(name, "differ:", abs(scipy.io.mmread("matrix.mtx") - matrix).astype(bool).sum(), "of 1000")
PY
cat >market.cpp <<'CPP'
#include <Eigen/Sparse>
#include <unsupported/Eigen/SparseExtra>

#include <cstdio>

int main()
{
  Eigen::SparseMatrix<double> A(1000, 1000), B;
  for(int i = 0; i < 1000; ++i)
    A.insert(i, i) = 1. / (i + 1);
  Eigen::saveMarket(A, "eigen.mtx");
  Eigen::loadMarket(B, "eigen.mtx");
  std::printf("Eigen, sparse differ: %d of 1000\n", int((A.diagonal().array() != B.diagonal().array()).count()));
}
CPP
cat >wanted <<'TEXT'
SciPy 1.10.1
sparse differ: 572 of 1000
dense differ: 0 of 1000
sparse, precision=17 differ: 0 of 1000
Eigen, sparse differ: 0 of 1000
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
export LD_LIBRARY_PATH=$library:$library/blas:$library/lapack
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
g++ -std=c++17 -w -I root/usr/include/eigen3 market.cpp -o market
{ /usr/bin/python3 market.py && ./market; } | tee seen
diff wanted seen
