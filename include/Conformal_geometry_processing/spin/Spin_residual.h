// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>

#include <Eigen/Core>

#include <vector>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// \brief numbers r(lambda) that `Relaxed_spins` make small, or zero: what is wanted of the
/// transformed surface, in terms of its spins.
///
/// They must not depend on the gauge, a right factor of lambda.
class Spin_residual {
 public:
  using Spins = Quaternion_vector<double>;

  virtual ~Spin_residual() = default;

  /// adopts the spins at which the other functions are evaluated
  virtual void set_spins(const Spins& lambda) = 0;

  virtual Eigen::VectorXd values() const = 0;

  /// dr for a change of lambda
  virtual Eigen::VectorXd change(const Spins& dlambda) const = 0;

  /// the transpose: the gradient q of <y, r>, whose change is Re <q, dlambda>
  virtual Spins gradient(const Eigen::VectorXd& y) const = 0;

  /// \brief |V|, what `gradient()` of `change()` multiplies spins by, about: for preconditioners.
  /// Empty: they leave this residual to the iterations.
  virtual Eigen::VectorXd stiffness() const { return {}; }

  /// \brief whether the values are few, such as periods: preconditioners then take their gradients
  /// one by one.
  virtual bool is_few() const { return false; }
};

using Spin_residuals = std::vector<Spin_residual*>;

/// adopts the spins for all, and returns the values of one after the other
Eigen::VectorXd values_at(const Spin_residual::Spins& lambda, const Spin_residuals& residuals);

/// those with `is_few()`
Spin_residuals few_of(const Spin_residuals& residuals);

/// the gradients of the values with respect to the spins, |V| x number of values
Block<Quaternion<double>> gradients_of(const Spin_residuals& residuals, Eigen::Index vertices);

}  // namespace Conformal_geometry_processing::internal
