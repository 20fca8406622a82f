// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Spin_preconditioner.h>

#include <Quaternionic_linear_algebra/dense/block_operators.h>
#include <Quaternionic_linear_algebra/dense/hermitian_eigen_decomposition.h>
#include <Quaternionic_linear_algebra/krylov/conjugate_gradients.h>

#include <algorithm>

namespace Conformal_geometry_processing::internal {

/// the components of the quaternions, a column for each column
Eigen::Map<const Eigen::MatrixXd> reals(const Block<Quaternion<double>>& V)
{
  return {reinterpret_cast<const double*>(V.data()), 4 * V.rows(), V.cols()};
}

/// the sums of columns with real factors, V C
Block<Quaternion<double>> real_combination(const Block<Quaternion<double>>& V,
                                           const Eigen::MatrixXd& C)
{
  Block<Quaternion<double>> sums(V.rows(), C.cols());
  Eigen::Map<Eigen::MatrixXd>(reinterpret_cast<double*>(sums.data()), 4 * V.rows(), C.cols()) =
      reals(V) * C;
  return sums;
}

Spin_preconditioner::Spin_preconditioner(Dirac_system& system, const Spin_residuals& residuals,
                                         double weight, double reuse)
    : m_system(system), m_gauge(system), m_weight(weight), m_reuse(reuse)
{
  for (Spin_residual* residual : residuals)
    (residual->is_few() ? m_few : m_dense).push_back(residual);
}

void Spin_preconditioner::update(const Spins& lambda, const Eigen::VectorXd& rho,
                                 Relaxed_costs& costs)
{
  m_lambda = lambda;
  const bool is_new = factorize(rho, costs);
  if (leaves_few()) {
    m_few_changes.resize(lambda.size(), 0);
    return;
  }
  const Eigen::Index columns = m_gradients.cols();
  const Spin_columns few = gradient_columns();
  m_gradients = combination(few.columns, few.factors);
  const double few_reuse = .1 * m_reuse;
  if (is_new || m_gradients.cols() != columns || m_moved - m_chosen_at > few_reuse)
    choose_few(few, costs);
  if (m_few_changes.cols() > 0) adopt_few();
}

Spin_columns Spin_preconditioner::gradient_columns() const
{
  if (!has_few()) return {Vectors(m_lambda.size(), 0), Vectors(0, 0)};
  Spin_columns few = columns_of(m_few, m_system.coefficients());
  for (Eigen::Index k = 0; k < few.columns.cols(); ++k)
    few.columns.col(k) = m_gauge.projected_gradient(m_lambda, few.columns.col(k));
  return few;
}

void Spin_preconditioner::choose_few(const Spin_columns& few, Relaxed_costs& costs)
{
  const double least = 1e-12;  // of the largest: less is rounding
  m_chosen_at = m_moved;
  m_few_changes.resize(m_gradients.rows(), 0);
  if (m_gradients.cols() == 0) return;
  const Vectors solved = combination(solve(few.columns), few.factors);
  costs.block_columns += static_cast<int>(few.columns.cols());
  const Eigen::MatrixXd products = real_gram_matrix(m_gradients, solved);
  const auto energies =
      hermitian_eigen_decomposition<double>((products + products.transpose()) / 2);
  const Eigen::Index size = (energies.values.array() > least * energies.values.maxCoeff()).count();
  const Eigen::MatrixXd C = energies.vectors.rightCols(size) *
                            energies.values.tail(size).cwiseSqrt().cwiseInverse().asDiagonal();
  m_few_changes = real_combination(solved, C);
  m_few_forces = real_combination(m_gradients, C);
}

// With the changes Y and the present gradients, S Y = X Y + G G^T Y; it is exact in what a large
// weight multiplies, though Y is old.
void Spin_preconditioner::adopt_few()
{
  const Eigen::MatrixXd& B = m_few_products = real_gram_matrix(m_gradients, m_few_changes);
  m_images = m_few_forces + real_combination(m_gradients, B);
  m_inverse.compute(Eigen::MatrixXd::Identity(B.cols(), B.cols()) + B.transpose() * B);
}

// The shift is that of the smallest eigenvalue, which is gauge, and leaves enough digits.
bool Spin_preconditioner::factorize(const Eigen::VectorXd& rho, Relaxed_costs& costs)
{
  const double least = 0.05, most_change = 4;
  Eigen::VectorXd shift = least * m_system.unit() * m_system.areas();
  for (const Spin_residual* residual : m_dense)
    if (const Eigen::VectorXd s = residual->stiffness(); s.size() > 0) shift += s / m_weight;
  const double stiffness = m_system.part().sum(shift.sum());
  const double ratio = stiffness / m_factored_stiffness;
  const bool is_kept = m_system.changes() == m_factored_changes && m_moved < m_reuse &&
                       ratio < most_change && ratio > 1 / most_change;
  if (is_kept) return false;
  factorize_at({rho, shift, 0}, costs);
  return true;
}

void Spin_preconditioner::factorize_at(const Origin& origin, Relaxed_costs& costs)
{
  m_factored_rho = origin.rho;
  m_factored_shift = origin.shift;
  const auto potential = Curvature_potential::on_vertices(m_factored_rho);
  m_system.set_potential(potential, m_factored_shift, costs.seconds);
  ++costs.factorizations;
  m_moved = origin.moved;
  m_factored_stiffness = m_system.part().sum(m_factored_shift.sum());
  m_factored_changes = m_system.changes();
}

auto Spin_preconditioner::solve(const Vectors& g) const -> Vectors
{
  Vectors y = m_system.precondition(g);
  for (Eigen::Index k = 0; k < y.cols(); ++k)
    y.col(k) = m_gauge.projected(m_lambda, y.col(k) / m_weight);
  return y;
}

bool Spin_preconditioner::leaves_few() const
{
  return std::any_of(m_few.begin(), m_few.end(), [](const Spin_residual* r) {
    return r->values().size() > r->most_one_by_one();
  });
}

// What hardly moves the values, such as points of a round sphere along it, takes no long steps.
auto Spin_preconditioner::correction(const Eigen::VectorXd& values, Relaxed_costs& costs) const
    -> Spins
{
  if (leaves_few()) return iterated_correction(values, costs);
  const double least = 1e-9;  // of the largest
  const auto products = m_few_products.topRows(values.size());
  Eigen::MatrixXd squares = products.transpose() * products;
  squares.diagonal().array() += least * squares.diagonal().maxCoeff();
  const Eigen::VectorXd c = squares.ldlt().solve(products.transpose() * values);
  return real_combination(m_few_changes, c).col(0);
}

// X^-1 G c with G^T X^-1 G c = values, by conjugate gradients.
auto Spin_preconditioner::iterated_correction(const Eigen::VectorXd& values,
                                              Relaxed_costs& costs) const -> Spins
{
  Conjugate_gradients_options options;
  options.tolerance = 1e-2;
  const auto change = [&](const Block<double>& c) -> Spins {
    ++costs.solves;
    return solve(m_gauge.projected_gradient(m_lambda, gradient_of(m_few, c))).col(0);
  };
  const auto product = [&](const Block<double>& c) -> Block<double> {
    return change_of(m_few, change(c));
  };
  const auto same = [](const Block<double>& c) { return c; };
  Block<double> c;
  conjugate_gradients(product, same, Block<double>(values), c, options);
  return change(c);
}

auto Spin_preconditioner::residual_product(const Spins& y) const -> Spins
{
  Spins sum = Spins::Constant(y.size(), {});
  const auto add = [&](const Spin_residuals& residuals) {
    for (const Spin_residual* r : residuals) sum += r->gradient(r->change(y));
  };
  add(m_dense);
  if (leaves_few())
    add(m_few);
  else if (m_gradients.cols() > 0)
    sum += real_combination(m_gradients, real_gram_matrix(m_gradients, Vectors(y))).col(0);
  return sum;
}

// S^-1 in the span of the changes, and X^-1 in what is orthogonal to it by S.
auto Spin_preconditioner::apply(const Vectors& g, Relaxed_costs& costs) const -> Vectors
{
  costs.solves += static_cast<int>(g.cols());
  if (m_few_changes.cols() == 0) return solve(g);
  const Eigen::MatrixXd c = m_inverse.solve(real_gram_matrix(m_few_changes, g));
  const Vectors y = solve(g - real_combination(m_images, c));
  const Eigen::MatrixXd too_far = m_inverse.solve(real_gram_matrix(m_images, y));
  return y + real_combination(m_few_changes, c - too_far);
}

}  // namespace Conformal_geometry_processing::internal
