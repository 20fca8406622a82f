// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FORMS_DIRAC_ENERGY_INVERSE_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_FORMS_DIRAC_ENERGY_INVERSE_TEMPLATES_H

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/forms/Dirac_energy_inverse.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Supernodal_cholesky.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/conjugate_gradients.h>

#include <Eigen/Core>

#include <algorithm>

namespace Conformal_geometry_processing {

template <class Solver>
internal::Dirac_energy_inverse<Solver>::Dirac_energy_inverse(
    const Hermitian_sparse_matrix<Quaternion<double>>& X, const Eigen::VectorXd& areas,
    const Solver& solver)
    : m_X(X), m_areas(areas), m_solver(solver)
{}

template <class Solver>
auto internal::Dirac_energy_inverse<Solver>::operator()(const Vectors& c) const -> Vectors
{
  Vectors Y(c.rows(), c.cols());
  for (Eigen::Index first = 0; first < c.cols(); first += at_once) {
    const Eigen::Index count = (std::min)(at_once, c.cols() - first);
    Y.middleCols(first, count) = solve(c.middleCols(first, count));
  }
  return Y;
}

template <class Solver>
auto internal::Dirac_energy_inverse<Solver>::solve(Vectors c) const -> Vectors
{
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(c.rows());
  remove_mean(c, ones);
  const auto factor = inverse_operator(m_solver);
  // The factor amplifies constants, and with them rounding errors, which X does not see.
  const auto precondition = [&](const Vectors& r, Vectors& z) {
    factor(r, z);
    remove_mean(z, ones);
  };
  internal::Conjugate_gradients_options options;
  options.tolerance = 1e-11;
  Vectors Y;
  const auto result = conjugate_gradients(block_operator(m_X), precondition, c, Y, options);
  // Slivers leave fewer correct digits, after which the iterations break down.
  if (!result.converged && !(result.estimates.maxCoeff() <= worst_error))
    throw Solver_error("Dirac_energy_inverse", "the iterations do not converge");
  remove_mean(Y, m_areas);
  return Y;
}

template <class Solver>
void internal::Dirac_energy_inverse<Solver>::remove_mean(Vectors& v, const Eigen::VectorXd& masses)
{
  for (auto column : v.colwise()) {
    Quaternion<double> sum{};
    for (Eigen::Index i = 0; i < v.rows(); ++i) sum += masses[i] * column[i];
    sum *= 1 / masses.sum();
    for (Quaternion<double>& value : column) value -= sum;
  }
}

}  // namespace Conformal_geometry_processing

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
namespace Conformal_geometry_processing {

extern template class internal::Dirac_energy_inverse<Supernodal_cholesky<Quaternion<double>>>;

}  // namespace Conformal_geometry_processing
#endif

#endif
