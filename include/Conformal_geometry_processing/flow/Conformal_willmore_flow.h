// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/flow/Class_keeper.h>
#include <Conformal_geometry_processing/flow/Constrained_direction.h>
#include <Conformal_geometry_processing/flow/Curvature_filter.h>
#include <Conformal_geometry_processing/flow/Flow_options.h>
#include <Conformal_geometry_processing/flow/Flow_report.h>
#include <Conformal_geometry_processing/flow/Moebius_balancing.h>
#include <Conformal_geometry_processing/flow/Refusal.h>
#include <Conformal_geometry_processing/flow/Scale_bound.h>
#include <Conformal_geometry_processing/flow/Step_control.h>
#include <Conformal_geometry_processing/flow/Volume_constraint.h>
#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Quaternionic_linear_algebra/direct/Stopwatch.h>
#include <Quaternionic_linear_algebra/exceptions.h>
#include <Quaternionic_linear_algebra/krylov/Eigensolver_result.h>
#include <Quaternionic_linear_algebra/krylov/Visit_guard.h>
#include <Quaternionic_linear_algebra/threads/Thread_team.h>

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <string>

namespace Conformal_geometry_processing {
/// \ingroup PkgFlow
/// \brief why a step of a flow must be rejected whatever its energy; empty if it may be accepted.
///
/// \param report of the spin transformation of the step
/// \param is_turning whether the boundary has not yet reached the prescribed directions. Tangents
/// that are merely kept need not be realizable: if they are not planar, no curvature is.
/// \param is_exact whether the surface is to stay on its exact conformal class
std::string step_fault(const Spin_report& report, bool is_turning, bool is_exact,
                       const Flow_options& options);

/// \ingroup PkgFlow
/// \brief the conformal Willmore flow of a surface: a sequence of spin transformations that makes
/// the surface and its boundary as smooth as the conformal class allows [CGP 6.4].
///
/// Each step takes the direction v (-H for the Willmore flow), projects it onto the constraints,
/// and transforms by rho = tau v. On closed surfaces, v must be orthogonal to the constants, which
/// have no effect, and to the components of the normals, which correspond to sphere inversions.
/// With a free boundary or prescribed tangents, there are no such constraints; with prescribed
/// binormals, v must be orthogonal to the constants, so that the flow converges to constant mean
/// curvature. With a prescribed volume, the gradient of this takes the place of the normals, see
/// `internal::Volume_constraint`. On surfaces with handles or holes, the edges must close up around
/// them. Area and centroid are preserved.
///
/// The faces of the input are judged, too: no surface is accepted that has 1 % more energy there
/// than the input, or leaves `Flow_options::limits`.
///
/// Surfaces stay on the exact discrete conformal class of the initial one: each step is smoothing
/// within the class, then a spin transformation, and ends with the nearest surface of the class,
/// see `Flow_options::exact_conformal_class`. Where even a step of `min_time_step` would leave
/// `Flow_options::limits`, the flow ends. Without that, as in the thesis:
///
/// The conformal class of a surface with handles is kept but for two errors. The periods of a step
/// are of second order in tau: left alone they add up to O(tau); `Flow_options::max_period_defect`
/// bounds them. The other is the mesh's: D - rho has four equations per face for four unknowns per
/// vertex, half as many, so the edges of a face close only in the sense of least squares, and
/// forcing them to shears the faces. These shears are O(h^2) of the change of the surface, do not
/// cancel, and have the sense in which the energy falls; their sum does not depend on tau. The sum
/// of the `closure_residual`s tells how large it is; only a finer mesh makes it smaller.
///
/// A step is accepted if its equation is solved, its distortion is small enough, its edges close
/// up, and the energy decreases (not required of steps that turn a boundary to prescribed
/// directions). Where directions are kept, the energy may rise by what the step misses of them if a
/// tenth of the direction is taken away: binormals missed by theta change the energy by the mean
/// curvature times the integral of theta, and would end the flow before H is constant. Otherwise a
/// step is repeated with half of tau. The state of this object is always that after the last
/// complete step.
///
/// Ordering and symbolic factorization are computed once, in the constructor. A trial costs one
/// numeric factorization of the Dirac matrix and about ten solves with it; if its edges have to be
/// closed, one more solve for each loop. With handles, a step begins with a factorization for rho =
/// 0 and about four solves for each loop. The way back to the class costs a factorization of about
/// twice the operations where the surface has moved far, and solves only where it has not.
///
/// \tparam Direction a model of `CurvatureDirection`
class Conformal_willmore_flow {
 public:
  /// \param mesh is copied
  /// \param function named in exceptions
  /// \throw Precondition_error if the mesh is not a connected, oriented manifold with
  /// finite coordinates and positive areas, or an option is out of its range
  /// \throw Solver_error if the analysis fails
  explicit Conformal_willmore_flow(const Mesh_view& mesh, const Flow_options& options = {},
                                   internal::Curvature_direction_ref direction = {},
                                   std::string function = "Conformal_willmore_flow");

