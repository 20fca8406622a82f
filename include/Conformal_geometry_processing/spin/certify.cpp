// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/certify.h>

#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/threads/Thread_team.h>

#include <Eigen/Core>

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
             Spin_report& report)
{
  report.conformality = conformality(measured, f, rotated_normals(measured, lambda));
  const auto size = components(lambda).colwise().norm();
  report.min_spin_ratio = size.minCoeff() / size.maxCoeff();
  report.converged = report.converged && f.allFinite();
}

}  // namespace internal

}  // namespace Conformal_geometry_processing
