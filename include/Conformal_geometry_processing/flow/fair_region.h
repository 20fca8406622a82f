// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/conformal_class/Class_equations.h>
#include <Conformal_geometry_processing/flow/Fairing_patch.h>
#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/direct/Dirichlet_solver.h>
#include <Quaternionic_linear_algebra/direct/Supernodal_cholesky.h>

#include <Eigen/Core>

#include <functional>
#include <string>
#include <vector>

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

/// Options of `conformal_fairing()`
struct Fairing_options {
  bool exact_conformal_class = true;  ///< whether the region stays in its conformal class
  int max_steps = 100;
  double tolerance = 1e-5;  ///< of the way of a vertex in a step, by the diagonal of the region
};

/// \brief The numbers that verify `conformal_fairing()`.
struct [[nodiscard]] Fairing_report {
  bool converged = false;  ///< no step moves a vertex by more than the tolerance
  std::string message;     ///< why not
  int steps = 0;           ///< taken
  int free_vertices = 0;   ///< of the region; the others are held

  /// the Willmore energy of the region and its rim, the integral of H^2
  double initial_energy = 0, energy = 0;
  Normal_jump initial_normal_jump, normal_jump;  ///< at the rim
  Conformality conformality;  ///< of the map from the old faces that move to the new ones

  /// whether the surface is as smooth as possible; if not, it is the last one, smoother than before
  explicit operator bool() const { return converged; }
};

struct Fairing_result {
  Points positions;  ///< of all vertices of the mesh; held ones are bitwise what they were
  Fairing_report report;
};

/// \brief Replaces a region of a surface by the smoothest one with the same rim and normals there,
/// see `conformal_fairing()`.
///
/// Starts at the region itself, or, if the class is not kept, where `Outline_fairing` does.
/// \param is_in_region one entry for each face
/// \param go_further is asked before every step; false ends the fairing with the last surface
/// \throw Precondition_error if the mesh is not a manifold with finite positions, or as
/// `Fairing_patch`
/// \throw Solver_error if memory does not suffice; another failure ends the fairing with the last
/// surface, see `Fairing_report::message`
Fairing_result fair_region(const Mesh_view& mesh, const std::vector<char>& is_in_region,
                           const Fairing_options& options, const std::string& function,
                           const std::function<bool()>& go_further);

}  // namespace Conformal_geometry_processing::internal
