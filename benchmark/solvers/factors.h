// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Quaternionic_linear_algebra/dense/Solver_status.h>
#include <Quaternionic_linear_algebra/direct/Ordering.h>

#include <cmath>
#include <stdexcept>
#include <type_traits>

#include "Row.h"
#include "support/Cholmod_poisson.h"
#include "support/workloads.h"

/// The table of factorizations: the matrices of a spin transformation, and each model of
/// SparseHermitianSolver with its default ordering.
namespace cgp_benchmark {

inline void require(CGP::Solver_status status)
{
  if (status != CGP::Solver_status::success) throw std::runtime_error(CGP::to_string(status));
}

/// the cotan Laplacian for real scalars, the Dirac matrix for quaternions
template <class Scalar>
CGP::Hermitian_sparse_matrix<Scalar> matrix_of(const Job& job, const CGP::Mesh_view& mesh)
{
  if constexpr (std::is_floating_point_v<Scalar>)
    return CGP::cotan_laplacian(mesh);
  else
    return CGP::dirac_energy(mesh, smooth_potential(mesh, job.amplitude));
}

/// one quaternion, or three numbers, per vertex
template <class Scalar>
CGP::Block<Scalar> right_hand_sides(int rows)
{
  CGP::Block<Scalar> b(rows, std::is_floating_point_v<Scalar> ? 3 : 1);
  for (Eigen::Index c = 0; c < b.cols(); ++c)
    for (int i = 0; i < rows; ++i)
      b(i, c) = CGP::internal::Scalar_traits<Scalar>::from_real(std::sin(1. + i * double(c + 1)));
  return b;
}

/// |(A + shift) x - b| / |b|
template <class Scalar>
double relative_residual(const CGP::Hermitian_sparse_matrix<Scalar>& A,
                         const Eigen::VectorXd& shift, const CGP::Block<Scalar>& x,
                         const CGP::Block<Scalar>& b)
{
  const auto square = [](const Scalar& s) {
    return CGP::internal::Scalar_traits<Scalar>::real(CGP::conjugate(s) * s);
  };
  double error = 0, size = 0;
  for (Eigen::Index c = 0; c < b.cols(); ++c) {
    const CGP::Vector<Scalar> Ax = A * x.col(c);
    for (Eigen::Index i = 0; i < b.rows(); ++i) {
      error += square(Ax[i] + shift[i] * x(i, c) - b(i, c));
      size += square(b(i, c));
    }
  }
  return std::sqrt(error / size);
}

/// the matrix is shifted by a thousandth of its low eigenvalues, as the eigenvalue problem does
template <class Solver>
void measure_factor(const Job& job, const CGP::Mesh_view& mesh, Record& record)
{
  using Scalar = typename Solver::Scalar;
  const auto A = matrix_of<Scalar>(job, mesh);
  const Eigen::VectorXd shift = 1e-3 * CGP::vertex_areas(mesh);
  const auto b = right_hand_sides<Scalar>(A.size());
  CGP::Block<Scalar> x;
  double analysis = never, symbolic = never, numeric = never, again = never, solve = never;
  double bytes = 0;
  Poisson_seconds floor;
  repeat(job, [&] {
    floor.measure(mesh);
    Solver solver;
    keep_least(analysis,
               [&] { require(solver.analyze_with_positions(A.pattern(), mesh.positions())); });
    const CGP::internal::Ordering order = solver.ordering();
    keep_least(symbolic, [&] { require(solver.analyze(A.pattern(), order)); });
    keep_least(numeric, [&] { require(solver.factorize(A, shift)); });
    keep_least(again, [&] { require(solver.factorize(A, shift)); });
    for (int i = 0; i < 3; ++i) keep_least(solve, [&] { require(solver.solve(b, x)); });
    bytes = solver.statistics().bytes;
  });
  record.add("ordering", std::max(0., analysis - symbolic)).add("symbolic", symbolic);
  record.add("numeric", numeric).add("again", again).add("solve", solve).add("bytes", bytes);
  record.add("residual", relative_residual(A, shift, x, b)).add("poisson", floor.total);
  record.add("poisson_numeric", floor.numeric).add("poisson_again", floor.again);
  record.add("poisson_solve", floor.solve);
}

}  // namespace cgp_benchmark
