// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/Curvature_potential.h>

#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <cmath>

namespace Conformal_geometry_processing {

Curvature_potential Curvature_potential::on_vertices(Eigen::VectorXd rho)
{
  return {On::vertices, std::move(rho)};
}

Curvature_potential no_potential(const Surface_ref& surface)
{
  return Curvature_potential::on_vertices(Eigen::VectorXd::Zero(surface.size_of_vertices()));
}

Eigen::VectorXd curvature_areas(const Surface_ref& surface, Curvature_potential::On on)
{
  if (on == Curvature_potential::On::vertices) return vertex_areas(surface);
  const Eigen::VectorXd areas = face_areas(surface);
  return areas.cwiseMax(1e-6 * areas.mean());
}

double mean(const Surface_ref& surface, const Curvature_potential& rho)
{
  const Eigen::VectorXd areas = curvature_areas(surface, rho.on);
  return areas.dot(rho.values) / areas.sum();
}

void require_potential(const Mesh_view& mesh, const Curvature_potential& rho, double unit,
                       const std::string& function)
{
  const bool on_faces = rho.on == Curvature_potential::On::faces;
  const int size = on_faces ? mesh.size_of_faces() : mesh.size_of_vertices();
  const std::string element = on_faces ? "face" : "vertex";
  if (rho.values.size() != size)
    throw Precondition_error(function, "rho has " + std::to_string(rho.values.size()) +
                                           " values, one per " + element +
                                           " is needed: " + std::to_string(size));
  internal::refuse_if_any(
      size, [&](int i) { return !std::isfinite(rho.values[i] * unit); },
      [&](int i) { return element + " " + std::to_string(i); }, function,
      "#value of rho not finite", "finite values are needed");
}

}  // namespace Conformal_geometry_processing
