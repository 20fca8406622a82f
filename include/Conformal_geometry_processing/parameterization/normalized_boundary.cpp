// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/parameterization/normalized_boundary.h>

#include <Conformal_geometry_processing/mesh/topology.h>

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

}  // namespace Conformal_geometry_processing
