// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FLOW_CLOSING_SPIN_TRANSFORMATION_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_FLOW_CLOSING_SPIN_TRANSFORMATION_TEMPLATES_H

#include <Conformal_geometry_processing/flow/Closing_spin_transformation.h>
#include <Conformal_geometry_processing/spin/certify.h>
#include <Conformal_geometry_processing/spin/restore_area.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {

template <class SolverTraits, class EigensolverTraits, template <class, class> class Moving>
Closing_spin_transformation<SolverTraits, EigensolverTraits, Moving>::Closing_spin_transformation(
    const Mesh_view& mesh, const Closing_options& options, const std::string& function)
    : Closing_spin_transformation(mesh, options, Boundary_condition(), function)
{}

template <class SolverTraits, class EigensolverTraits, template <class, class> class Moving>
Closing_spin_transformation<SolverTraits, EigensolverTraits, Moving>::Closing_spin_transformation(
    const Mesh_view& mesh, const Closing_options& options, const Boundary_condition& condition,
    const std::string& function)
    : m_options(options), m_transformation(mesh, condition, function), m_initial(mesh)
{}

template <class SolverTraits, class EigensolverTraits, template <class, class> class Moving>
Closing_spin_transformation<SolverTraits, EigensolverTraits, Moving>::Closing_spin_transformation(
    const Mesh_view& mesh, const Closing_options& options, const Boundary_condition& condition,
    double mollification, const std::string& function)
    : m_options(options),
      m_transformation(mesh, condition, mollification, function, options.exactness.has_value()),
      m_initial(mesh)
{}

template <class SolverTraits, class EigensolverTraits, template <class, class> class Moving>
Spin_result Closing_spin_transformation<SolverTraits, EigensolverTraits, Moving>::transform(
    const Curvature_potential& rho, const Dirac_options& options, const Go_further& go_further) &&
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

// Of what must close, there is nothing on a sphere, a disk, or between given positions.
template <class SolverTraits, class EigensolverTraits, template <class, class> class Moving>
bool Closing_spin_transformation<SolverTraits, EigensolverTraits, Moving>::has_loops()
{
  const Mesh_view& mesh = m_initial;
  const int chi = mesh.size_of_vertices() - mesh.size_of_edges() + mesh.size_of_faces();
  const bool is_closed = m_transformation.dirac_equation().is_closed();
  return chi < (is_closed ? 2 : 1) && !m_transformation.dirac_equation().positions();
}

template <class SolverTraits, class EigensolverTraits, template <class, class> class Moving>
void Closing_spin_transformation<SolverTraits, EigensolverTraits, Moving>::go_all_the_way(
    Surface& surface, const Dirac_options& options, const Go_further& go_further, Spin_result& all)
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

template <class SolverTraits, class EigensolverTraits, template <class, class> class Moving>
double Closing_spin_transformation<SolverTraits, EigensolverTraits, Moving>::norm(
    const Eigen::VectorXd& rho, const Eigen::VectorXd& A) const
{
  const bool has_effect = !m_transformation.dirac_equation().is_self_adjoint();
  const double mean = has_effect ? 0 : A.dot(rho) / A.sum();
  return std::sqrt(A.dot((rho.array() - mean).square().matrix()));
}

template <class SolverTraits, class EigensolverTraits, template <class, class> class Moving>
std::optional<Spin_result>
Closing_spin_transformation<SolverTraits, EigensolverTraits, Moving>::largest_step(
    const Surface& surface, const Eigen::VectorXd& v, const Dirac_options& options,
    const Go_further& go_further, Spin_report& all, double& step)
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
template <class SolverTraits, class EigensolverTraits, template <class, class> class Moving>
bool Closing_spin_transformation<SolverTraits, EigensolverTraits, Moving>::can_go_on_from(
    const Points& positions)
{
  try {
    m_transformation.set_positions(positions);
  } catch (const Precondition_error&) {
    return false;
  }
  return true;
}

