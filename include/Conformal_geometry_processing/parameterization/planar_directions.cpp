// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/parameterization/planar_directions.h>

#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/mesh/topology.h>

#include <cmath>
#include <complex>
#include <cstddef>

namespace Conformal_geometry_processing {

Eigen::VectorXd turning_angles(const Mesh_view& mesh, const internal::Vertex_loop& loop)
{
  Eigen::VectorXd angles = Eigen::VectorXd::Zero(mesh.size_of_vertices());
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    for (int c = 0; c < 3; ++c)
      angles[mesh.corners(f)[static_cast<std::size_t>(c)]] += corner_angle(mesh.sheet(f), c);
  return std::acos(-1.) - angles(loop).array();
}

Points planar_directions(const Mesh_view& mesh, const std::string& function)
{
  if (!topology(mesh).is_disk())
    throw Precondition_error(function,
                             "the surface is not a disk (one loop, no handles); a disk is needed");
  const internal::Vertex_loop loop = boundary_loops(mesh).front();
  const Eigen::VectorXd turn = turning_angles(mesh, loop), length = lengths_along(mesh, loop);
  const Eigen::Index n = turn.size();
  const double missing = 2 * std::acos(-1.) - turn.sum();
  Points directions = Points::Zero(3, n);
  double angle = 0;  // of the incoming edge; the first one is along the x-axis
  for (Eigen::Index k = 0; k < n; ++k) {
    const double in = k == 0 ? length[n] - length[n - 1] : length[k] - length[k - 1],
                 out = length[k + 1] - length[k],
                 next = angle + turn[k] + missing * (in + out) / (2 * length[n]);
    // As by `circle_tangent()`.
    const std::complex<double> sum = std::polar(out, angle) + std::polar(in, next);
    directions.col(k) << sum.real() / std::abs(sum), sum.imag() / std::abs(sum), 0;
    angle = next;
  }
  return directions;
}

}  // namespace Conformal_geometry_processing
