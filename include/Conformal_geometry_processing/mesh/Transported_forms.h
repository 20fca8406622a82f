// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Intrinsic_triangulation.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgMesh
/// \brief Closed 1-forms on an intrinsic triangulation, updated by its flips: integrals along paths
/// do not change, because the sum around every triangle is zero.
///
/// Takes 2 k |E| numbers, and O(k) for every flip; nothing if there are no forms.
class Transported_forms {
 public:
  /// \param forms |E| x k, along each edge i -> j of the mesh, i < j; closed; may be empty
  Transported_forms(const Mesh_view& mesh, const Eigen::MatrixXd& forms);

  /// Values along halfedge h, from its first vertex to its second; k numbers
  auto along(int h) const { return m_values.row(h); }

  Eigen::Index size() const { return m_values.cols(); }

  /// \pre the edge of h is about to be flipped
  void before_flip(const Intrinsic_triangulation& triangles, int h);

 private:
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  Rows m_values;  // one for each halfedge
  Rows m_sides;   // of the two triangles that a flip changes
};

}  // namespace Conformal_geometry_processing::internal
