// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/direct/Supernodal_cholesky.h>

#include "factors.h"

namespace cgp_benchmark {

namespace {

/// the factor that serves as a preconditioner
template <class Scalar>
struct Preconditioner : CGP::Supernodal_cholesky<Scalar> {
  using Base = CGP::Supernodal_cholesky<Scalar>;
  auto factorize(const CGP::Hermitian_sparse_matrix<Scalar>& A, const CGP::Vector<double>& shift)
  {
    return Base::factorize_preconditioner(A, shift);
  }
  auto solve(const CGP::Block<Scalar>& b, CGP::Block<Scalar>& x) const
  {
    return Base::precondition(b, x);
  }
};

}  // namespace

void add_native_factors(std::vector<Row>& rows)
{
  using Quaternion = CGP::Quaternion<double>;
  rows.push_back({"factor", "native, real n", measure_factor<CGP::Supernodal_cholesky<double>>});
  rows.push_back({"factor", "native, real n, float", measure_factor<Preconditioner<double>>});
  rows.push_back(
      {"factor", "native, quaternion n", measure_factor<CGP::Supernodal_cholesky<Quaternion>>});
  rows.push_back(
      {"factor", "native, quaternion n, float", measure_factor<Preconditioner<Quaternion>>});
}

}  // namespace cgp_benchmark
