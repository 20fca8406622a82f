// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <Eigen/Core>

#include "support/decompositions.h"
#include "support/dense.h"

namespace cgp_test {

/// all eigenvalues of X x = mu M_V x, ascending; each of them four times
inline Eigen::VectorXd dense_eigenvalues(
    const Conformal_geometry_processing::Surface_ref& surface,
    const Conformal_geometry_processing::Curvature_potential& rho)
{
  const Eigen::MatrixXd X = real_form(dense(dirac_energy(surface, rho)));
  const Eigen::VectorXd scale =
      vertex_areas(surface).cwiseSqrt().cwiseInverse().transpose().replicate(4, 1).reshaped(
          X.rows(), 1);
  const Eigen::MatrixXd symmetric = scale.asDiagonal() * X * scale.asDiagonal();
  return symmetric_eigenvalues(symmetric);
}

}  // namespace cgp_test
