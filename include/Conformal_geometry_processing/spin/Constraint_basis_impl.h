// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_CONSTRAINT_BASIS_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_CONSTRAINT_BASIS_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/spin/Constraint_basis.h>

#include <Eigen/Core>

#include <utility>

namespace Conformal_geometry_processing {

CGP_INLINE internal::Constraint_basis::Constraint_basis(Eigen::VectorXd areas)
    : m_areas(std::move(areas)), m_basis(m_areas.size(), 0)
{}

CGP_INLINE void internal::Constraint_basis::add(const Eigen::MatrixXd& functions)
{
  const Eigen::MatrixXd group = weighted_orthonormalization(functions, m_areas);
  Eigen::MatrixXd both(m_basis.rows(), m_basis.cols() + group.cols());
  both << m_basis, group;
  m_basis = weighted_orthonormalization(both, m_areas);
}

CGP_INLINE Eigen::VectorXd internal::Constraint_basis::project_out(Eigen::VectorXd v) const
{
  return Conformal_geometry_processing::project_out(m_basis, m_areas, std::move(v));
}

}  // namespace Conformal_geometry_processing

#endif