  /// the surface after the last complete step; on the exact conformal class, its faces are those of
  /// the intrinsic Delaunay triangulation of the initial surface
  const Mesh_view& mesh() const { return m_mesh; }

  /// \brief the points after the last complete step, for the faces of the input, 3 x |V|: those of
  /// `mesh()`, or, on closed surfaces, `internal::Face_filter::settled()` where that lowers the
  /// energy on these faces by more than 5 %. The surface is then off its exact class by as much.
  Points positions() const
  {
    return m_steps == 0 ? m_mesh.positions() : written(m_mesh.positions()).positions;
  }

  /// the initial surface of the flow, of the same connectivity
  const Mesh_view& initial_mesh() const { return m_initial; }

  /// the energy of the direction, or the Willmore energy if it has none
  double energy() const { return m_energy; }

  /// number of accepted steps
  int size_of_steps() const { return m_steps; }

  /// \brief makes one step, as large as the energy allows, or reports why there is none.
  ///
  /// The flow is as before the step if this is not accepted, or an exception is thrown.
  /// \throw Precondition_error if the direction is not one finite number per vertex, or the visitor
  /// calls `step()` or `run()`
  /// \throw Solver_error if a solver runs out of memory; other failures of solvers are reported
  template <class Visitor = Flow_visitor>
  Flow_step_report step(Visitor&& visitor = Visitor())
  {
    const internal::Thread_team team;
    m_visits.require_no_visit(m_function);
    internal::Stopwatch watch;
    Flow_step_report report;
    report.step = m_steps + 1;
    report.energy_before = report.energy = m_energy;
    const State before = state();
    try {
      take_step(report, [&](const Eigensolver_progress& progress) {
        return m_visits.during([&] {
          visitor.on_iteration(progress);
          return visitor.go_further();
        });
      });
      if (!report.accepted) restore(before);
    } catch (const Solver_error& error) {
      restore(before);
      if (is_out_of_memory(error)) throw;  // a smaller step needs as much memory
      (void)reject({error.what(), internal::thinness(m_mesh)}, report);
      report.stop = Flow_step_report::Stop::step_failed;
    } catch (...) {
      restore(before);
      throw;
    }
    report.seconds = watch.lap();
    return report;
  }

  /// \brief makes steps until a stopping criterion holds; a further call continues the flow.
  template <class Visitor = Flow_visitor>
  Flow_report run(Visitor&& visitor = Visitor())
  {
    const internal::Thread_team team;
    m_visits.require_no_visit(m_function);
    internal::Stopwatch watch;
    Flow_report report;
    report.initial_energy = m_energy;
    report.initial_energy_of_faces = written_energy();
    m_visits.during([&] { visitor.on_flow_begin(m_mesh, m_energy); });
    while (report.stop == Flow_step_report::Stop::none) {
      if (static_cast<int>(report.steps.size()) >= m_options.max_steps)
        report.stop = Flow_step_report::Stop::steps_done;
      else if (!m_visits.during([&] { return visitor.go_further(); }))
        report.stop = Flow_step_report::Stop::cancelled;
      else if (append(report, step(visitor)))
        m_visits.during([&] { visitor.on_step_end(report.steps.back(), shown()); });
    }
    finish(report);
    report.seconds = watch.lap();
    return report;
  }

 private:
  /// the result of a trial
  enum class Verdict {
    good,
    rises_slightly,
    rises_within_error,
    bad,
    out_of_bound,  // lengths are beyond theirs
    out_of_limits,
    cancelled
  };

  /// what a step changes beside its number
  struct State {
    Points positions;
    double energy;
    internal::Time_step time_step;
    internal::Smoothing smoothing;
    std::optional<internal::Class_keeper::State> keeper;
    internal::Scale_bound::Pace pace;
  };

