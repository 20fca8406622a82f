// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/conformal_class/Snap_equations.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

#include <algorithm>
#include <optional>
#include <utility>

namespace Conformal_geometry_processing::internal {

/// When a snap ends
struct Snap_options {
  /// of the largest residual; a change of log length cross-ratios sums four of them
  double tolerance = 2.5e-11;
  int max_iterations = 40;
  /// whether to begin with the factor of the last snap, which suffices near its surface; the result
  /// then depends on the calls before
  bool keep_factor = false;
  /// a residual that is enough; from there, few iterations more are made towards the tolerance
  double sufficient = 0;
  /// whether to give up where the first step with a new factor leaves a large part of the
  /// residuals: the way is long then, and leads to a surface that has little to do with this one
  bool only_near = false;

  double enough() const { return (std::max)(tolerance, sufficient); }
};

/// a surface, its log scales, and the residuals of both
struct Snap_state {
  Points f;
  Eigen::VectorXd u, residuals;
};

/// \brief The last steps with one factor: what of the residuals their changes explain need not be
/// solved for [Anderson 1965].
///
/// A factor of a surface nearby leaves a part of the residuals in each step, nearly the same linear
/// one; the combination of the steps that would have left least of them leaves its square, or less.
class Snap_history {
 public:
  void forget();

  /// adds the change from one state to the next; forgets the oldest of more than five
  void add(const Snap_state& from, const Snap_state& to);

  /// \brief the state, changed by the combination of the steps that leaves least of the residuals;
  /// these are what that leaves to first order.
  Snap_state extrapolated(Snap_state state) const;

 private:
  Eigen::MatrixXd m_changes, m_changes_of_residuals;  // one column for each step: f and u
};

/// The numbers that verify a snap
struct Snap_report {
  bool converged = false;                     ///< `residual` is within the tolerance, or enough
  double initial_residual = 0, residual = 0;  ///< the largest, absolute
  int iterations = 0, factorizations = 0;
};

/// \brief The discrete conformal class of a mesh: all surfaces of its connectivity whose edge
/// lengths differ from its own by factors at the vertices, that is, which have its length
/// cross-ratios [Luo 2004; Springborn, Schroeder and Pinkall 2008]. Moebius transformations keep
/// it.
///
/// Any genus, with or without boundary, in one component or more.
class Conformal_class {
 public:
  /// \pre no edge of the mesh has length zero
  /// \throw Solver_error if the analysis fails
  explicit Conformal_class(const Mesh_view& mesh);

  /// sets the directions at the boundary that snaps keep beside the class; at first there are none
  void keep(Rim_directions rim);

  /// sets the equation that snaps meet beside the class; at first there is none
  void keep(Global_equation equation);

  /// \brief Moves a surface into the class by Gauss-Newton steps of least change, see
  /// `Snap_equations`; a step that does not lower the residuals is halved.
  ///
  /// A factor is used as long as the residuals fall so fast that it leads there in no more steps
  /// than a new one costs; near the class that is to the end. What the steps with it have changed
  /// accelerates the next ones, see `Snap_history`. Where rounding of the positions alone makes
  /// residuals as large as these, no other is made: edges may be shorter than the surface by so
  /// much that the class cannot be reached any better. Commutes with motions and scalings of f.
  /// Each factorization costs about twice that of the complex Dirac matrix.
  /// \param f 3 x |V|; unchanged where the residual is within the tolerance from the start. Without
  /// convergence, the nearest surface found
  /// \throw Solver_error if a factorization fails, or an edge of f has length zero
  Snap_report snap(Points& f, const Snap_options& options = {});

  /// what the next snap depends on beside its surface
  const Snap_equations::State& state() const { return m_equations.state(); }
  void set_state(Snap_equations::State state) { m_equations.set_state(std::move(state)); }

 private:
  struct State : Snap_state {
    bool has_factor = false;  ///< the last factor is to be used again
    Snap_history history;     ///< of its steps
  };

  /// \brief Makes a new factor.
  /// \returns false if that fails and is not needed
  bool factorize(const Points& f, bool is_needed);

  /// \brief Takes a step with the last factor, of which at most `halvings` halves are tried.
  /// \returns whether the norm of the residuals fell below the multiple `factor` of itself; the
  /// state is unchanged otherwise
  bool advance(State& state, double factor, int halvings) const;

  /// what a step may leave of the residuals if a factor is to be used again
  static double most_left(double residual, const Snap_options& options, int left);

  /// \brief One iteration of `snap()`, of those that are left: a step with the last factor, or a
  /// new one.
  /// \returns false where no further one is of use
  bool iterate(State& state, const Snap_options& options, int left, Snap_report& report);

  /// of the edges, of the rim, and of the global equation
  Eigen::VectorXd residuals(const Points& f, const Eigen::VectorXd& u) const;

  Rim_directions m_rim;
  std::optional<Global_equation> m_global;
  Snap_equations m_equations;
};

}  // namespace Conformal_geometry_processing::internal
