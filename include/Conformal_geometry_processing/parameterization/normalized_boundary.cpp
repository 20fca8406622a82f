// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/parameterization/normalized_boundary.h>

#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>

namespace Conformal_geometry_processing {

Eigen::VectorXd lengths_along(const Mesh_view& mesh, const internal::Vertex_loop& loop)
{
  Eigen::VectorXd length = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(loop.size()) + 1);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const int v = loop[i], next = loop[(i + 1) % loop.size()];
    const auto k = static_cast<Eigen::Index>(i);
    length[k + 1] = length[k] + (mesh.position(next) - mesh.position(v)).norm();
  }
  return length;
}

std::vector<internal::Vertex_loop> normalized_loops(const Mesh_view& mesh,
                                                    internal::Normalized_boundary which)
{
  std::vector<internal::Vertex_loop> loops = boundary_loops(mesh);
  std::size_t longest = 0;
  double length = 0;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const double l = lengths_along(mesh, loops[i]).tail<1>()[0];
    if (l > length) longest = i, length = l;
  }
  std::swap(loops[0], loops[longest]);
  if (which == internal::Normalized_boundary::longest_loop) loops.resize(1);
  return loops;
}

Eigen::MatrixXcd circle_maps(const Mesh_view& mesh, const std::vector<internal::Vertex_loop>& loops,
                             int count)
{
  Eigen::MatrixXcd z = Eigen::MatrixXcd::Zero(mesh.size_of_vertices(), count);
  const double turn = 2 * std::acos(-1.);
  for (const internal::Vertex_loop& loop : loops) {
    const Eigen::VectorXd length = lengths_along(mesh, loop);
    for (std::size_t i = 0; i < loop.size(); ++i)
      for (int k = 0; k < count; ++k)
        z(loop[i], k) = std::polar(
            1., (k + 1) * turn * length[static_cast<Eigen::Index>(i)] / length.tail<1>()[0]);
  }
  return z;
}

Points planar_directions(const Mesh_view& mesh, const std::string& function)
{
  if (!topology(mesh).is_disk())
    throw Precondition_error(function,
                             "the surface is not a disk (one loop, no handles); a disk is needed");
  const internal::Vertex_loop loop = boundary_loops(mesh).front();
  const Eigen::VectorXd turn = internal::angle_defects(mesh)(loop),
                        length = lengths_along(mesh, loop);
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
