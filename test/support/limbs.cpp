// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "support/limbs.h"

namespace cgp_test {

Mesh_view dumbbell(int level)
{
  const Mesh_view mesh = mapped(icosphere(level), [](const Eigen::Vector3d& p) {
    const double y = p.y(), radius = .35 + .65 * y * y;
    return Eigen::Vector3d(radius * p.x(), 2.5 * y, radius * p.z());
  });
  return perturbed(mesh, .01);
}

Eigen::VectorXd rings(const Mesh_view& mesh, double amplitude, double frequency)
{
  Eigen::VectorXd rho(mesh.size_of_vertices());
  for (int v = 0; v < rho.size(); ++v)
    rho[v] = amplitude * std::sin(frequency * mesh.position(v).y() + .4);
  return rho;
}

}  // namespace cgp_test
