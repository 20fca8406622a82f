// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FLOW_CANONICAL_AREA_DENSITY_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_FLOW_CANONICAL_AREA_DENSITY_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/flow/canonical_area_density.h>
#include <Conformal_geometry_processing/forms/tangent_field.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <Eigen/Core>

#include <string>

namespace Conformal_geometry_processing {

CGP_INLINE Eigen::VectorXd canonical_area_density(const Harmonic_basis& basis,
                                                  const std::string& function)
{
  if (basis.size() == 0)
    throw Precondition_error(function,
                             "the surface is a sphere, which has no canonical metric; "
                             "genus 1 or more is needed");
  Eigen::VectorXd u = Eigen::VectorXd::Zero(basis.fields.front().cols());
  for (const Points& v : basis.fields) u += v.colwise().squaredNorm().transpose() / 2;
  return u;
}

CGP_INLINE Eigen::VectorXd canonical_vertex_areas(const Mesh_view& mesh,
                                                  const Eigen::VectorXd& density)
{
  const Eigen::VectorXd areas = face_areas(mesh).cwiseProduct(density);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(mesh.size_of_vertices());
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    for (int v : mesh.corners(f)) sum[v] += areas[f] / 3;
  return sum;
}

}  // namespace Conformal_geometry_processing

#endif
