// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Conformal_geometry_processing/spin/Placement_derivative.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// \brief the derivative of the positions of a transformed surface with respect to the spins
/// lambda, and its transpose; all in the frame of the system.
///
/// Includes what `Spin_transformation` does to lambda and to the positions: `fix_gauge()` keeps the
/// mean of lambda real, `restore_area()` keeps area and centroid. A change of lambda by a right
/// factor therefore has no effect. Each product costs a solve with the Laplacian, three columns.
class Position_derivative {
 public:
  /// \param system and reconstruction of the surface; must outlive the object, as the mesh
  /// \param measured the faces on which `restore_area()` measures
  /// \param lambda spins of the result, after `restore_area()`, |V|
  /// \param f its positions, 3 x |V|
  Position_derivative(const Dirac_system& system, const Poisson_reconstruction& reconstruction,
                      const Mesh_view& measured, Quaternion_vector<double> lambda, Points f);

  /// df, 3 x |V|
  Points apply(Quaternion_vector<double> dlambda) const;

  /// the gradient q of a function of the positions whose gradient is y, 3 x |V|: its change is
  /// Re <q, dlambda>
  Quaternion_vector<double> apply_transpose(const Points& y) const;

 private:
  const Dirac_system& m_system;
  const Poisson_reconstruction& m_reconstruction;
  Quaternion_vector<double> m_lambda;
  double m_mean = 0;  // of lambda, integrated; 0 if the gauge is not fixed
  Placement_derivative m_placement;
};

}  // namespace Conformal_geometry_processing::internal
