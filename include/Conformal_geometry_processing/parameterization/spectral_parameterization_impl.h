// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_PARAMETERIZATION_SPECTRAL_PARAMETERIZATION_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_PARAMETERIZATION_SPECTRAL_PARAMETERIZATION_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/measure/Distribution.h>
#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/parameterization/spectral_parameterization.h>

#include <Eigen/Core>

#include <string>

namespace Conformal_geometry_processing {

CGP_INLINE void require_boundary(const Mesh_view& mesh, const std::string& function)
{
  for (int h = 0; h < mesh.size_of_halfedges(); ++h)
    if (mesh.twin(h) < 0) return;
  throw Precondition_error(function,
                           "the surface is closed; one with a boundary is needed, cut it open");
}

namespace internal {

CGP_INLINE void certify(const Mesh_view& mesh, const Eigen::VectorXcd& z,
                        Parameterization_report& report)
{
  const Points positions = in_space(z);
  Points upward = Points::Zero(3, mesh.size_of_faces());
  upward.row(2).setOnes();
  report.boundary_loops = static_cast<int>(boundary_loops(mesh).size());
  report.conformality = conformality(mesh, positions, upward);
  report.uniform_quasi_conformal = distribution(quasi_conformal_errors(mesh, positions),
                                                Eigen::VectorXd::Ones(mesh.size_of_faces()));
  report.converged = report.converged && z.allFinite();
}

}  // namespace internal
}  // namespace Conformal_geometry_processing

#endif
