// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// \brief the derivative of `restore_area()`: changes df of positions without the scaling and the
/// translation that restoring area and centroid undoes, and the transpose.
///
/// With the area A, its gradient g, and the centroid c,
///
///     df -> df - (f - c) <g, df> / (2A) - dc.
class Placement_derivative {
 public:
  /// \param mesh whose faces are measured; must outlive the object
  /// \param f positions after `restore_area()`, 3 x |V|
  Placement_derivative(const Mesh_view& mesh, Points f);

  /// \param df 3 x |V|
  Points apply(const Points& df) const;

  /// \param y 3 x |V|: the gradient of a function of the placed positions
  Points apply_transpose(const Points& y) const;

 private:
  const Mesh_view& m_mesh;
  Points m_arms;              // f - c
  Points m_area_gradient;     // g
  Eigen::VectorXd m_areas;    // |F|, of f
  Eigen::Matrix3Xd m_middle;  // barycentres of the faces - c
  Points m_normals;           // 3 x |F|
};

}  // namespace Conformal_geometry_processing::internal
