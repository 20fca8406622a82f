// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/conformal_class/Class_equations.h>
#include <Conformal_geometry_processing/flow/Bending_energy.h>
#include <Conformal_geometry_processing/flow/Fairing_patch.h>
#include <Quaternionic_linear_algebra/direct/Supernodal_cholesky.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing::internal {

/// \brief Descends the Willmore energy of a patch with clamped rim within the discrete conformal
/// class of the initial patch: with its length cross-ratios, by sequential quadratic programming.
///
/// The class is that of all surfaces with edge lengths l_ij exp((u_i + u_j) / 2); u is zero at the
/// rim, whose lengths are kept. A step minimizes <grad W, d> + <d, K d> / 2 subject to the
/// linearized constraints J (d, du) = 0, as the limit of a large weight on them, and then returns
/// to the class by steps of least <d, K d>. The fixed points are constrained Willmore surfaces.
///
/// A step is one factorization of the `Class_form` of the free vertices, on the pattern of K.
class Class_fairing {
 public:
  /// \param patch must outlive it
  /// \throw Solver_error if the analysis fails
  explicit Class_fairing(const Fairing_patch& patch);

  /// \brief the next surface of the class, of less energy.
  /// \throw Solver_error if the factorization fails
  Fairing_step step(const Bending_energy& present);

  /// \brief moves the surface of the last step to the class up to rounding, or as near as possible.
  /// \throw Solver_error if the factorization fails
  void polish(Points& f);

 private:
  /// positions, log scales of the free vertices, and how far edges are from the class
  struct State {
    Points f;
    Eigen::VectorXd u, residuals;
  };

  void factorize(const Bending_energy& energy);
  State state_at(Points f, Eigen::VectorXd u) const;
  /// the state moved by A^-1 (-g, 0) - A^-1 w J^T c
  State advanced(const State& state, const Points& g) const;
  /// whether the class is reached
  bool return_to_class(State& state) const;

  const Fairing_patch& m_patch;
  Bending_matrix m_bending;
  Class_form m_form;
  Supernodal_cholesky<double> m_solver;
  double m_length = 1;       // of the last step, by the full one
  Eigen::VectorXd m_scales;  // u of the present surface
};

}  // namespace Conformal_geometry_processing::internal
