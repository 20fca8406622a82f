// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/conformal_class/Conformal_class.h>
#include <Conformal_geometry_processing/flow/Step_control.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/spin/Boundary_condition.h>
#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/direct/Supernodal_cholesky.h>

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \brief smooths surfaces within about the conformal class of an initial one: f <- f - (1 - A)^2 f
/// with A = (M + s L_0)^-1 M.
///
/// L_0 is the Laplacian of the *initial* surface, which is that of each conformally equivalent one
/// [Kazhdan, Solomon and Ben-Chen 2012]. (1 - A)^2 takes the high frequencies away, and leaves low
/// ones to second order: a single 1 - A would shrink the surface. M is the geometric mean of the
/// vertex areas of the initial and of the present surface: with those of the present one, even a
/// small s would be a large step wherever it has shrunk by orders of magnitude; with those of the
/// initial one, parts that have grown would hardly move. s is a multiple of the mean of M.
///
/// Vertices at a boundary are held, for a surface would shrink from its boundary; then minimal
/// surfaces stay as they are.
///
/// The ordering is computed once. One factorization of a real matrix on the vertices, and two
/// solves of three columns.
class Fairing {
 public:
  /// \param initial the initial surface
  /// \param is_held |V|, vertices that do not move: those at a boundary, at least
  /// \throw Solver_error if the analysis fails
  Fairing(const Mesh_view& initial, std::vector<char> is_held);

  /// \param mesh a surface of the connectivity of the initial one
  /// \param strength s by the mean of M
  /// \throw Solver_error if the factorization fails
  Points operator()(const Mesh_view& mesh, double strength);

 private:
  /// (1 - A) f, zero where vertices are held
  Block<double> rough_part(const Block<double>& f, double s) const;

  std::vector<char> m_is_held;
  Hermitian_sparse_matrix<double> m_laplacian, m_matrix;
  Eigen::VectorXd m_areas;  // of the vertices, of the initial surface
  Supernodal_cholesky<double> m_solver;
};

/// \brief keeps a flow on the discrete conformal class of its initial surface, and smooths surfaces
/// within it.
///
/// The error of a spin transformation is O(h) of the step; those of many steps add up to a drift
/// away from the class. Area and centroid are those of the initial surface.
///
/// At a boundary, smoothing holds the vertices; where binormals are kept, also the others of the
/// faces there. A snap moves them: with a free boundary without restriction; with tangents,
/// binormals or directions between them, so that these stay along each edge of the boundary
/// (`Rim_directions`). They are those that the surface had before: the transformations of a flow
/// lead them back to the first, or to the prescribed ones.
class Class_keeper {
 public:
  /// what a step depends on beside its surface
  struct State {
    Time_step strength;
    Snap_equations::State snap;
  };

  /// \param initial a copy is kept
  /// \param boundary a condition without positions
  /// \throw Solver_error if an analysis fails
  explicit Class_keeper(const Mesh_view& initial, const Boundary_condition& boundary = {});

  /// sets what surfaces meet beside the class from now on
  void keep(Global_equation equation) { m_class.keep(std::move(equation)); }

  /// \brief moves positions into the class, up to changes of log length cross-ratios of 1e-3, and
  /// of 1e-5 where a few more steps suffice; keeps their directions at the boundary.
  /// \returns whether it is reached
  /// \throw Solver_error if a factorization fails
  bool snap(Points& f);

  /// \brief moves positions, which a snap has reached, to 1e-10, or as near as rounding allows.
  /// \throw Solver_error if a factorization fails
  void polish(Points& f);

  /// \brief a smoother surface of the class that is better; the strength is quartered until it is,
  /// at most twice, and grows for the next calls.
  /// \param is_better whether a surface is to be taken
  /// \throw Solver_error if memory runs out; other failures count as a surface that is not better
  std::optional<Points> smoothed(const Mesh_view& mesh,
                                 const std::function<bool(const Points&)>& is_better);

  State state() const { return {m_strength, m_class.state()}; }
  void set_state(const State& state);

 private:
  /// sets the directions to be kept at the boundary: those of positions in the frame
  void keep_directions(const Points& f);
  /// a snap that keeps the directions set last
  bool snap_to_kept(Points& f, bool only_near);
  void take(Points moved, Points& f) const;
  bool try_smoothing(const Mesh_view& mesh, bool only_near,
                     const std::function<bool(const Points&)>& is_better, Points& f);

  double m_unit;        // of a frame, so that logarithms of lengths do not depend on the scale
  Mesh_view m_initial;  // in the frame, as the class
  Boundary_condition m_boundary;
  Conformal_class m_class;
  Fairing m_fairing;
  Time_step m_strength;  // of the next smoothing
};

}  // namespace Conformal_geometry_processing::internal
