// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/conformal_class/Snap_equations.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/spin/Exactness_constraints.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <Eigen/Core>

#include <string>

namespace Conformal_geometry_processing::internal {

/// \brief prescribes the `Enclosure::reduced_volume()` of a flow: surfaces of the least energy are
/// then the shapes of vesicles [Helfrich 1973; Seifert, Berndl and Lipowsky 1991].
///
/// Along the direction of the flow the volume does not change to first order; the way back to the
/// class meets it. Where the surface does not have it yet, each step goes a part of the way.
class Volume_constraint {
 public:
  /// \param faces on which the volume is measured, those of the input
  /// \param reduced_volume in (0, 1]
  /// \throw Precondition_error if the surface is not closed, or its volume not positive
  Volume_constraint(const Mesh_view& faces, double reduced_volume, const std::string& function);

  /// the logarithm of the prescribed volume by that of a surface
  double distance(const Points& f) const;

  /// \brief the change of the logarithm of the volume that a step is to make: all of the distance,
  /// but at most a twentieth times `time`.
  /// \param time tau by the largest one
  double change(const Points& f, double time) const;

  /// what a surface has to meet after such a change, in any unit
  Global_equation equation(const Points& f, double change) const;

  /// directions of rho on a surface, |V|, in 1/length of the frame, and what they have cost
  struct Directions {
    Eigen::VectorXd kept;     ///< the descent along which the volume stays
    Eigen::VectorXd filling;  ///< changes the logarithm of the volume by 1
    int factorizations = 0, solves = 0;
  };

  /// \brief the steepest descents in the metric |rho|^2 + w |Y|^2 of the spins 1 + Y of rho.
  ///
  /// The Willmore energy is a square of rho, but the volume depends on Y: where the Dirac operator
  /// has small eigenvalues, as on bodies with two lobes, a small rho moves much, and without w its
  /// steps would have to be as small.
  /// \param transformation of the surface; its factor is overwritten
  /// \param others the other constraints; they contain the constants
  /// \param descent of the energy for |rho|^2
  /// \throw Solver_error if the factorization fails, or a solve
  Directions directions(Spin_transformation& transformation, const Constraint_basis& others,
                        const Eigen::VectorXd& descent) const;

  /// \brief the gradient z of the logarithm of the volume: sum_i A_i rho_i z_i is its change by a
  /// small rho. |V|
  /// \pre the transformation has the factor of its matrix for rho = 0
  Eigen::VectorXd gradient(Spin_transformation& transformation, int& solves) const;

 private:
  double log_volume(const Points& f) const;

  Mesh_view m_faces;
  double m_log_volume;  // prescribed
};

}  // namespace Conformal_geometry_processing::internal
