// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/forms/exactness_functions.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/spin/Boundary_condition.h>
#include <Conformal_geometry_processing/spin/Exactness_constraints.h>
#include <Conformal_geometry_processing/spin/Framed_surface.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Conformal_geometry_processing/spin/Scale_control.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Conformal_geometry_processing/spin/solve_dirac_equation.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>
#include <Quaternionic_linear_algebra/direct/Stopwatch.h>
#include <Quaternionic_linear_algebra/krylov/Visit_guard.h>

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// the transformed surface with its report
struct Spin_result {
  Points positions;                  ///< 3 x |V|
  Quaternion_vector<double> lambda;  ///< |V|; df~ = conjugate(lambda) df lambda
  Spin_report report;
};

/// \ingroup PkgSpin
/// what is requested of a `Spin_transformation`, but for rho, in the unit of the mesh
struct Spin_transformation_options {
  Boundary_condition boundary = {};  ///< for surfaces with boundary; the default is a free one
  /// how the edges are kept exact around handles and holes, see `exactness_constraints()`; if
  /// empty, the surface is sheared where they do not close up
  std::optional<Exactness> exactness = Exactness::adjoint;
  /// admits faces of any thinness, also of area zero: solves the equation on the intrinsic Delaunay
  /// triangulation, and adds to all edges the length that thin faces lack to form triangles, at
  /// most this share of the mean length, 0 < share < 1; 1e-6 is a good value
  std::optional<double> mollification = std::nullopt;
  /// the largest part of the edges, all steps together, that may fail to close up around handles
  /// and holes; none: a quarter of the discretisation error, which falls with the edge length, see
  /// `internal::Period_limit`
  std::optional<double> max_period_defect = std::nullopt;
  /// with a bound on the change of lengths, rho is replaced by the nearest one that keeps to it
  internal::Scale_control scales = {};
  /// whether `transform()` ends with the nearest surface whose length cross-ratios are those of the
  /// mesh, up to rounding; with mollification, of its intrinsic Delaunay triangulation. Cannot be
  /// combined with prescribed positions. See `internal::move_to_class()`
  bool exact_conformal_class = false;
  Dirac_options dirac = {};         ///< how the eigenvector is found, where there is one
  Spin_report::Limits limits = {};  ///< what counts as success; with a bound on lengths, less of
                                    ///< rho is applied where the result would be beyond them
  Spin_solvers solvers = {};        ///< for the linear systems
};

namespace internal {

/// \brief the bound on lengths where the caller gives none: `default_scale_bound`, or
/// `default_bound_of_wanted_scales` if there are wanted factors; no bound where the boundary has
/// prescribed positions or directions, which fix scales.
inline std::optional<double> default_bound(const Spin_transformation_options& options)
{
  if (options.boundary.targets.cols() > 0) return std::nullopt;
  return options.scales.factors.size() > 0 ? default_bound_of_wanted_scales : default_scale_bound;
}

class Relaxed_scales;
class Relaxed_surface;
struct Closing_start;
}  // namespace internal

/// \ingroup PkgSpin
/// \brief computes spin transformations of a surface: finds the conformally equivalent surface
/// whose mean curvature differs by a prescribed rho, with optional boundary conditions [CGP
/// (5.3)-(5.5), 5.7].
///
/// H~ |lambda|^2 = H + rho + gamma, so positive rho bulges along the normals. The result has the
/// area and the centroid of the mesh, unless positions are prescribed. Computations that depend
/// only on the mesh are done once: checks, ordering and symbolic analysis in the constructor, the
/// factorization of the Laplacian on first use.
///
/// Without a bound on lengths, on surfaces without handles or holes, lambda is an eigenvector. Each
/// call of `transform()` costs one solve with the Laplacian, and numeric factorizations of the
/// Dirac matrix and solves with it: on smooth spheres one and about six, on most scans one to three
/// and up to 30, on meshes with long thin limbs ten and more than 100. The report counts them
/// (`factorizations`, `solves`).
///
/// With a bound (`Spin_transformation_options::scales`), or where edges have to close up around
/// handles or holes, spins and rho are the unknowns of one least-squares problem, see
/// `internal::Relaxed_spins`: rho' is as near to rho as the bound, the loops and the mesh allow,
/// and no eigenvector is computed. That costs one to five factorizations and 30 to 150 solves, and
/// for each loop three more in each step. The report tells what was kept (`Spin_report::scales`)
/// or, with loops, left out (`missing_share`); with prescribed directions that turn the boundary
/// around holes, what was added to rho to close the surface (`added_share`). Several surfaces may
/// have these directions: the one that closes by the least change is taken, or none
/// (`Boundary_fault::ambiguous`). That costs another factorization and about 60 solves.
///
/// With mollification, triangles may be needles, caps, or of area zero. Area, centroid and
/// certificate then refer to the `well_shaped_faces()`, which exclude the thinnest faces, at most 5
/// % of the area.
///
/// On request the result is moved to the exact discrete conformal class of the mesh
/// (`Spin_transformation_options::exact_conformal_class`), from which the discretisation error
/// takes it.
///
/// Computes in a frame of unit size around the centre, so that scale and position have no effect.
///
class Spin_transformation {
 public:
  /// \param mesh is copied
  /// \param function named in exceptions
  /// \throw Precondition_error if the mesh is not a connected, oriented manifold with finite
  /// coordinates and, without mollification, positive areas; if the boundary condition does not fit
  /// it, see `require_condition()`; if mollification is out of its range. The message names the
  /// first offending element
  /// \throw Solver_error if the analysis fails
  explicit Spin_transformation(const Mesh_view& mesh,
                               const Spin_transformation_options& options = {},
                               const std::string& function = "Spin_transformation");

