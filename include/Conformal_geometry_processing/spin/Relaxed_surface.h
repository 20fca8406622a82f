// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/spin/Dirac_solution.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Conformal_geometry_processing/spin/Period_residual.h>
#include <Conformal_geometry_processing/spin/Relaxed_scales.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>
#include <Quaternionic_linear_algebra/krylov/Eigensolver_result.h>

#include <Eigen/Core>

#include <functional>
#include <optional>

namespace Conformal_geometry_processing::internal {

/// where a search begins
struct Closing_start {
  Quaternion_vector<double> lambda = {};  ///< empty: at the guide
  bool is_ambiguous = false;              ///< another one closes up nearly as well

  bool is_guided() const { return lambda.size() == 0; }

  /// Vectors of the kernel solve the equation: the first step closes them to first order, the
  /// second takes off what is left. Further ones go along the kernel to where the misfit of the
  /// discretisation is least, which is not where the solution is.
  static Relaxed_scales_options few_steps()
  {
    Relaxed_scales_options options;
    options.max_steps = 2;
    return options;
  }
};

/// a search for spins whose surface keeps to a bound on lengths, and closes around handles and
/// holes
class Relaxed_surface {
 public:
  /// the surface of spins, with its report; without positions if they were cancelled
  using Surface_of = std::function<Spin_result(Dirac_solution)>;

  /// \brief with what closes handles and holes.
  /// \param rho wanted, |V|, in the unit of the surface
  Relaxed_surface(Spin_transformation& transformation, const Eigen::VectorXd& rho,
                  const Scale_control& control, const Relaxed_scales_options& options);

  /// without
  Relaxed_surface(Dirac_system& system, const Eigen::VectorXd& rho, const Scale_control& control,
                  const Relaxed_scales_options& options = {});

  /// what iterations may leave of the sum of the terms; open surfaces are softer
  static double negligible(const Dirac_system& system, const Scale_control& control);

  /// \brief searches, with larger weights of the misfit and of periods and then for less of rho,
  /// until the edges close up and the map is conformal, as far as that helps.
  /// \param rho that of the constructor
  Spin_result surface(const Closing_start& start, const Eigen::VectorXd& rho,
                      const Surface_of& surface_of, const Go_further& go_further);

  Relaxed_scales& scales() { return m_scales; }
  const Relaxed_scales& scales() const { return m_scales; }

  /// where a search for all of rho is between two steps, see `Relaxed_scales::Position`
  struct Position {
    Relaxed_scales::Position scales;
    int tries = 0;  ///< with larger weights of the misfit, of which the last one is under way
    double stiffness = 1, shear = 0;  ///< these weights, and the shear before the last try
  };

  /// none where less than rho is asked for
  std::optional<Position> position() const;

  /// \brief ends as `surface()` of another object would have that was there.
  /// \pre there is nothing to close
  Spin_result resumed(const Position& position, const Eigen::VectorXd& rho,
                      const Surface_of& surface_of, const Go_further& go_further);

  /// goes on from spins that solve the equation of rho
  void begin_at(const Quaternion_vector<double>& lambda, const Eigen::VectorXd& rho,
                const Go_further& go_further);

  /// takes off what a finite weight has left of the periods
  void close();

  /// likewise; where that takes lengths beyond their bound, goes on with room for it
  void close_within_bound(const Go_further& go_further);

  /// the factors of lengths, and what is kept of rho
  Spin_report::Scales kept(const Eigen::VectorXd& rho) const;

 private:
  Spin_residuals closing(Spin_transformation& transformation);
  double shear(const Spin_report& report) const;
  Spin_result finished(bool is_guided, const Eigen::VectorXd& rho, const Surface_of& surface_of,
                       const Go_further& go_further);
  bool is_in_vain(const Spin_result& result) const;
  void close_up(const Surface_of& surface_of, const Go_further& go_further, Spin_result& result);
  void ask_for_less(const Eigen::VectorXd& rho, const Surface_of& surface_of,
                    const Go_further& go_further, Spin_result& result);

  Dirac_system& m_system;
  bool m_is_bounded, m_asks_for_less = false;
  int m_tries = 0;  // see `Position`
  double m_stiffness = 1, m_shear_before = 0;
  std::optional<Period_residual> m_periods;
  Relaxed_scales m_scales;
};

}  // namespace Conformal_geometry_processing::internal
