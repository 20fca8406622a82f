// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/gauge.h>
#include <Conformal_geometry_processing/spin/snap_to_class.h>
#include <Quaternionic_linear_algebra/threads/Thread_team.h>

#include <limits>

namespace Conformal_geometry_processing {

Spin_transformation::Spin_transformation(const Mesh_view& mesh,
                                         const Spin_transformation_options& options,
                                         const std::string& function)
    : m_function(function), m_options(options)
{
  const internal::Thread_team team;
  internal::Stopwatch watch;
  internal::Framed_surface::require(mesh, options.mollification, function);
  options.scales.require(mesh.size_of_vertices(), function);
  if (options.scales.bound && options.boundary.kind == Boundary_condition::Kind::positions)
    throw Precondition_error(function, "a scale bound and prescribed positions: these fix scales");
  if (options.exact_conformal_class) {
    internal::require_edge_lengths(mesh, function);
    if (options.boundary.kind == Boundary_condition::Kind::positions)
      throw Precondition_error(function,
                               "the exact conformal class and prescribed positions: no surface of "
                               "the class need have these");
  }
  m_stage = std::make_unique<Stage>(mesh, *this);
  m_stage->seconds = watch.lap();  // with the checks
}

Spin_transformation::Stage::Stage(const Mesh_view& mesh, const Spin_transformation& of)
    : domain(mesh, of.m_options.mollification),
      system(domain.surface(), domain.in_frame(of.m_options.boundary), of.m_function,
             of.m_options.solvers),
      seconds(watch.lap())
{}

void Spin_transformation::set_positions(const Points& positions)
{
  const internal::Thread_team team;
  m_visits.require_no_visit(m_function);
  require_size(positions.cols(), "positions");
  if (system().positions())
    throw Precondition_error(m_function, "a surface with prescribed boundary cannot move");
  Mesh_view moved = domain().mesh();  // with its edges, which need not be found again
  moved.set_positions(positions);
  internal::Framed_surface::require_faces(moved, domain().is_mollified(), m_function);
  if (domain().is_mollified()) {
    m_stage = std::make_unique<Stage>(moved, *this);
    return;
  }
  const Points before = this->positions();
  const auto move = [this](const Points& p) {
    m_stage->domain.set_positions(p);
    m_stage->is_poisson_old = true;
    m_stage->exactness.reset();
    m_stage->closing.reset();
    m_stage->preview.reset();
    require_condition(domain().surface(), m_options.boundary, m_function);
    system().update_geometry();
  };
  try {
    move(positions);
  } catch (...) {
    move(before);
    throw;
  }
}

const Poisson_reconstruction& Spin_transformation::reconstruction()
{
  auto& poisson = m_stage->poisson;
  if (!poisson)
    poisson.emplace(system().surface(), system().matrix().shared_pattern(), system().solver());
  else if (m_stage->is_poisson_old)
    poisson->update_geometry();
  m_stage->is_poisson_old = false;
  return *poisson;
}

// The start is that of the first positions, not of the last: so results do not depend on the steps
// between.
const internal::Exactness_constraints& Spin_transformation::exactness(Curvature_potential::On on)
{
  auto& found = m_stage->exactness;
  if (found && found->on == on) return *found;
  internal::Stopwatch watch;
  const auto& laplacian = reconstruction().solver();
  m_unreported.seconds.reconstruction += watch.lap();
  const auto constraints = [&](std::optional<Exactness> version) {
    return exactness_constraints(system(), laplacian, domain().forms(), on, version,
                                 m_stage->forms ? &*m_stage->forms : nullptr);
  };
  const bool may_move = domain().has_loops() && !domain().is_mollified();
  if (may_move && !m_stage->forms) m_stage->forms = constraints(std::nullopt).forms;
  found = constraints(m_options.exactness);
  m_unreported.factorizations += found->factorizations;
  m_unreported.solves += found->solves;
  if (domain().has_loops()) m_unreported.seconds.exactness += watch.lap();
  return *found;
}

const internal::Exactness_constraints* Spin_transformation::closing()
{
  if (!m_options.exactness || !has_loops()) return nullptr;
  auto& found = m_stage->closing;
  if (!found) {
    internal::Stopwatch watch;
    const auto& laplacian = reconstruction().solver();
    m_unreported.seconds.reconstruction += watch.lap();
    found = exactness_constraints(system(), laplacian, domain().forms(),
                                  Curvature_potential::On::vertices, std::nullopt);
    m_unreported.seconds.exactness += watch.lap();
  }
  return &*found;
}

void Spin_transformation::require_potential(const Curvature_potential& rho) const
{
  Conformal_geometry_processing::require_potential(domain().mesh(), rho, domain().unit(),
                                                   m_function);
}

Spin_result Spin_transformation::step(const Curvature_potential& rho,
                                      const internal::Go_further& go_further)
{
  return judged(trial_step(rho, go_further), rho);
}

Spin_result Spin_transformation::trial_step(const Curvature_potential& rho,
                                            const internal::Go_further& go_further)
{
  const internal::Thread_team team;
  m_visits.require_no_visit(m_function);
  require_potential(rho);
  Spin_result result = solve(rho, go_further);
  if (!result.report.cancelled) reconstruct(result);
  return result;
}

Spin_result Spin_transformation::integrate(Quaternion_vector<double> lambda)
{
  const internal::Thread_team team;
  m_visits.require_no_visit(m_function);
  require_size(lambda.size(), "spins");
  Spin_result result;
  result.lambda = std::move(lambda);
  result.report.converged = true;
  result.report.limits = m_options.limits;
  result.report.mollification = domain().mollification();
  reconstruct(result);
  return result;
}

void Spin_transformation::require_size(Eigen::Index size, const std::string& what) const
{
  const int needed = domain().mesh().size_of_vertices();
  if (size != needed)
    throw Precondition_error(m_function,
                             std::to_string(size) + " " + what +
                                 ", one per vertex is needed: " + std::to_string(needed));
}

Spin_result Spin_transformation::solve(const Curvature_potential& rho,
                                       const internal::Go_further& go_further)
{
  const double unit = domain().unit();
  Dirac_options options = m_options.dirac;
  options.kernel_tolerance *= unit;
  Spin_result result = in_units(solve_dirac_equation(system(), {rho.on, rho.values * unit}, options,
                                                     m_visits.guarded(go_further)));
  internal::add_costs(result.report, take_unreported());
  return result;
}

Spin_result Spin_transformation::in_units(internal::Dirac_solution s) const
{
  Spin_result result;
  static_cast<internal::Dirac_evidence&>(result.report) =
      Conformal_geometry_processing::in_units(s, domain().unit());
  static_cast<internal::Dirac_evidence::Seconds&>(result.report.seconds) = s.seconds;
  result.report.limits = m_options.limits;
  result.report.seconds.setup = m_stage->seconds;
  result.report.mollification = domain().mollification();
  result.lambda = std::move(s.lambda);
  return result;
}

void Spin_transformation::reconstruct(Spin_result& result,
                                      const std::function<void(Spin_result&)>& place)
{
  internal::Stopwatch watch;
  Spin_report& r = result.report;
  auto* const positions = system().positions();
  const Eigen::MatrixX3d edges = transformed_edges(system().surface(), result.lambda);
  Points f = positions ? positions->positions(edges) : reconstruction().positions(edges);
  r.closure_residual = reconstruction().residual(f, edges);
  r.seconds.reconstruction += watch.lap();
  // Excludes thin faces: those of area zero may have become wrinkled.
  if (!positions) restore_area(domain().measured(), f, result.lambda);
  result.positions = domain().frame().from_frame(f);
  if (place) place(result);
  f = domain().frame().to_frame(result.positions);  // after rounding
  internal::certify(domain().measured(), f, result.lambda, r);
  judge_boundary(f, r);
  r.seconds.certificate = watch.lap();
}

Spin_result Spin_transformation::judged(Spin_result result, const Curvature_potential& rho) const
{
  Spin_report& r = result.report;
  if (r.cancelled || result.positions.cols() == 0) return result;
  internal::Stopwatch watch;
  const auto& pattern = system().matrix().shared_pattern();
  auto& smoother = m_stage->smoother;
  if (!smoother) {
    smoother.emplace(system().solver().another<double>());
    internal::check_smoothing("analysis", smoother->analyze_like(*pattern, system().solver()));
  }
  r.realised_curvature = internal::realised_curvature(
      domain().measured(), domain().frame().to_frame(result.positions), in_frame(rho),
      !system().is_self_adjoint(), system().surface(), pattern, *smoother);
  r.seconds.certificate += watch.lap();
  return result;
}

void Spin_transformation::judge_boundary(const Points& f, Spin_report& report) const
{
  const internal::Dirac_system& dirac = system();
  if (dirac.is_closed()) return;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (dirac.directions()) {
    const Eigen::VectorXd errors =
        f.allFinite()
            ? domain().direction_errors(*dirac.directions(), f, dirac.directions()->targets())
            : Eigen::VectorXd::Constant(1, nan);
    report.direction_error = {errors.mean(), errors.maxCoeff()};
  }
  if (const auto* positions = dirac.positions()) {
    const Eigen::VectorXd errors = domain().unit() * positions->errors(f);
    report.has_positions = true;
    report.position_error = {errors.mean(), errors.maxCoeff()};
  }
  report.radius = domain().unit() * internal::radius_of_area(dirac.surface());
  report.limits_gamma = turns_directions() && dirac.is_self_adjoint();
  const bool is_misfit = dirac.directions() && !dirac.is_self_adjoint() && !report.is_relaxed;
  const double sigma = is_misfit ? report.eigenvalue * domain().unit() : 0;
  report.boundary_fault = boundary_fault(dirac.surface(), sigma, report);
}

}  // namespace Conformal_geometry_processing
