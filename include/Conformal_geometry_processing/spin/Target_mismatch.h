// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// \brief how far surfaces are from a target with the same faces, in positions and in normals, both
/// relative to the mesh that is to be deformed.
///
/// Positions alone do not tell what one sees: conformal surfaces come as near as one likes to any
/// surface in their positions, by ever finer wrinkles, whose normals stay far from those of it.
class Target_mismatch {
 public:
  struct Value {
    /// onto the target, with the root mean square distance of the vertices, weighted by areas and
    /// relative to the diagonal
    Alignment alignment;
    /// root mean square of |n - n'| for the unit normals n, n' of the faces, weighted by the areas
    /// of the target: for small angles these in radians, at most 2
    double normals = 0;
  };

  /// \param mesh that is to be deformed
  /// \param target 3 x |V|
  /// \param areas of the vertices
  /// \param normal_weight w
  /// \param tolerance a distance that nobody sees, relative to the diagonal
  /// \throw Precondition_error unless w and the tolerance are finite and at least 0
  Target_mismatch(const Mesh_view& mesh, Points target, Eigen::VectorXd areas, double normal_weight,
                  double tolerance);

  /// of a surface, 3 x |V|, anywhere in space and of any size
  Value operator()(const Points& positions) const;

  /// that of the mesh itself
  const Value& source() const { return m_source; }

  /// \brief (d / d_0)^2 + w (n / n_0)^2 for the distances d of positions and n of normals, with
  /// d_0, n_0 those of the mesh itself.
  ///
  /// A mesh that is the target has d_0 = 1e-9, and one of the same normals n_0 = 1e-3.
  double sum(double d, double n) const;

  /// \brief whether d is within the tolerance e and, unless w = 0, n is within 100 e: that is how
  /// far details of 1 % of the diagonal turn which are displaced by e.
  bool is_reached(double d, double n) const;

 private:
  Mesh_view m_target;
  Normalized_frame m_frame;  // of the target, where squares of areas neither overflow nor underflow
  Eigen::VectorXd m_areas;
  Points m_normals;  // of the target, times twice the areas of faces, in the frame
  double m_normal_weight, m_tolerance;
  Value m_source;
};

}  // namespace Conformal_geometry_processing::internal
