// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/flow/Bending_energy.h>
#include <Conformal_geometry_processing/flow/Fairing_patch.h>
#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/direct/Dirichlet_solver.h>
#include <Quaternionic_linear_algebra/direct/Supernodal_cholesky.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing::internal {

/// \brief Descends the Willmore energy of a patch with clamped rim among all surfaces of its
/// connectivity.
///
/// A step moves the free vertices along their normals by phi = -K^-1 <N, grad W> with the
/// `Bending_matrix` K of the present surface: the fixed points are the discrete Willmore surfaces.
/// Along the surface, where W hardly depends on the vertices, they follow the harmonic map of the
/// first surface to the present one, so triangles keep about their angles.
///
/// A step is one factorization of a real matrix on the free vertices, or a few where the harmonic
/// map raises W and is taken in part.
class Outline_fairing {
 public:
  /// \brief Chooses the first surface: the one of least energy of three, the patch itself and the
  /// solutions of K f = 0 with K of the patch, and with K of the harmonic surface with unit
  /// weights, which does not know what the region was filled with. K is updated once.
  /// \param patch must outlive it
  /// \throw Solver_error if the analysis fails
  explicit Outline_fairing(const Fairing_patch& patch);

  /// the first surface
  const Points& start() const { return m_start; }

  /// \brief the next surface, of less energy.
  /// \throw Solver_error if a factorization fails
  Fairing_step step(const Bending_energy& present);

 private:
  void assemble(const Bending_energy& energy);
  /// f, if it has less energy than the start
  void offer(const Points& f);
  Points harmonic_with_unit_weights() const;
  Points biharmonic(const Bending_energy& energy);
  /// the way of the free vertices to the harmonic map of the start, along the surface
  Points relaxation(const Bending_energy& energy) const;
  /// the way along the normals, with the factor for the surface
  Points descent(const Bending_energy& energy) const;
  Fairing_step descend_from(const Points& relaxed, const Bending_energy& present, int halvings);

  const Fairing_patch& m_patch;
  Bending_matrix m_bending;
  Points m_start;
  Hermitian_sparse_matrix<double> m_matrix, m_laplacian;  // K; L of the start
  Supernodal_cholesky<double> m_solver;
  Dirichlet_solver<double> m_harmonic;
  double m_share = 1;  // of the relaxation, in the last step
};

}  // namespace Conformal_geometry_processing::internal
