// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FLOW_CONSTRAINT_BASIS_H
#define CONFORMAL_GEOMETRY_PROCESSING_FLOW_CONSTRAINT_BASIS_H

#include <Conformal_geometry_processing/linear_algebra/dense/weighted_orthonormalization.h>

#include <Eigen/Core>

#include <cmath>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgFlow
/// \brief the functions on the vertices that a direction must be orthogonal to, in
/// sum_i M_V,i a_i b_i [CGP 6.4.4].
///
/// They come in groups, such as the constants, the components of the normals, or the functions
/// that keep a torus closed. Each group is orthonormalised by itself before it joins the others, so
/// groups of different scale go together, and what depends on earlier groups is dropped.
class Constraint_basis {
 public:
  /// \param areas M_V, |V| positive numbers
  explicit Constraint_basis(Eigen::VectorXd areas)
      : m_areas(std::move(areas)), m_basis(m_areas.size(), 0)
  {}

  /// \param functions |V| x k, one per column
  /// \throw Precondition_error if the number of rows is another, or a value is not finite
  void add(const Eigen::MatrixXd& functions)
  {
    const Eigen::MatrixXd group = weighted_orthonormalization(functions, m_areas);
    Eigen::MatrixXd both(m_basis.rows(), m_basis.cols() + group.cols());
    both << m_basis, group;
    m_basis = weighted_orthonormalization(both, m_areas);
  }

  /// the number of independent constraints
  Eigen::Index rank() const { return m_basis.cols(); }

  /// v without its part in their span
  Eigen::VectorXd project_out(Eigen::VectorXd v) const
  {
    return Conformal_geometry_processing::project_out(m_basis, m_areas, std::move(v));
  }

  /// root of sum_i M_V,i v_i^2
  double norm(const Eigen::VectorXd& v) const { return std::sqrt(m_areas.dot(v.cwiseAbs2())); }

 private:
  Eigen::VectorXd m_areas;  // |V|
  Eigen::MatrixXd m_basis;  // |V| x rank
};

}  // namespace Conformal_geometry_processing

#endif