// Defects grow with the square of the step, the share of them that a step may have linearly.
template <class SolverTraits, class EigensolverTraits, template <class, class> class Moving>
double Closing_spin_transformation<SolverTraits, EigensolverTraits, Moving>::best_step(
    double step, double defect) const
{
  const double caution = 0.8;
  return caution * m_options.max_period_defect * step * step / defect;
}

// At most twice the last one; what is left after it shall be no splinter.
template <class SolverTraits, class EigensolverTraits, template <class, class> class Moving>
double Closing_spin_transformation<SolverTraits, EigensolverTraits, Moving>::next_step(
    double step, double defect, double rest) const
{
  const double better = (std::min)(best_step(step, defect), 2 * step);
  return rest - better < m_options.min_step ? (rest < m_options.min_step / 2 ? 0 : rest) : better;
}

template <class SolverTraits, class EigensolverTraits, template <class, class> class Moving>
void Closing_spin_transformation<SolverTraits, EigensolverTraits, Moving>::take(
    const Spin_result& next, const Eigen::VectorXd& v, double share, Surface& surface)
{
  const Eigen::ArrayXd before = surface.areas();
  surface.move_to(next.positions);
  const Eigen::VectorXd shrinking = (before / surface.areas().array()).sqrt();
  m_left_out = shrinking.cwiseProduct(m_left_out + m_missing.values - v);
  m_missing.values = (1 - share) * shrinking.cwiseProduct(v);
}

template <class SolverTraits, class EigensolverTraits, template <class, class> class Moving>
Quaternion_vector<double>
Closing_spin_transformation<SolverTraits, EigensolverTraits, Moving>::product(
    const Quaternion_vector<double>& first, const Quaternion_vector<double>& second)
{
  Quaternion_vector<double> both(first.size());
  for (Eigen::Index i = 0; i < first.size(); ++i) both[i] = first[i] * second[i];
  return both;
}

template <class SolverTraits, class EigensolverTraits, template <class, class> class Moving>
void Closing_spin_transformation<SolverTraits, EigensolverTraits, Moving>::measure(
    const Mesh_view& before, const Surface& after, Spin_result& all)
{
  all.positions = after.positions();
  restore_area(before, all.positions, all.lambda);  // which every step keeps, of its own faces
  internal::certify(before, all.positions, all.lambda, all.report);
}

}  // namespace Conformal_geometry_processing

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
namespace Conformal_geometry_processing {

// Not the whole class: a constructor belongs to one kind of surface or the other.
extern template Closing_spin_transformation<
    Default_solver_traits, Lobpcg_eigensolver_traits,
    Moving_mesh>::Closing_spin_transformation(const Mesh_view&, const Closing_options&,
                                              const std::string&);
extern template Closing_spin_transformation<
    Default_solver_traits, Lobpcg_eigensolver_traits,
    Moving_mesh>::Closing_spin_transformation(const Mesh_view&, const Closing_options&,
                                              const Boundary_condition&, const std::string&);
extern template Closing_spin_transformation<
    Default_solver_traits, Lobpcg_eigensolver_traits,
    Moving_delaunay_view>::Closing_spin_transformation(const Mesh_view&, const Closing_options&,
                                                       const Boundary_condition&, double,
                                                       const std::string&);
extern template Spin_result
Closing_spin_transformation<Default_solver_traits, Lobpcg_eigensolver_traits,
                            Moving_mesh>::transform(const Curvature_potential&,
                                                    const Dirac_options&, const Go_further&) &&;
extern template Spin_result
Closing_spin_transformation<Default_solver_traits, Lobpcg_eigensolver_traits,
                            Moving_delaunay_view>::transform(const Curvature_potential&,
                                                             const Dirac_options&,
                                                             const Go_further&) &&;

}  // namespace Conformal_geometry_processing
#endif

#endif
