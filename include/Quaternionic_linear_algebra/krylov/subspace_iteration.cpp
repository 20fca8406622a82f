// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/krylov/subspace_iteration.h>

#include <Quaternionic_linear_algebra/dense/hermitian_eigen_decomposition.h>
#include <Quaternionic_linear_algebra/threads/Thread_team.h>

#include <algorithm>
#include <complex>

namespace Conformal_geometry_processing {

template <class Scalar>
internal::Subspace_result<Scalar> subspace_iteration(const Hermitian_sparse_matrix<Scalar>& A,
                                                     const internal::Centered_mass<Scalar>& B,
                                                     double shift,
                                                     const internal::Solver_ref<Scalar>& solver,
                                                     Block<Scalar> x,
                                                     const internal::Subspace_options& options)
{
  const internal::Thread_team team;
  internal::Subspace_result<Scalar> result;
  B.orthonormalize(x);
  while (result.iterations < options.maximum_number_of_iterations && !result.converged) {
    const Block<Scalar> b = B * x;
    Block<Scalar> y;
    result.status = solver.solve(b, y);
    if (result.status != Solver_status::success) return result;
    const Block<Scalar> H = b.adjoint() * y;
    const auto ritz = hermitian_eigen_decomposition<Scalar>((H + H.adjoint()) / Scalar(2));
    const auto inverses = ritz.values.reverse();
    const Block<Scalar> turn = ritz.vectors.rowwise().reverse();
    if (!(inverses[0] > 0)) {
      result.status = Solver_status::numerical_issue;
      return result;
    }
    const double mu = 1 / inverses[0];
    const Vector<Scalar> v = x * turn.col(0), correction = mu * (y * turn.col(0)) - v;
    const Vector<Scalar> defect =
        mu * (b * turn.col(0)) - A * v - Scalar(shift) * B.weights().cwiseProduct(v);
    // |correction|^2 in the norm of A + shift D, relative to that of v
    const double error = internal::Scalar_traits<Scalar>::real(correction.dot(defect)) / mu;
    x = y * turn;
    B.orthonormalize(x);
    ++result.iterations;
    result.vector = x.col(0);
    result.eigenvalue = mu - shift;
    result.next_eigenvalue = inverses.size() > 1 ? 1 / inverses[1] - shift : HUGE_VAL;
    result.residual = std::sqrt((std::max)(0., error));
    result.converged = result.residual <= options.tolerance;
  }
  return result;
}

template internal::Subspace_result<double> subspace_iteration(
    const Hermitian_sparse_matrix<double>&, const internal::Centered_mass<double>&, double,
    const internal::Solver_ref<double>&, Block<double>, const internal::Subspace_options&);
template internal::Subspace_result<std::complex<double>> subspace_iteration(
    const Hermitian_sparse_matrix<std::complex<double>>&,
    const internal::Centered_mass<std::complex<double>>&, double,
    const internal::Solver_ref<std::complex<double>>&, Block<std::complex<double>>,
    const internal::Subspace_options&);

}  // namespace Conformal_geometry_processing
