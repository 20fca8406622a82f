// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Spin_residual.h>

#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <cmath>
#include <cstddef>

namespace Conformal_geometry_processing {
namespace internal {

Eigen::VectorXd values_at(const Spin_residual::Spins& lambda, const Spin_residuals& residuals)
{
  Eigen::VectorXd all;
  for (Spin_residual* r : residuals) {
    r->set_spins(lambda);
    const Eigen::VectorXd some = r->values();
    all.conservativeResize(all.size() + some.size());
    all.tail(some.size()) = some;
  }
  return all;
}

Spin_residuals vanishing_of(const Spin_residuals& residuals)
{
  Spin_residuals some;
  for (Spin_residual* r : residuals)
    if (r->has_to_vanish()) some.push_back(r);
  return some;
}

Eigen::Index number_of_values(const Spin_residuals& residuals)
{
  Eigen::Index size = 0;
  for (const Spin_residual* r : residuals) size += r->values().size();
  return size;
}

Eigen::VectorXd change_of(const Spin_residuals& residuals, const Spin_residual::Spins& dlambda)
{
  Eigen::VectorXd all(number_of_values(residuals));
  Eigen::Index first = 0;
  for (const Spin_residual* r : residuals) {
    const Eigen::VectorXd some = r->change(dlambda);
    all.segment(first, some.size()) = some;
    first += some.size();
  }
  return all;
}

auto gradient_of(const Spin_residuals& residuals, const Eigen::VectorXd& y) -> Spin_residual::Spins
{
  Spin_residual::Spins sum;
  Eigen::Index first = 0;
  for (const Spin_residual* r : residuals) {
    const Eigen::Index size = r->values().size();
    const Spin_residual::Spins some = r->gradient(y.segment(first, size));
    sum = first == 0 ? some : Spin_residual::Spins(sum + some);
    first += size;
  }
  return sum;
}

/// both in one: of the columns beside each other, and the factors as blocks
Spin_columns joined(const Spin_columns& a, const Spin_columns& b)
{
  const Eigen::Index m = a.factors.rows(), n = a.factors.cols();
  Spin_columns all;
  all.columns.resize(a.columns.rows(), m + b.factors.rows());
  all.columns << a.columns, b.columns;
  all.factors.setConstant(m + b.factors.rows(), n + b.factors.cols(), {});
  all.factors.topLeftCorner(m, n) = a.factors;
  all.factors.bottomRightCorner(b.factors.rows(), b.factors.cols()) = b.factors;
  return all;
}

Spin_columns columns_of(const Spin_residuals& residuals, Coefficients coefficients)
{
  Spin_columns all = residuals.front()->columns();
  for (std::size_t i = 1; i < residuals.size(); ++i) all = joined(all, residuals[i]->columns());
  if (coefficients == Coefficients::quaternions) return all;
  const Eigen::Index size = all.factors.cols();
  all.columns = combination(all.columns, all.factors);
  all.factors.setConstant(size, size, {});
  all.factors.diagonal().setConstant({1, 0, 0, 0});
  return all;
}

Eigen::VectorXd log_scales(const Quaternion_vector<double>& lambda)
{
  Eigen::VectorXd u(lambda.size());
  for (Eigen::Index i = 0; i < u.size(); ++i) u[i] = std::log(squared_norm(lambda[i]));
  return u;
}

Eigen::MatrixXd log_scale_change(const Quaternion_vector<double>& lambda,
                                 const Block<Quaternion<double>>& dlambda)
{
  Eigen::MatrixXd du(dlambda.rows(), dlambda.cols());
  for (Eigen::Index k = 0; k < du.cols(); ++k)
    for (Eigen::Index i = 0; i < du.rows(); ++i)
      du(i, k) = 2 * (conjugate(lambda[i]) * dlambda(i, k)).w / squared_norm(lambda[i]);
  return du;
}

Block<Quaternion<double>> log_scale_gradient(const Quaternion_vector<double>& lambda,
                                             const Eigen::MatrixXd& y)
{
  Block<Quaternion<double>> q(y.rows(), y.cols());
  for (Eigen::Index k = 0; k < q.cols(); ++k)
    for (Eigen::Index i = 0; i < q.rows(); ++i)
      q(i, k) = (2 * y(i, k) / squared_norm(lambda[i])) * lambda[i];
  return q;
}

}  // namespace internal

double nearness_weight(const Surface_ref& surface, const internal::Surface_part& part)
{
  const Eigen::VectorXd areas = face_areas(surface);
  const double pi = std::acos(-1.), area = part.sum(areas.head(part.own_faces(areas.size())).sum());
  const double alpha = 10 * mean_edge_length(surface, part) / (area / pi);
  return alpha * alpha;
}

namespace internal {

Eigen::VectorXd Nearness_residual::values() const
{
  return change(m_lambda - Spins::Constant(m_lambda.size(), {1, 0, 0, 0}));
}

Eigen::VectorXd Nearness_residual::change(const Spins& dlambda) const
{
  Spins scaled = dlambda;
  for (Eigen::Index v = 0; v < scaled.size(); ++v) scaled[v] *= std::sqrt(m_masses[v]);
  return components(scaled).reshaped();
}

auto Nearness_residual::gradient(const Eigen::VectorXd& y) const -> Spins
{
  Spins q(m_masses.size());
  components(q) = y.reshaped(4, m_masses.size()) * m_masses.cwiseSqrt().asDiagonal();
  return q;
}

Scale_residual::Scale_residual(Eigen::VectorXd areas, Eigen::VectorXd wanted,
                               const Eigen::VectorXd& weights, Surface_part part)
    : m_part(std::move(part)),
      m_areas(std::move(areas)),
      m_masses(m_areas),
      m_wanted(std::move(wanted)),
      m_area(m_part.sum(m_areas.sum()))
{
  if (weights.size() > 0) m_masses.array() *= weights.array();
}

void Scale_residual::set_spins(const Spins& lambda)
{
  m_lambda = lambda;
}

Eigen::VectorXd Scale_residual::values() const
{
  return weighted(log_scales(m_lambda) - m_wanted);
}

Eigen::VectorXd Scale_residual::change(const Spins& dlambda) const
{
  return weighted(log_scale_change(m_lambda, dlambda));
}

auto Scale_residual::gradient(const Eigen::VectorXd& y) const -> Spins
{
  Eigen::VectorXd z = (m_weight * m_masses).cwiseSqrt().cwiseProduct(y);
  z -= m_areas * (m_part.sum(z.sum()) / m_area);
  return log_scale_gradient(m_lambda, z);
}

Eigen::VectorXd Scale_residual::weighted(Eigen::VectorXd u) const
{
  u.array() -= m_part.sum(m_areas.dot(u)) / m_area;
  return (m_weight * m_masses).cwiseSqrt().cwiseProduct(u);
}

}  // namespace internal
}  // namespace Conformal_geometry_processing
