// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// \brief u = log |lambda|^2, |V|: the transformation scales lengths by e^u. The gauge adds a
/// constant.
Eigen::VectorXd log_scales(const Quaternion_vector<double>& lambda);

/// \ingroup PkgSpin
/// du = 2 Re(conjugate(lambda) dlambda) / |lambda|^2, |V| x k
Eigen::MatrixXd log_scale_change(const Quaternion_vector<double>& lambda,
                                 const Block<Quaternion<double>>& dlambda);

/// \ingroup PkgSpin
/// the transpose: the gradients q = 2 lambda y / |lambda|^2 of <y, u>, |V| x k
Block<Quaternion<double>> log_scale_gradient(const Quaternion_vector<double>& lambda,
                                             const Eigen::MatrixXd& y);

}  // namespace Conformal_geometry_processing::internal
