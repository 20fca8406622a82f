// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "User_frame.h"

namespace conformal {

User_frame::User_frame(const CGP::Mesh_view& mesh)
{
  const Eigen::Vector3d low = mesh.positions().rowwise().minCoeff();
  const Eigen::Vector3d high = mesh.positions().rowwise().maxCoeff();
  m_center = low / 2 + high / 2;
  m_unit = (high / 2 - low / 2).stableNorm();
}

}  // namespace conformal
