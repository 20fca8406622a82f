// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_FREE_BOUNDARY_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_FREE_BOUNDARY_H

#include <Conformal_geometry_processing/linear_algebra/direct/Stopwatch.h>
#include <Conformal_geometry_processing/mesh/mean_edge_length.h>
#include <Conformal_geometry_processing/operators/dirac_forms.h>
#include <Conformal_geometry_processing/spin/Dirac_eigenproblem.h>
#include <Conformal_geometry_processing/spin/Dirac_solution.h>

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief the weight alpha^2 of nearness to 1 for a surface with free boundary, in 1/area:
/// alpha = 10 h / R^2 with the mean length h of the edges and pi R^2 the area.
///
/// Where h << alpha R^2 << R, the solution tends to the projection of 1 on the kernel of D - rho.
template <class Surface>
double nearness_weight(const Surface& mesh, const Eigen::VectorXd& areas)
{
  const double pi = std::acos(-1.);
  const double alpha = 10 * mean_edge_length(mesh) / (areas.sum() / pi);
  return alpha * alpha;
}

/// \ingroup PkgSpin
/// \brief the change of lambda = 1 on a surface with free boundary that answers to sources c for
/// rho = 0: (X + alpha^2 M_V)^-1 c.
/// \throw Solver_error if the matrix cannot be factored
template <class Problem>
Block<Quaternion<double>> free_response(Problem& problem, const Block<Quaternion<double>>& c)
{
  Dirac_solution::Seconds seconds;
  const Eigen::VectorXd& areas = problem.areas();
  problem.set_potential(no_potential(problem.mesh()),
                        nearness_weight(problem.mesh(), areas) * areas, seconds);
  return problem.solve(c);
}

/// \ingroup PkgSpin
/// \brief solves (D - rho) lambda = 0 with a free boundary, as near to lambda = 1 as it can be:
/// lambda minimises |(D - rho) lambda|^2 + alpha^2 |lambda - 1|^2.
///
/// Not the eigenvector of smallest eigenvalue, as [CGP 5.8.3] would have it: without a condition at
/// the boundary the kernel has infinite dimension, and which of its vectors has the smallest
/// discretisation error says nothing; often it has zeros. One factorization, one solve.
///
/// \param[in,out] s lambda, energy, residual, eigenvalue (the singular value of D - rho, which
/// tends to zero with the size of the faces) and seconds are filled in
template <class Problem>
void solve_with_free_boundary(Problem& problem, const Curvature_potential& rho, Dirac_solution& s)
{
  const Eigen::VectorXd& areas = problem.areas();
  const double weight = nearness_weight(problem.mesh(), areas);
  problem.set_potential(rho, weight * areas, s.seconds);
  Stopwatch watch;
  Block<Quaternion<double>> b(areas.size(), 1);
  for (Eigen::Index i = 0; i < b.rows(); ++i) b(i, 0) = {weight * areas[i], 0, 0, 0};
  const Block<Quaternion<double>> x = problem.solve(b);
  s.lambda = x.col(0);
  Block<Quaternion<double>> residual = problem.matrix() * s.lambda - b;
  for (Eigen::Index i = 0; i < b.rows(); ++i) residual(i, 0) += weight * areas[i] * s.lambda[i];
  s.residual = components(Quaternion_vector<double>(residual)).norm() /
               components(Quaternion_vector<double>(b)).norm();
  s.energy =
      inner_product(s.lambda, problem.matrix() * s.lambda).w / problem.squared_norm(s.lambda);
  s.eigenvalue = dirac_misfit(problem.mesh(), rho, s.lambda);  // no terms cancel, as they do in X
  s.converged = components(s.lambda).allFinite();
  s.seconds.eigenvectors += watch.lap();
}

}  // namespace Conformal_geometry_processing

#endif
