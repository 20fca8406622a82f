// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "flat_distortion.h"

#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/mesh/Mesh_component.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>

#include <cmath>
#include <vector>

namespace conformal {

Flat_distortion flat_distortion(const CGP::Mesh_view& mesh, const CGP::Points& positions)
{
  const CGP::internal::Normalized_frame frame(mesh.positions());
  const CGP::Mesh_view framed(frame.to_frame(mesh.positions()), mesh.corners());
  const CGP::Points flat = positions / frame.unit();
  const Eigen::VectorXd Q = CGP::quasi_conformal_errors(framed, flat);
  std::vector<char> has_area;
  for (const double q : Q) has_area.push_back(std::isfinite(q));
  const auto part = CGP::internal::selected_faces(framed, has_area);
  const int n = part.mesh.size_of_faces();
  Flat_distortion found{mesh.size_of_faces() - n, {}, {}, {}};
  if (n == 0) return found;
  const CGP::Points image = flat(Eigen::indexing::all, part.vertices);
  found.overlap =
      CGP::internal::overlap_summary(CGP::internal::overlaps(part.mesh, image), part.mesh, image);
  const CGP::Points up = Eigen::Vector3d::UnitZ().replicate(1, n);
  found.map = CGP::conformality(part.mesh, image, up);
  found.uniform_quasi_conformal = CGP::distribution(Q(part.faces), Eigen::VectorXd::Ones(n));
  return found;
}

}  // namespace conformal
