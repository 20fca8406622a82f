// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MEASURE_LENGTH_CROSS_RATIO_H
#define CONFORMAL_GEOMETRY_PROCESSING_MEASURE_LENGTH_CROSS_RATIO_H

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

#include <cmath>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgMeasure
/// \brief the logarithm of the length cross-ratio l_il l_jk / (l_lj l_ki) of each interior edge ij
/// with the opposite vertices k (left) and l (right); zero at the boundary. |E| numbers.
///
/// Two meshes of the same connectivity are discretely conformally equivalent exactly if theirs
/// agree; Moebius transformations of the vertices keep it.
inline Eigen::VectorXd log_length_cross_ratios(const Mesh_view& mesh, const Points& positions)
{
  Eigen::VectorXd log_length(mesh.size_of_edges());
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    log_length[k] =
        std::log((positions.col(mesh.ends(k)[1]) - positions.col(mesh.ends(k)[0])).norm());
  Eigen::VectorXd ratio = Eigen::VectorXd::Zero(mesh.size_of_edges());
  for (int h = 0; h < mesh.size_of_halfedges(); ++h)
    if (mesh.twin(h) >= 0)  // from the left and from the right, the same quotient l_jk / l_ki
      ratio[mesh.edge(h)] += log_length[mesh.edge(Mesh_view::next_in_face(h))] -
                             log_length[mesh.edge(Mesh_view::previous_in_face(h))];
  return ratio;
}

/// \ingroup PkgMeasure
/// how far a map is from discretely conformal; zero for Moebius transformations
struct Length_cross_ratio_change {
  double rms = 0;  ///< over the interior edges
  double max = 0;  ///< absolute
};

/// \ingroup PkgMeasure
/// the change of the log length cross-ratios from the mesh to the new positions, 3 x |V|
inline Length_cross_ratio_change length_cross_ratio_change(const Mesh_view& mesh,
                                                           const Points& positions)
{
  const Eigen::VectorXd change =
      log_length_cross_ratios(mesh, positions) - log_length_cross_ratios(mesh, mesh.positions());
  int interior = 0;
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    interior += mesh.halfedges_end(k) - mesh.halfedges_begin(k) == 2;
  if (interior == 0) return {};
  return {change.norm() / std::sqrt(interior), change.cwiseAbs().maxCoeff()};
}

}  // namespace Conformal_geometry_processing

#endif
