// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Exactness_constraints.h>

#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Quaternionic_linear_algebra/dense/hermitian_eigen_decomposition.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {

namespace internal {

void require_weighted_functions(const Eigen::MatrixXd& functions, const Eigen::VectorXd& weights)
{
  const std::string name = "weighted_orthonormalization";
  if (functions.rows() != weights.size())
    throw Precondition_error(name, std::to_string(weights.size()) +
                                       " weights, one per row of the functions is needed: " +
                                       std::to_string(functions.rows()));
  for (Eigen::Index i = 0; i < weights.size(); ++i)
    if (!(weights[i] > 0) || !std::isfinite(weights[i]))
      throw Precondition_error(name, "weight " + std::to_string(i) + " is " +
                                         std::to_string(weights[i]) +
                                         "; positive numbers are needed");
  for (Eigen::Index j = 0; j < functions.cols(); ++j)
    if (!functions.col(j).allFinite())
      throw Precondition_error(name,
                               "function " + std::to_string(j) + " has a value that is not finite");
}

/// calls visit(first, rows) for blocks of rows that fit into the cache
template <class Visitor>
void for_blocks_of_rows(Eigen::Index size, const Visitor& visit)
{
  const Eigen::Index block = 512;
  for (Eigen::Index first = 0; first < size; first += block)
    visit(first, (std::min)(block, size - first));
}

Eigen::MatrixXd weighted_gram_matrix(const Eigen::MatrixXd& functions,
                                     const Eigen::VectorXd& weights)
{
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(functions.cols(), functions.cols());
  for_blocks_of_rows(functions.rows(), [&](Eigen::Index first, Eigen::Index rows) {
    const auto block = functions.middleRows(first, rows);
    const Eigen::MatrixXd weighted = weights.segment(first, rows).asDiagonal() * block;
    gram.noalias() += block.transpose() * weighted;
  });
  return gram;
}

/// the functions times a matrix with at most as many columns, in their memory
void replace_by_combinations(Eigen::MatrixXd& functions, const Eigen::MatrixXd& coefficients)
{
  for_blocks_of_rows(functions.rows(), [&](Eigen::Index first, Eigen::Index rows) {
    const Eigen::MatrixXd combinations = functions.middleRows(first, rows) * coefficients;
    functions.block(first, 0, rows, coefficients.cols()) = combinations;
  });
  functions.conservativeResize(Eigen::NoChange, coefficients.cols());
}

}  // namespace internal

Eigen::MatrixXd weighted_orthonormalization(Eigen::MatrixXd functions,
                                            const Eigen::VectorXd& weights, double threshold)
{
  internal::require_weighted_functions(functions, weights);
  if (functions.cols() == 0) return functions;
  const auto gram =
      hermitian_eigen_decomposition(internal::weighted_gram_matrix(functions, weights));
  const Eigen::VectorXd squared = gram.values.reverse();  // decreasing
  const Eigen::Index rank =
      squared[0] > 0 ? (squared.array() > threshold * threshold * squared[0]).count() : 0;
  internal::replace_by_combinations(functions,
                                    gram.vectors.rowwise().reverse().leftCols(rank) *
                                        squared.head(rank).cwiseSqrt().cwiseInverse().asDiagonal());
  // The basis is already orthonormal up to rounding / threshold^2, so that the Cholesky factor of
  // its Gram matrix, near the identity, makes it so and hardly mixes the directions.
  const Eigen::MatrixXd rest = internal::weighted_gram_matrix(functions, weights);
  rest.llt().matrixU().solveInPlace<Eigen::OnTheRight>(functions);
  return functions;
}

Eigen::VectorXd project_out(const Eigen::MatrixXd& basis, const Eigen::VectorXd& weights,
                            Eigen::VectorXd v)
{
  for (int pass = 0; pass < 2; ++pass) {
    const Eigen::VectorXd coefficients = basis.transpose() * weights.cwiseProduct(v);
    v -= basis * coefficients;
  }
  return v;
}

internal::Constraint_basis::Constraint_basis(Eigen::VectorXd areas)
    : m_areas(std::move(areas)), m_basis(m_areas.size(), 0)
{}

void internal::Constraint_basis::add(Eigen::MatrixXd functions)
{
  Eigen::MatrixXd group = weighted_orthonormalization(std::move(functions), m_areas);
  const Eigen::Index rank = m_basis.cols();
  m_basis.conservativeResize(Eigen::NoChange, rank + group.cols());
  m_basis.rightCols(group.cols()) = group;
  group.resize(0, 0);
  m_basis = weighted_orthonormalization(std::move(m_basis), m_areas);
}

Eigen::VectorXd internal::Constraint_basis::project_out(Eigen::VectorXd v) const
{
  return Conformal_geometry_processing::project_out(m_basis, m_areas, std::move(v));
}

internal::Constraint_basis internal::Exactness_constraints::basis() const
{
  internal::Constraint_basis basis(areas);
  if (!constants_have_effect) basis.add(Eigen::VectorXd::Ones(areas.size()));
  basis.add(functions);
  return basis;
}

double internal::Exactness_constraints::period_defect(const Eigen::MatrixX3d& edges) const
{
  if (!forms) return 0;
  // Uses |w|, because w is negative opposite large angles and then defines no norm.
  const double total = weights.cwiseAbs().dot(edges.rowwise().squaredNorm());
  return forms->coefficients(edges).norm() / std::sqrt(total);
}

internal::Exactness_constraints exactness_constraints(internal::Dirac_system& system,
                                                      const internal::Grounded_solver& laplacian,
                                                      Eigen::MatrixXd generators,
                                                      Curvature_potential::On on,
                                                      std::optional<Exactness> version,
                                                      const internal::Harmonic_part* start)
{
  const Surface_ref& surface = system.surface();
  internal::Exactness_constraints c;
  c.on = on;
  c.constants_have_effect = !system.is_self_adjoint();
  c.areas = curvature_areas(surface, on);
  c.functions = Eigen::MatrixXd(c.areas.size(), 0);
  if (generators.cols() == 0) return c;
  c.weights = cotan_weights(surface);
  const Hodge_decomposition hodge(surface, std::move(generators), laplacian, start);
  c.forms = hodge.harmonic_part();
  if (!version) return c;
  const double tolerance = 1e-5;  // far below the periods of second order that any edit leaves
  const bool is_thesis = system.is_closed() && version == Exactness::thesis;
  system.prepare_response();
  c.factorizations = 1;
  c.functions = exactness_functions(
      surface, hodge.harmonic_basis(),
      [&](const Block<Quaternion<double>>& b) { return system.response(b, tolerance, c.solves); },
      on, system.coefficients(), is_thesis ? Exactness::thesis : Exactness::adjoint);
  return c;
}

double internal::Period_limit::operator()(const Spin_report& report) const
{
  if (maximum) return *maximum;
  const double share_of_distortion = 0.25, rounding = 1e-10, least = 0.002, greatest = 0.02;
  const double distortion = report.conformality.quasi_conformal.mean - 1;
  const double closed = (std::max)({share_of_distortion * distortion, tolerance, rounding, least});
  return (std::min)(closed, greatest);
}

}  // namespace Conformal_geometry_processing