  double energy_of(const Mesh_view& mesh) const;
  static Mesh_view in_frame(const Mesh_view& mesh);  ///< of unit size
  static Spin_transformation_options transformation_options(const Mesh_view& initial,
                                                            const Flow_options& options);

  /// the part of the initial mesh on which distortion is measured
  const Mesh_view& measured() const { return m_well_shaped ? m_well_shaped->mesh : m_initial; }
  static internal::Well_shaped_faces well_shaped_part(const Mesh_view& mesh);

  /// the faces of the input, or those well shaped, where the flow has others
  std::optional<Mesh_view> other_faces() const;

  /// of the input, or those well shaped
  const Mesh_view& faces() const { return m_faces ? *m_faces : measured(); }

  /// the filter of the faces of the input; none where these are so thin that it cannot be factored
  void make_filter();

  /// `mesh()` at `positions()`
  Mesh_view shown() const;

  /// what is written of a surface of the flow, see `positions()`, with its `energy_of_faces()`
  struct Written {
    Points found, positions;
    double energy;
  };
  const Written& written(const Points& found) const;
  void settle(Written& result) const;

  /// of `positions()`
  double written_energy() const
  {
    return m_steps == 0 ? energy_of_faces(m_mesh.positions()) : written(m_mesh.positions()).energy;
  }

  /// on the faces of the input where these are judged, otherwise on those of the flow
  double energy_of_faces(const Points& positions) const;

  /// why a surface is beyond limits, or on the faces of the input beyond those of the options
  internal::Refusal beyond(const Conformality& map, const Conformality::Limits& limits,
                           const Points& positions) const;

  /// how the connectivity of the class was made of the faces of the input, with mollification
  Spin_report::Mollification mollification_on_class() const;

  /// the surface on which the flow computes: of the exact class, if it is kept
  static Mesh_view on_class(const Mesh_view& mesh, const Flow_options& options,
                            const std::string& function);
  bool fairs() const;

  /// none if the volume is free
  std::optional<internal::Volume_constraint> volume_constraint() const;

  // A single type for all visitors, so that the eigensolver is compiled only once.
  using Go_further = std::function<bool(const Eigensolver_progress&)>;

  /// \brief Smooths the surface, transforms it, and accepts the step if one of the two succeeded.
  ///
  /// On closed surfaces, smoothing pauses for a few steps where it gains less than the
  /// transformation, for it costs as much; with a boundary, where it fails.
  void take_step(Flow_step_report& report, const Go_further& go_further);
  void transform(Flow_step_report& report, const Go_further& go_further);

  /// Smooths the surface within its class; \returns whether that lowered the energy.
  bool fair(Flow_step_report& report);

  /// for a step that would be the last without smoothing
  void end_pause(Flow_step_report& report);
  /// likewise within `Flow_options::max_spin_distortion`
  void go_to_limits(Flow_step_report& report, const Go_further& go_further);
  /// Accepts a step of which only the smoothing succeeded; the flow goes on if that was enough.
  void settle_for_fairing(Flow_step_report& report);

  /// Tells how far the boundary of the present surface, which is in the class, is from the
  /// directions that are kept or prescribed.
  void judge_boundary(Spin_report& report) const;

  State state() const;
  /// Returns to the state before an incomplete step.
  void restore(const State& before);

  /// Moves the last surface of a run to its class to rounding, and measures the map.
  void finish(Flow_report& report);
  void polish();
  double type_change() const;

  /// In a frame of unit size, where areas neither vanish nor overflow.
  static Conformality map_to(const Mesh_view& measured, const Points& positions);

  /// Tries time steps until one is accepted or none is left.
  void find_time_step(const internal::Constrained_direction::Result& direction,
                      Flow_step_report& report, const Go_further& go_further);

  /// Transforms the surface; adopts the result if it is acceptable.
  Verdict try_step(const Eigen::VectorXd& rho, Flow_step_report& report,
                   const Go_further& go_further);
  /// Likewise by rho, with the bound on lengths if they are beyond then.
  Verdict try_within_bound(const Eigen::VectorXd& rho, Flow_step_report& report,
                           const Go_further& go_further);
  /// Likewise after a step with the bound, by rho if that fails.
  Verdict try_at_bound(const Eigen::VectorXd& rho, Flow_step_report& report,
                       const Go_further& go_further);
  /// Likewise with the rho' that keeps lengths to their bound.
  Verdict try_bounded_step(const Eigen::VectorXd& rho, Flow_step_report& report,
                           const Go_further& go_further);
  Verdict judge(Spin_result result, Flow_step_report& report);
  /// Likewise for a result of which the report has not told yet.
  Verdict judge_new(Spin_result result, Flow_step_report& report);

