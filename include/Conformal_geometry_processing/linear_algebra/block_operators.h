// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_BLOCK_OPERATORS_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_BLOCK_OPERATORS_H

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/linear_algebra/Solver_status.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief x -> A x for all columns of x at once. Keeps a reference to A.
template <class Scalar>
auto block_operator(const Hermitian_sparse_matrix<Scalar>& A)
{
  return [&A](const Block<Scalar>& x) {
    Block<Scalar> y = Block<Scalar>::Constant(x.rows(), x.cols(), Scalar{});
    A.for_each_entry([&](int i, int j, const Scalar& a) {
      for (Eigen::Index c = 0; c < x.cols(); ++c) {
        y(i, c) += a * x(j, c);
        if (i != j) y(j, c) += conjugate(a) * x(i, c);
      }
    });
    return y;
  };
}

/// \ingroup PkgLinearAlgebra
/// \brief x -> diag(masses) x for all columns of x at once. Keeps a reference to the masses.
template <class FT>
auto block_operator(const Vector<FT>& masses)
{
  return [&masses](const Block<Quaternion<FT>>& x) {
    Block<Quaternion<FT>> y(x.rows(), x.cols());
    for (Eigen::Index c = 0; c < x.cols(); ++c)
      for (Eigen::Index i = 0; i < x.rows(); ++i) y(i, c) = masses[i] * x(i, c);
    return y;
  };
}

/// \ingroup PkgLinearAlgebra
/// \brief b -> the solution of A x = b for all columns of b at once, where `solver` has factorized
/// A. Keeps a reference to the solver; throws `Solver_error` where the solver fails.
template <class Solver>
auto inverse_operator(const Solver& solver)
{
  return [&solver](const Block<typename Solver::Scalar>& b) {
    Block<typename Solver::Scalar> x;
    const Solver_status status = solver.solve(b, x);
    if (status != Solver_status::success) throw Solver_error("inverse_operator", to_string(status));
    return x;
  };
}

}  // namespace Conformal_geometry_processing

#endif
