// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "support/moebius.h"

namespace cgp_test {

Mesh_view inverted(const Mesh_view& mesh, const Eigen::Vector3d& center)
{
  return mapped(mesh, [&center](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    const Eigen::Vector3d q = p - center;
    return Eigen::Vector3d(q.x(), q.y(), -q.z()) / q.squaredNorm();
  });
}

}  // namespace cgp_test
