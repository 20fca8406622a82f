// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/surfaces/dirac_disk.h>

namespace Conformal_geometry_processing {

Spin_result dirac_disk(const Mesh_view& mesh, double wanted, const Dirac_options& options,
                       const std::string& function)
{
  Spin_transformation_options own{Boundary_condition::binormals()};
  own.dirac = options;
  own.dirac.branch = Dirac_options::Branch::smallest;
  const auto rho =
      Curvature_potential::on_vertices(Eigen::VectorXd::Constant(mesh.size_of_vertices(), wanted));
  Spin_result result = Spin_transformation(mesh, own, function).transform(rho);
  result.report.limits.map.flipped_share = 0;
  return result;
}

}  // namespace Conformal_geometry_processing
