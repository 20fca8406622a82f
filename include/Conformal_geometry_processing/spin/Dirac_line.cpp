// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Dirac_line.h>

#include <Conformal_geometry_processing/linear_algebra/dense/block_operators.h>
#include <Conformal_geometry_processing/linear_algebra/dense/block_products.h>
#include <Conformal_geometry_processing/linear_algebra/dense/extend_orthonormal.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>

#include <Eigen/Core>

#include <cmath>
#include <utility>

namespace Conformal_geometry_processing::internal {

Dirac_line::Dirac_line(const Dirac_system& system, const Curvature_potential& rho,
                       Dirac_solution at, const Eigen::VectorXd& change,
                       const Quaternion_vector<double>& dlambda)
    : m_at(std::move(at)), m_length(std::sqrt(system.squared_norm(m_at.lambda)))
{
  const int images = 4;
  const Eigen::VectorXd& areas = system.areas();
  extend_orthonormal(m_span, areas, m_at.lambda);
  bool is_new = extend_orthonormal(m_span, areas, dlambda);
  for (; is_new && m_solves < images; ++m_solves) {
    const Block<Quaternion<double>> last = m_span.rightCols(1);
    is_new = extend_orthonormal(
        m_span, areas,
        Quaternion_vector<double>(system.precondition(block_operator(areas)(last)).col(0)));
  }
  m_gram = Dirac_gram(system.surface(), rho, {rho.on, change}, m_span);
}

std::optional<Dirac_solution> Dirac_line::at(double t) const
{
  const double least_overlap = 0.8;
  Branch_point first;
  first.gamma = m_at.eigenvalue;
  first.c = Quaternion_vector<double>::Constant(m_span.cols(), {});
  first.c[0].w = 1;
  const Branch_point p = follow_branch(m_gram, first, t, least_overlap);
  if (p.t < t) return std::nullopt;
  Dirac_solution predicted = m_at;
  predicted.lambda = combination(m_span, Block<Quaternion<double>>(p.c)).col(0);
  components(predicted.lambda) *= m_length;
  predicted.eigenvalue = p.gamma;
  return predicted;
}

}  // namespace Conformal_geometry_processing::internal
