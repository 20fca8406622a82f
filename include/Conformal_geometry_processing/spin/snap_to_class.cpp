// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/snap_to_class.h>

#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/requirements.h>

#include <Eigen/Core>

#include <cmath>
#include <string>
#include <utility>

namespace Conformal_geometry_processing::internal {

void require_edge_lengths(const Mesh_view& mesh, const std::string& function)
{
  require_manifold_components(mesh, function);
  refuse_if_any(
      mesh.size_of_edges(),
      [&](int k) { return mesh.position(mesh.ends(k)[0]) == mesh.position(mesh.ends(k)[1]); },
      [&](int k) { return name_of_edge(mesh, k); }, function, "#edge of length zero",
      "its ends have to be different points");
}

Class_snap_report snap_to_class(const Mesh_view& reference, Points& positions,
                                const Snap_options& options, Rim_directions rim)
{
  const Normalized_frame frame(positions);
  Points f = frame.to_frame(positions);
  Conformal_class conformal_class(reference);
  conformal_class.keep(std::move(rim));
  const Snap_report snap = conformal_class.snap(f, options);
  Class_snap_report report;
  report.converged = snap.converged;
  report.iterations = snap.iterations;
  report.factorizations = snap.factorizations;
  report.initial_length_cross_ratio = length_cross_ratio_change(reference, positions);
  Points moved = snap.iterations == 0 ? positions : frame.from_frame(std::move(f));
  const double diagonal = (positions.rowwise().maxCoeff() - positions.rowwise().minCoeff()).norm();
  report.displacement = (moved - positions).norm() / std::sqrt(double(positions.cols())) / diagonal;
  report.length_cross_ratio = length_cross_ratio_change(reference, moved);
  positions = std::move(moved);
  return report;
}

}  // namespace Conformal_geometry_processing::internal
