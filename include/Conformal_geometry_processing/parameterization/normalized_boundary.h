// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_PARAMETERIZATION_NORMALIZED_BOUNDARY_H
#define CONFORMAL_GEOMETRY_PROCESSING_PARAMETERIZATION_NORMALIZED_BOUNDARY_H

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/boundary_loops.h>

#include <Eigen/Core>

#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgParameterization
/// \brief of which part of the boundary the spread is kept while the energy is made least.
enum class Normalized_boundary {
  longest_loop,  ///< holes take the shapes and sizes that suit the map
  all_loops
};

/// a closed curve in a mesh, as its vertices in order
using Vertex_loop = std::vector<int>;

/// \ingroup PkgParameterization
/// the length of the closed polygon up to each of its vertices, and the whole length at the end
inline Eigen::VectorXd lengths_along(const Mesh_view& mesh, const Vertex_loop& loop)
{
  Eigen::VectorXd length = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(loop.size()) + 1);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const int v = loop[i], next = loop[(i + 1) % loop.size()];
    const auto k = static_cast<Eigen::Index>(i);
    length[k + 1] = length[k] + (mesh.position(next) - mesh.position(v)).norm();
  }
  return length;
}

/// \ingroup PkgParameterization
/// \brief the boundary loops that are normalized, the longest one first.
/// \pre the mesh is a manifold with boundary
inline std::vector<Vertex_loop> normalized_loops(const Mesh_view& mesh, Normalized_boundary which)
{
  std::vector<Vertex_loop> loops = boundary_loops(mesh);
  std::size_t longest = 0;
  double length = 0;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const double l = lengths_along(mesh, loops[i]).tail<1>()[0];
    if (l > length) longest = i, length = l;
  }
  std::swap(loops[0], loops[longest]);
  if (which == Normalized_boundary::longest_loop) loops.resize(1);
  return loops;
}

/// \ingroup PkgParameterization
/// \brief `count` maps of the loops to the plane, zero elsewhere: by length around the unit circle
/// once, twice, ...; where least energy is sought from. |V| x count.
inline Eigen::MatrixXcd circle_maps(const Mesh_view& mesh, const std::vector<Vertex_loop>& loops,
                                    int count)
{
  Eigen::MatrixXcd z = Eigen::MatrixXcd::Zero(mesh.size_of_vertices(), count);
  const double turn = 2 * std::acos(-1.);
  for (const Vertex_loop& loop : loops) {
    const Eigen::VectorXd length = lengths_along(mesh, loop);
    for (std::size_t i = 0; i < loop.size(); ++i)
      for (int k = 0; k < count; ++k)
        z(loop[i], k) = std::polar(
            1., (k + 1) * turn * length[static_cast<Eigen::Index>(i)] / length.tail<1>()[0]);
  }
  return z;
}

}  // namespace Conformal_geometry_processing

#endif