  /// \brief balances the next surface and returns its energy.
  ///
  /// Inversions preserve the energy up to O(h^2); they are omitted if that error exceeds the
  /// decrease by the step.
  double balanced(double energy);

  /// upper bound of the increase of energy by a step: zero, unless the boundary still has to turn
  double forbidden_rise() const;

  /// angles between the boundary and the first or the prescribed directions
  Spin_report::Direction_error direction_error() const;
  /// what is left of it to be turned
  double turning_angle() const
  {
    return m_options.surface.boundary.targets.cols() > 0 ? direction_error().mean : 0;
  }
  bool is_turning() const { return turning_angle() > 0.01; }

  /// asks the way to the class for the volume after a step of `time`; returns the change of its
  /// logarithm, zero without a `Volume_constraint`
  double keep_volume(double time);

  /// whether the surface still has to reach the prescribed volume
  bool is_filling() const;

  /// whether the surface stays on its class, and its boundary keeps directions
  bool keeps_directions() const;

  /// \brief whether a rise of the energy is no more than what a step misses of the directions at
  /// the boundary accounts for, while it `falls_at_boundary()`.
  bool is_of_boundary(double rise, const Flow_step_report& report) const;

  /// whether a step takes a tenth of what the constraints leave of the direction
  bool falls_at_boundary(const Flow_step_report& report) const;

  /// \brief why no time step is left: the minimum is reached as well as the mesh allows, limbs are
  /// too small, or neither.
  Flow_step_report::Stop reason_to_end(Verdict last, Flow_step_report& report) const;

  Verdict reject(const internal::Refusal& refusal, Flow_step_report& report) const;

  /// how far logarithms of lengths are from those of the initial surface, |V|
  Eigen::VectorXd scales_of(const Mesh_view& mesh) const;

  /// whether a change of the energy is below the tolerance, extrapolated to a time of 1
  bool is_small(double change, double time) const;

  /// \brief whether a rise of the energy says nothing about its descent: it is below the tolerance
  /// even for a time of 1, or no more than it takes to lead the boundary back to its directions,
  /// or than a bound on lengths has left of the Dirac equation.
  bool is_within_error(double rise, bool is_bounded) const;

  /// Adopts the next surface if the map to it is within the limits. Performs all operations that
  /// may fail before the first change.
  Verdict move_on(double energy, const Conformality::Limits& limits, Flow_step_report& report);
  bool leaves_room() const;  // transformations do, for smoothing: see `max_spin_distortion`
  Conformality::Limits spin_limits() const;
  void accept(Flow_step_report& report, bool was_filling);
  void tell_energy(Flow_step_report& report);
  bool rises_on_faces(double energy) const;

  std::string m_function;
  internal::Visit_guard m_visits;
  Flow_options m_options;
  Mesh_view m_input;                              // with its own faces
  Mesh_view m_initial, m_mesh, m_next;            // m_next: workspace for trials
  std::optional<Mesh_view> m_faces;               // of the input, where the flow has others
  std::optional<internal::Face_filter> m_filter;  // of the input
  mutable std::optional<Written> m_written;       // asked for last
  Spin_transformation m_transformation;
  std::optional<internal::Class_keeper> m_class;  // if the exact class is kept
  std::optional<internal::Well_shaped_faces>
      m_well_shaped;  // of the initial mesh, with mollification
  std::optional<internal::Volume_constraint> m_volume;
  internal::Constrained_direction m_direction;
  internal::Flow_balance m_balance;
  std::optional<internal::Scale_bound> m_scale_bound;
  bool m_is_bounded = false;  // the last step has met it
  double m_initial_energy, m_energy, m_least_energy_of_faces;
  internal::Time_step m_time_step;
  internal::Smoothing m_smoothing;
  Spin_report::Mollification m_mollification;  // on the exact class
  int m_steps = 0;
};

}  // namespace Conformal_geometry_processing
