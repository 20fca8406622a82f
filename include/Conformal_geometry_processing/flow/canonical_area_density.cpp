// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/canonical_area_density.h>

#include <Conformal_geometry_processing/forms/Harmonic_basis.h>

#include <Eigen/Core>

#include <string>

namespace Conformal_geometry_processing {

Eigen::VectorXd canonical_area_density(const Surface_ref& surface, const Eigen::MatrixXd& one_forms,
                                       const std::string& function)
{
  if (one_forms.cols() == 0)
    throw Precondition_error(function,
                             "the surface is a sphere, which has no canonical metric; "
                             "genus 1 or more is needed");
  Eigen::VectorXd u = Eigen::VectorXd::Zero(surface.size_of_sheets());
  for (const auto omega : one_forms.colwise())
    u += tangent_field(surface, omega).colwise().squaredNorm().transpose() / 2;
  return u;
}

Eigen::VectorXd canonical_vertex_areas(const Surface_ref& surface, const Eigen::VectorXd& density)
{
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(surface.size_of_vertices());
  for (int s = 0; s < surface.size_of_sheets(); ++s) {
    const Sheet sheet = surface.sheet(s);
    for (const int v : sheet.corners) sum[v] += sheet.share * sheet.area * density[s] / 3;
  }
  return sum;
}

}  // namespace Conformal_geometry_processing
