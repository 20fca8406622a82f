// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_CURVATURE_OF_SPINS_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_CURVATURE_OF_SPINS_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/operators/averaging.h>
#include <Conformal_geometry_processing/operators/dirac.h>
#include <Conformal_geometry_processing/spin/curvature_of_spins.h>

#include <Eigen/Core>

#include <utility>

namespace Conformal_geometry_processing {

CGP_INLINE Curvature_potential curvature_of_spins(const Mesh_view& mesh,
                                                  const Quaternion_vector<double>& mu)
{
  const Quaternion_vector<double> image = dirac(mesh) * mu, average = averaging(mesh) * mu;
  Eigen::VectorXd rho(mesh.size_of_faces());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const double square = squared_norm(average[f]);
    rho[f] = square > 0 ? dot(average[f], image[f]) / square : 0;
  }
  return Curvature_potential::on_faces(std::move(rho));
}

}  // namespace Conformal_geometry_processing

#endif