  Spin_transformation(const Spin_transformation&) = delete;
  Spin_transformation& operator=(const Spin_transformation&) = delete;

  /// \brief moves the mesh, as in the steps of a flow; `transform()` starts from the new positions.
  ///
  /// Ordering and symbolic analysis are kept. With mollification, the triangulation and its pattern
  /// change, and the call costs as much as the constructor.
  /// \param positions 3 x |V|
  /// \throw Precondition_error if their number is wrong, one is not finite or a face (with
  /// mollification: every face) has area zero, or the boundary has prescribed positions; the object
  /// is then unchanged
  void set_positions(const Points& positions);

  /// the positions of the mesh, 3 x |V|
  const Points& positions() const { return m_stage->domain.positions(); }

  /// the surface, in the frame of the computation
  const internal::Framed_surface& domain() const { return m_stage->domain; }

  /// the Dirac operator of the surface, in the frame of the computation
  const internal::Dirac_system& system() const { return m_stage->system; }
  internal::Dirac_system& system() { return m_stage->system; }

  /// \brief finds positions from edge vectors, in the frame of the computation.
  /// \throw Solver_error if the Laplacian cannot be factored
  const Poisson_reconstruction& reconstruction();

  /// \brief the constraints that keep the surface exact, in the frame; computed on first use.
  /// \throw Solver_error if a factorization fails, or a solve
  const internal::Exactness_constraints& exactness(Curvature_potential::On on);

  /// what tells whether loops close, computed on first use; null where they need not
  const internal::Exactness_constraints* closing();

  /// \brief the costs of `exactness()` that no report contains yet; from now on they count as
  /// reported.
  Spin_report take_unreported() { return std::exchange(m_unreported, {}); }

  /// the limits and the eigenvector of what is computed from now on, see
  /// `Spin_transformation_options`
  Spin_report::Limits& limits() { return m_options.limits; }
  Dirac_options& dirac() { return m_options.dirac; }

  /// \throw Precondition_error if rho has the wrong length or a value that is not finite
  void require_potential(const Curvature_potential& rho) const;

  /// \brief computes the surface whose mean curvature is changed by rho. The object is unchanged.
  ///
  /// If it was cancelled, there are no positions.
  /// \param rho in 1/length of the mesh, one number per vertex or per face
  /// \param go_further called between iterations with an `Eigensolver_progress`; cancels by
  /// returning false
  /// \throw Precondition_error if rho has the wrong length or a value that is not finite, or
  /// `go_further` calls back one of the functions that compute
  /// \throw Solver_error if a factorization fails. Failure to converge is a field of the report.
  Spin_result transform(const Curvature_potential& rho,
                        const internal::Go_further& go_further = internal::Always_go_further()) &;

  /// the last transformation by this object: needs less memory, because the factor of the Laplacian
  /// does not exist together with that by which the result is judged
  Spin_result transform(const Curvature_potential& rho,
                        const internal::Go_further& go_further = internal::Always_go_further()) &&;

  /// \brief approximates `transform()` for a rho that changes little from call to call, as under a
  /// brush: where lengths are bounded or loops have to close, by a few steps from the spins of the
  /// last call.
  /// \param continues false: from the beginning, with some steps more
  /// \throw as `transform()`
  Spin_result preview(const Curvature_potential& rho, bool continues);

  /// \brief a single transformation by the given rho, whether the edges stay exact or not.
  /// \throw as `transform()`
  Spin_result step(const Curvature_potential& rho,
                   const internal::Go_further& go_further = internal::Always_go_further());

  /// \brief `step()` without `Spin_report::realised_curvature`, for searches that try several.
  Spin_result trial_step(const Curvature_potential& rho,
                         const internal::Go_further& go_further = internal::Always_go_further());

  /// \brief `trial_step()`, closed around handles and holes by `internal::closed_spins()`, for the
  /// small steps of a flow: nearly closed already, as rho is the exact part of `exactness()`.
  ///
  /// The report has the period defect, and tells how the equation of the changed rho is solved.
  /// \param rho in 1/length of the mesh, one number per vertex
  /// \throw as `transform()`
  Spin_result closed_step(const Eigen::VectorXd& rho,
                          const internal::Go_further& go_further = internal::Always_go_further());

