// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

namespace conformal {

namespace CGP = Conformal_geometry_processing;

/// The frame in which users give rho: the middle of the bounding box at 0, its diagonal 2.
class User_frame {
 public:
  explicit User_frame(const CGP::Mesh_view& mesh);

  Eigen::Vector3d operator()(const Eigen::Vector3d& p) const { return (p - m_center) / m_unit; }

  /// Its unit of length in units of the mesh
  double unit() const { return m_unit; }

 private:
  Eigen::Vector3d m_center;
  double m_unit;
};

}  // namespace conformal
