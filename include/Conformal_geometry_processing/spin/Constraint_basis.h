// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Quaternion.h>
#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>
#include <Conformal_geometry_processing/linear_algebra/dense/weighted_orthonormalization.h>

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// \brief an orthonormal basis of the functions on the vertices that a direction must be orthogonal
/// to, with the inner product sum_i M_V,i a_i b_i [CGP 6.4.4].
///
/// Functions are added in groups, such as the constants, the components of the normals, or the
/// functions that keep a torus closed. Each group is orthonormalised separately before it is added,
/// so the groups may differ in scale. Functions that depend linearly on earlier groups are dropped.
class Constraint_basis {
 public:
  /// \param areas M_V, |V| positive numbers
  explicit Constraint_basis(Eigen::VectorXd areas);

  /// \param functions |V| x k, one per column
  /// \throw Precondition_error if the number of rows is not |V|, or a value is not finite
  void add(Eigen::MatrixXd functions);

  /// the number of independent constraints
  Eigen::Index rank() const { return m_basis.cols(); }

  /// v without its component in the span of the constraints
  Eigen::VectorXd project_out(Eigen::VectorXd v) const;

  /// the norm sqrt(sum_i M_V,i v_i^2)
  double norm(const Eigen::VectorXd& v) const { return std::sqrt(m_areas.dot(v.cwiseAbs2())); }

 private:
  Eigen::VectorXd m_areas;  // |V|
  Eigen::MatrixXd m_basis;  // |V| x rank
};

}  // namespace Conformal_geometry_processing::internal