  /// \brief computes the surface with given spins, whether they solve a Dirac equation or not.
  ///
  /// `report.closure_residual` measures how far they are from the spins of a surface; `converged`
  /// tells whether all numbers are finite.
  /// \param lambda |V|
  /// \throw Precondition_error if their number is wrong
  /// \throw Solver_error if the Laplacian cannot be factored
  Spin_result integrate(Quaternion_vector<double> lambda);

  /// \brief the surface of relaxed spins in the frame, with its report; without positions if they
  /// were cancelled.
  /// \param place if given, moves the surface before it is judged
  Spin_result surface_of(internal::Dirac_solution found,
                         const std::function<void(Spin_result&)>& place = {});

 private:
  /// everything that depends on the positions
  struct Stage {
    Stage(const Mesh_view& mesh, const Spin_transformation& of);

    internal::Stopwatch watch;  // started before all other members
    internal::Framed_surface domain;
    internal::Dirac_system system;
    std::optional<Poisson_reconstruction> poisson;
    bool is_poisson_old = false;  // the surface has moved since the Laplacian was assembled
    std::optional<internal::Exactness_constraints> exactness, closing;
    std::optional<internal::Harmonic_part> forms;  // of the first positions: a start for others
    std::optional<internal::Solver_ref<double>> smoother;  // of the curvature that is judged
    std::shared_ptr<internal::Relaxed_surface> preview;
    double seconds;
  };

  void require_size(Eigen::Index size, const std::string& what) const;

  /// whether there are loops around handles or holes, which have to close
  bool has_loops() const
  {
    return domain().has_loops() && m_options.boundary.kind != Boundary_condition::Kind::positions;
  }

  /// whether the boundary has directions that need not be those of the surface
  bool turns_directions() const
  {
    return system().directions() && m_options.boundary.targets.cols() > 0;
  }

  /// \brief moves a transformed surface to its exact conformal class; where that takes lengths
  /// beyond their bound, that of one transformed with a tighter bound.
  Spin_result on_class(Spin_result result, const Curvature_potential& rho,
                       const internal::Go_further& go_further);
  void move_to_class(Spin_result& result);

  /// whether lengths are bounded or loops have to close, which no eigenvector need do
  bool is_relaxed() const { return m_options.scales.bound || (m_options.exactness && has_loops()); }

  /// \brief the surface of `internal::Relaxed_scales` with a given control, whose handles and holes
  /// are closed by a `internal::Period_residual`; of less of rho, where the mesh is too coarse for
  /// all of it.
  /// \param stiffness factor of the weights of the misfit
  /// \pre no positions are prescribed
  Spin_result relaxed(const Curvature_potential& rho, const internal::Scale_control& control,
                      double stiffness, const internal::Go_further& go_further);

  /// see `internal::Directions_selection::kernel()`; rho in the frame
  Block<Quaternion<double>> kernel(const Curvature_potential& rho,
                                   const internal::Go_further& go_further);

  /// \brief where the search for spins with prescribed directions begins that close up around
  /// holes: at the vector of the kernel with which they do by the least change of rho.
  /// \param rho wanted, |V|, in the frame
  internal::Closing_start closing_start(const Eigen::VectorXd& rho,
                                        const internal::Go_further& go_further);

  /// closes what a step by rho has left open
  void close(const Eigen::VectorXd& rho, double limit, Spin_result& result);

  /// tells how far the edges are from closing up
  void judge_periods(const internal::Exactness_constraints& closing, Spin_result& result) const;

  /// the largest defect of a surface that counts as closed
  double period_limit(const Spin_report& report) const;

  /// tells how the equation of rho is solved, |V|, in the frame
  void judge_equation(Eigen::VectorXd rho, Spin_result& result) const;

  /// tells what is kept of rho, or added to it, the constant included
  void tell_shares(const internal::Relaxed_surface& found, const Eigen::VectorXd& wanted,
                   const internal::Scale_control& control, Spin_report& report);

  /// rho at vertices, in the frame
  Eigen::VectorXd in_frame(const Curvature_potential& rho) const;

  /// a solution in the frame, with its part of the report in the unit of the mesh
  Spin_result in_units(internal::Dirac_solution s) const;

  /// lambda, with its part of the report
  Spin_result solve(const Curvature_potential& rho, const internal::Go_further& go_further);

  /// Computes positions from lambda, with the area and the centroid of the mesh, and the
  /// certificate.
  /// \param place as of `surface_of()`
  void reconstruct(Spin_result& result, const std::function<void(Spin_result&)>& place = {});
  void judge_boundary(const Points& f, Spin_report& report) const;

  /// the result, with the curvature that it has realised of rho
  /// \pre the surface is the one that was transformed
  Spin_result judged(Spin_result result, const Curvature_potential& rho) const;

  std::string m_function;
  internal::Visit_guard m_visits;
  Spin_transformation_options m_options;
  std::unique_ptr<Stage> m_stage;
  bool m_is_last = false;    // no call follows
  Spin_report m_unreported;  // costs of `exactness()`
};

}  // namespace Conformal_geometry_processing
