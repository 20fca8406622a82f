// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_CALCULUS_FUNDAMENTAL_FORMS_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_CALCULUS_FUNDAMENTAL_FORMS_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/operators/calculus/fundamental_forms.h>
#include <Conformal_geometry_processing/operators/calculus/shape_operator.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

CGP_INLINE Eigen::VectorXd first_fundamental_form(const Points& X, const Points& Y)
{
  return X.cwiseProduct(Y).colwise().sum().transpose();
}

CGP_INLINE Eigen::VectorXd second_fundamental_form(const internal::Surface_derivative& d,
                                                   const Points& X, const Points& Y)
{
  return first_fundamental_form(shape_operator(d, X), Y);
}

}  // namespace Conformal_geometry_processing

#endif
