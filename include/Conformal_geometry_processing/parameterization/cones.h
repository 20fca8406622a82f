// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// a vertex where a metric that is flat elsewhere keeps a curvature
struct Cone {
  int vertex;
  std::optional<double> defect = {};  ///< 2 pi minus the angle
};

/// cones, and the metric exp(2 u) times that of the surface which is flat outside them, to first
/// order: L u = defects - K
struct Cone_metric {
  std::vector<Cone> cones;    ///< with defects
  Eigen::VectorXd log_scale;  ///< u of each vertex, with mean zero over the area
};

/// \brief The angle defects K of the vertices: 2 pi minus the sum of the angles, pi at the
/// boundary, |V|. They sum to 2 pi chi.
Eigen::VectorXd angle_defects(const Mesh_view& mesh);

/// \brief Places cones such that areas change little in the conformal metric that is flat outside
/// them.
///
/// Each cone is placed where curvature decreases the variance of u most, after those before it; the
/// defects that are not given then minimize it, between -pi and pi each where that is possible. So
/// the variance falls with the number of cones. On a closed surface they sum to 2 pi chi [Gauss and
/// Bonnet]. A boundary takes what they leave: u is constant there, which of all boundary values
/// gives the least Dirichlet energy of u, and no cone lies on it. One factorization, and two solves
/// for each cone.
/// \param count how many, not more than inner vertices; at least 4 chi / 3 on a closed surface
/// \param first inner vertices that are cones, with defects or without, at most `count`
/// \pre the mesh is connected
Cone_metric place_cones(const Mesh_view& mesh, int count, const std::vector<Cone>& first = {});

}  // namespace Conformal_geometry_processing::internal
