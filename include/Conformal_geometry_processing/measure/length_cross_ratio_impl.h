// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MEASURE_LENGTH_CROSS_RATIO_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_MEASURE_LENGTH_CROSS_RATIO_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/measure/length_cross_ratio.h>

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing {

CGP_INLINE Eigen::VectorXd log_length_cross_ratios(const Mesh_view& mesh, const Points& positions)
{
  Eigen::VectorXd log_length(mesh.size_of_edges());
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    log_length[k] =
        std::log((positions.col(mesh.ends(k)[1]) - positions.col(mesh.ends(k)[0])).norm());
  Eigen::VectorXd ratio = Eigen::VectorXd::Zero(mesh.size_of_edges());
  for (int h = 0; h < mesh.size_of_halfedges(); ++h)
    if (mesh.twin(h) >= 0)  // both sides contribute the same quotient l_jk / l_ki
      ratio[mesh.edge(h)] += log_length[mesh.edge(Mesh_view::next_in_face(h))] -
                             log_length[mesh.edge(Mesh_view::previous_in_face(h))];
  return ratio;
}

CGP_INLINE internal::Length_cross_ratio_change length_cross_ratio_change(const Mesh_view& mesh,
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
