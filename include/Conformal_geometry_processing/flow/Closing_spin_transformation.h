// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FLOW_CLOSING_SPIN_TRANSFORMATION_H
#define CONFORMAL_GEOMETRY_PROCESSING_FLOW_CLOSING_SPIN_TRANSFORMATION_H

#include <Conformal_geometry_processing/flow/Moving_delaunay_view.h>
#include <Conformal_geometry_processing/flow/Moving_mesh.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/spin/certify.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgFlow
/// how a surface with handles is kept closed
struct Closing_options {
  /// how the constraints are discretised; none: one step, and the handles are sheared
  std::optional<Exactness> exactness = Exactness::adjoint;
  double max_period_defect = 0.02;  ///< relative to the edges, of all steps together
  double min_step = 1. / 256;       ///< the least share of rho that is worth a step
};

/// \ingroup PkgFlow
/// \brief spin transformations of surfaces with any number of handles and holes by any rho: applies
/// the part of rho with which the surface stays closed around them, in as many steps as that takes
/// [CGP 4.5.2].
///
/// The edges of a transformed surface have periods along the 2G loops of its handles, and where a
/// surface is made to close all the same, it is sheared. To first order the periods vanish if rho
/// is orthogonal to 6G functions (`exactness_constraints()`), so what is left falls with the square
/// of the step. Each step is as large as the tolerance allows, and the next one goes on from the
/// surface found towards the curvature that is missing: rho |df|, rho as a density of lengths, is
/// what adds up over transformations.
///
/// On spheres and disks it does what `Spin_transformation` does, and nothing else. Otherwise a step
/// costs a second factorization, of the matrix for rho = 0, and 10G solves or so.
///
/// \tparam SolverTraits a model of `SparseHermitianSolverTraits`
/// \tparam EigensolverTraits a model of `SparseHermitianEigensolverTraits`
/// \tparam Moving `Moving_mesh`, or `Moving_delaunay_view` for faces as thin as they may be
template <class SolverTraits = Default_solver_traits,
          class EigensolverTraits = Lobpcg_eigensolver_traits,
          template <class, class> class Moving = Moving_mesh>
class Closing_spin_transformation {
  using Surface = Moving<SolverTraits, EigensolverTraits>;

 public:
  /// \param mesh must outlive the object
  /// \param function named in exceptions
  /// \throw Precondition_error as `Spin_transformation` does
  /// \throw Solver_error if the analysis fails
  explicit Closing_spin_transformation(const Mesh_view& mesh, const Closing_options& options = {},
                                       const std::string& function = "Closing_spin_transformation")
      : Closing_spin_transformation(mesh, options, Boundary_condition(), function)
  {}

  /// the same with a condition for the boundary
  Closing_spin_transformation(const Mesh_view& mesh, const Closing_options& options,
                              const Boundary_condition& condition, const std::string& function)
      : m_options(options), m_transformation(mesh, condition, function), m_initial(mesh)
  {}

  /// \brief the same of a `Robust_spin_transformation`, with `Moving_delaunay_view`.
  /// \param mollification see `mollified_lengths()`
  Closing_spin_transformation(const Mesh_view& mesh, const Closing_options& options,
                              const Boundary_condition& condition, double mollification,
                              const std::string& function)
      : m_options(options),
        m_transformation(mesh, condition, mollification, function, options.exactness.has_value()),
        m_initial(mesh)
  {}

  /// \brief transforms the mesh; the object is used up.
  ///
  /// Where not all of rho can be reached, the report tells which share (`reached`).
  /// \param rho in 1/length of the mesh, one number per vertex or per face
  /// \param go_further asked between iterations with an `Eigen_progress`; false cancels
  /// \throw Precondition_error if rho has the wrong length or a value that is not finite
  /// \throw Solver_error if a factorization fails. No convergence is a field of the report.
  Spin_result transform(const Curvature_potential& rho, const Dirac_options& options = {},
                        const Go_further& go_further = Always_go_further()) &&
  {
    m_transformation.require_potential(rho);
    if (!m_options.exactness || !has_loops())
      return std::move(m_transformation).transform(rho, options, go_further);
    Surface surface(m_transformation, m_initial, *m_options.exactness, rho.on);
    m_missing = rho;
    m_left_out = Eigen::VectorXd::Zero(rho.values.size());
    const double wanted = norm(rho.values, surface.areas());
    Spin_result result;
    result.lambda = Quaternion_vector<double>::Constant(m_initial.size_of_vertices(), {1, 0, 0, 0});
    result.report.steps = 0;
    result.report.reached = 0;
    go_all_the_way(surface, options, go_further, result);
    if (result.report.steps > 0) measure(Surface::measured(m_initial), surface, result);
    if (wanted > 0)
      result.report.missing_share = norm(m_left_out + m_missing.values, surface.areas()) / wanted;
    return result;
  }

 private:
  // Of what must close, there is nothing on a sphere, a disk, or between given positions.
  bool has_loops()
  {
    const Mesh_view& mesh = m_initial;
    const int chi = mesh.size_of_vertices() - mesh.size_of_edges() + mesh.size_of_faces();
    const bool is_closed = m_transformation.dirac_equation().is_closed();
    return chi < (is_closed ? 2 : 1) && !m_transformation.dirac_equation().positions();
  }

