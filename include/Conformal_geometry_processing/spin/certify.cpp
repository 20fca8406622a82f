// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/certify.h>

#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Quaternionic_linear_algebra/threads/Thread_team.h>

#include <algorithm>
#include <cmath>

namespace Conformal_geometry_processing {

Points rotated_normals(const Mesh_view& mesh, const Quaternion_vector<double>& lambda)
{
  Points normals(3, mesh.size_of_faces());
  internal::for_each_index(mesh.size_of_faces(), 1024, [&](int f) {
    const auto& v = mesh.corners(f);
    normals.col(f) = spin(lambda[v[0]] + lambda[v[1]] + lambda[v[2]], mesh.double_area_vector(f));
  });
  return normals;
}

namespace internal {

void certify(const Mesh_view& measured, const Points& f, const Quaternion_vector<double>& lambda,
             Spin_report& report, const Surface_part& part)
{
  report.conformality = measured_conformality(measured, f, rotated_normals(measured, lambda), part);
  const Eigen::VectorXd size =
      components(lambda).colwise().norm().head(part.own_vertices(lambda.size())).transpose();
  report.min_spin_ratio = part.smallest(size) / part.largest(size);
  report.converged = report.converged && part.sum(f.allFinite() ? 0 : 1) == 0;
}

}  // namespace internal

double internal::radius_of_area(const Surface_ref& surface, const Surface_part& part)
{
  const Eigen::VectorXd areas = face_areas(surface);
  return std::sqrt(part.sum(areas.head(part.own_faces(areas.size())).sum()) / std::acos(-1.));
}

double greatest_misfit(const Surface_ref& surface, const internal::Surface_part& part)
{
  const double radius = internal::radius_of_area(surface, part);
  return (std::max)(0.05, 3 * mean_edge_length(surface, part) / radius) / radius;
}

double greatest_zero(const Surface_ref& surface)
{
  const double radius = internal::radius_of_area(surface);
  return (std::max)(0.05, mean_edge_length(surface) / radius) / radius;
}

Spin_report::Boundary_fault boundary_fault(const Surface_ref& surface, double sigma,
                                           const Spin_report& report,
                                           const internal::Surface_part& part)
{
  const double radius = internal::radius_of_area(surface, part), small_gap = 0.01;
  const double h = mean_edge_length(surface, part) / radius, great_misfit = 0.15;
  const double closing = report.closure_residual;
  if (sigma > greatest_misfit(surface, part) &&
      (closing > small_gap || sigma * radius > great_misfit))
    return Spin_report::Boundary_fault::not_realizable;
  if (!report.has_positions && closing > (std::max)(report.limits.closure, 3 * h * h))
    return Spin_report::Boundary_fault::does_not_close;
  if (report.min_spin_ratio < 0.02) return Spin_report::Boundary_fault::degenerate;
  return Spin_report::Boundary_fault::none;
}

}  // namespace Conformal_geometry_processing
