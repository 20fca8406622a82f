// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Constraint_basis.h>

#include <Eigen/Core>

#include <utility>

namespace Conformal_geometry_processing {

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

}  // namespace Conformal_geometry_processing