  void go_all_the_way(Surface& surface, const Dirac_options& options, const Go_further& go_further,
                      Spin_result& all)
  {
    for (double step = 1; step > 0;) {
      surface.update();
      const Eigen::VectorXd v = surface.basis().project_out(m_missing.values);
      const double rest = 1 - all.report.reached;
      const std::optional<Spin_result> next =
          largest_step(surface, v / rest, options, go_further, all.report, step);
      if (!next) return;
      take(*next, v, step / rest, surface);
      all.lambda = product(all.lambda, next->lambda);
      append(all.report, next->report);
      all.report.reached += step;
      step = next_step(step, next->report.period_defect, 1 - all.report.reached);
    }
    all.report.reached = 1;  // but for rounding
  }

  /// root of the integral of rho squared, less its mean where that has no effect; does not depend
  /// on scale
  double norm(const Eigen::VectorXd& rho, const Eigen::VectorXd& A) const
  {
    const bool has_effect = !m_transformation.dirac_equation().is_self_adjoint();
    const double mean = has_effect ? 0 : A.dot(rho) / A.sum();
    return std::sqrt(A.dot((rho.array() - mean).square().matrix()));
  }

  /// \brief tries `step` times v and smaller steps, until one is good enough to go there.
  /// \returns none if no step of the least size is, or the visitor said no
  std::optional<Spin_result> largest_step(const Surface& surface, const Eigen::VectorXd& v,
                                          const Dirac_options& options, const Go_further& go_further,
                                          Spin_report& all, double& step)
  {
    for (;;) {
      Spin_result next = m_transformation.transform({m_missing.on, step * v}, options, go_further);
      if (next.report.cancelled) {
        all.cancelled = true;
        return std::nullopt;
      }
      double& defect = next.report.period_defect;
      defect = surface.defect(next.lambda);
      const bool is_good = next.report.converged && defect <= m_options.max_period_defect * step;
      if (is_good && can_go_on_from(next.positions)) return next;
      if (step <= m_options.min_step) {
        if (all.steps == 0) all.boundary_fault = next.report.boundary_fault;
        if (all.steps == 0) all.mollification = next.report.mollification;
        return std::nullopt;
      }
      const double better = next.report.converged && !is_good ? best_step(step, defect) : 0;
      step = (std::max)(m_options.min_step, std::clamp(better, step / 8, step / 2));
    }
  }

  // A face that has shrunk to nothing is no fault of the caller's mesh.
  bool can_go_on_from(const Points& positions)
  {
    try {
      m_transformation.set_positions(positions);
    } catch (const Precondition_error&) {
      return false;
    }
    return true;
  }

  // Defects grow with the square of the step, the share of them that a step may have linearly.
  double best_step(double step, double defect) const
  {
    const double caution = 0.8;
    return caution * m_options.max_period_defect * step * step / defect;
  }

  // At most twice the last one; what is left after it shall be no splinter.
  double next_step(double step, double defect, double rest) const
  {
    const double better = (std::min)(best_step(step, defect), 2 * step);
    return rest - better < m_options.min_step ? (rest < m_options.min_step / 2 ? 0 : rest) : better;
  }

  /// \brief counts from the surface found, where rho becomes another one, as a density of lengths.
  ///
  /// What was not closable before is given up: to try it again, with ever less of the way left to
  /// make up for it, would end in ever faster steps.
  void take(const Spin_result& next, const Eigen::VectorXd& v, double share, Surface& surface)
  {
    const Eigen::ArrayXd before = surface.areas();
    surface.move_to(next.positions);
    const Eigen::VectorXd shrinking = (before / surface.areas().array()).sqrt();
    m_left_out = shrinking.cwiseProduct(m_left_out + m_missing.values - v);
    m_missing.values = (1 - share) * shrinking.cwiseProduct(v);
  }

  static Quaternion_vector<double> product(const Quaternion_vector<double>& first,
                                           const Quaternion_vector<double>& second)
  {
    Quaternion_vector<double> both(first.size());
    for (Eigen::Index i = 0; i < first.size(); ++i) both[i] = first[i] * second[i];
    return both;
  }

  /// the evidence for the whole way
  static void measure(const Mesh_view& before, const Surface& after, Spin_result& all)
  {
    all.positions = after.positions();
    restore_area(before, all.positions, all.lambda);  // which every step keeps, of its own faces
    internal::certify(before, all.positions, all.lambda, all.report);
  }

  Closing_options m_options;
  typename Surface::Transformation m_transformation;
  const Mesh_view& m_initial;
  Curvature_potential m_missing;  // rho that is to come, on the present surface
  Eigen::VectorXd m_left_out;     // rho that cannot come
};

/// \ingroup PkgFlow
/// the same for surfaces whose faces may be as thin as they like, or have area zero
template <class SolverTraits = Default_solver_traits,
          class EigensolverTraits = Lobpcg_eigensolver_traits>
using Robust_closing_spin_transformation =
    Closing_spin_transformation<SolverTraits, EigensolverTraits, Moving_delaunay_view>;

}  // namespace Conformal_geometry_processing

#endif
