// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>
#include <Quaternionic_linear_algebra/dense/block_operators.h>

#include <Eigen/Core>

#include <limits>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

/// \brief gradients of few values: that of <y, values> is V F y, with factors from the right. One
/// column serves several values, and so does one solve with a matrix of quaternions.
struct Spin_columns {
  Block<Quaternion<double>> columns;  ///< V, |V| x m
  Block<Quaternion<double>> factors;  ///< F, m x number of values
};

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

  /// whether the values are few, such as periods: preconditioners then take their `columns()`
  virtual bool is_few() const { return false; }

  /// those of `gradient()`, if the values are few
  virtual Spin_columns columns() const { return {}; }

  /// whether `Relaxed_spins::meet_few()` takes the values off; those of which it does come first
  virtual bool has_to_vanish() const { return is_few(); }

  /// \brief up to how many few values preconditioners do that; more cost products of all with all,
  /// and are left to the iterations where these find them soon.
  virtual Eigen::Index most_one_by_one() const
  {
    return (std::numeric_limits<Eigen::Index>::max)();
  }
};

using Spin_residuals = std::vector<Spin_residual*>;

/// adopts the spins for all, and returns the values of one after the other
Eigen::VectorXd values_at(const Spin_residual::Spins& lambda, const Spin_residuals& residuals);

/// those with `has_to_vanish()`
Spin_residuals vanishing_of(const Spin_residuals& residuals);

/// of all together
Eigen::Index number_of_values(const Spin_residuals& residuals);

/// their `change()`, of one after the other
Eigen::VectorXd change_of(const Spin_residuals& residuals, const Spin_residual::Spins& dlambda);

/// the transpose: the sum of their `gradient()` of the parts of y
Spin_residual::Spins gradient_of(const Spin_residuals& residuals, const Eigen::VectorXd& y);

/// \brief the columns of few values, of one residual after the other: one for each value where
/// spins have real coefficients only.
/// \pre there are residuals, all of them with `is_few()`
Spin_columns columns_of(const Spin_residuals& residuals, Coefficients coefficients);

/// \brief u = log |lambda|^2, |V|: the transformation scales lengths by e^u. The gauge adds a
/// constant.
Eigen::VectorXd log_scales(const Quaternion_vector<double>& lambda);

/// du = 2 Re(conjugate(lambda) dlambda) / |lambda|^2, |V| x k
Eigen::MatrixXd log_scale_change(const Quaternion_vector<double>& lambda,
                                 const Block<Quaternion<double>>& dlambda);

/// the transpose: the gradients q = 2 lambda y / |lambda|^2 of <y, u>, |V| x k
Block<Quaternion<double>> log_scale_gradient(const Quaternion_vector<double>& lambda,
                                             const Eigen::MatrixXd& y);

}  // namespace internal

/// \ingroup PkgSpin
/// \brief the weight alpha^2 of the distance to lambda = 1 for a surface with free boundary, in
/// 1/area: alpha = 10 h / R^2 with the mean edge length h and the area pi R^2.
///
/// If h << alpha R^2 << R, the solution tends to the projection of 1 onto the kernel of D - rho.
double nearness_weight(const Surface_ref& surface, const internal::Surface_part& part = {});

namespace internal {

/// \brief the roots of masses times lambda - 1: with a free boundary, where infinitely many spins
/// solve the equation, those nearest to 1 are wanted (`nearness_weight()`).
class Nearness_residual : public Spin_residual {
 public:
  /// \param masses |V|
  explicit Nearness_residual(Eigen::VectorXd masses) : m_masses(std::move(masses)) {}

  /// multiplies the masses
  void scale(double factor) { m_masses *= factor; }

  void set_spins(const Spins& lambda) override { m_lambda = lambda; }
  Eigen::VectorXd values() const override;
  Eigen::VectorXd change(const Spins& dlambda) const override;
  Spins gradient(const Eigen::VectorXd& y) const override;
  Eigen::VectorXd stiffness() const override { return m_masses; }

 private:
  Eigen::VectorXd m_masses;
  Spins m_lambda;
};

/// \brief the root of w times the areas times the deviation of `log_scales()` from wanted ones.
///
/// The mean of the deviation over the whole surface is free, because the total area is kept. Where
/// weights select a part, the mean over this part is not: it must not grow or shrink as a whole.
class Scale_residual : public Spin_residual {
 public:
  /// \param areas |V|
  /// \param wanted |V|, logs of factors of lengths
  /// \param weights |V|, of the areas, not negative; empty: 1
  /// \param part whose areas these are
  Scale_residual(Eigen::VectorXd areas, Eigen::VectorXd wanted, const Eigen::VectorXd& weights = {},
                 Surface_part part = {});

  /// \param w in 1/area
  void set_weight(double w) { m_weight = w; }

  void set_spins(const Spins& lambda) override;
  Eigen::VectorXd values() const override;
  Eigen::VectorXd change(const Spins& dlambda) const override;
  Spins gradient(const Eigen::VectorXd& y) const override;

  /// 2 w times the areas: u has the derivative 2 / |lambda| in one of four directions, and none in
  /// the others
  Eigen::VectorXd stiffness() const override { return 2 * m_weight * m_masses; }

 private:
  Eigen::VectorXd weighted(Eigen::VectorXd u) const;

  Surface_part m_part;
  Eigen::VectorXd m_areas, m_masses, m_wanted;
  double m_area, m_weight = 1;
  Spins m_lambda;
};

}  // namespace internal
}  // namespace Conformal_geometry_processing
