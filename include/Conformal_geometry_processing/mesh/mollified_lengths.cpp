// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/mollified_lengths.h>

#include <Eigen/Core>

#include <algorithm>

namespace Conformal_geometry_processing {

Eigen::VectorXd edge_lengths(const Mesh_view& mesh)
{
  Eigen::VectorXd lengths(mesh.size_of_edges());
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    lengths[k] = (mesh.position(mesh.ends(k)[1]) - mesh.position(mesh.ends(k)[0])).stableNorm();
  return lengths;
}

internal::Mollified_lengths mollified_lengths(const Mesh_view& mesh, double share)
{
  internal::Mollified_lengths result;
  result.lengths = edge_lengths(mesh);
  const double slack = share * result.lengths.mean();
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    Eigen::Vector3d l;
    for (int c = 0; c < 3; ++c) l[c] = result.lengths[mesh.edge(3 * f + c)];
    const double missing = slack + 2 * l.maxCoeff() - l.sum();
    result.thin_faces += missing > 0;
    result.added = (std::max)(result.added, missing);
  }
  result.lengths.array() += result.added;
  return result;
}

}  // namespace Conformal_geometry_processing
