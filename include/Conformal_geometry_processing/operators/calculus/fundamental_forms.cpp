// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/calculus/fundamental_forms.h>

#include <Conformal_geometry_processing/operators/calculus/shape_operator.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

Eigen::VectorXd first_fundamental_form(const Points& X, const Points& Y)
{
  return X.cwiseProduct(Y).colwise().sum().transpose();
}

Eigen::VectorXd second_fundamental_form(const internal::Surface_derivative& d, const Points& X,
                                        const Points& Y)
{
  return first_fundamental_form(shape_operator(d, X), Y);
}

}  // namespace Conformal_geometry_processing
