// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Conformal_deformation.h>

#include <Conformal_geometry_processing/algebra/rotor.h>
#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/spin/Control_point_search.h>
#include <Conformal_geometry_processing/spin/certify.h>
#include <Conformal_geometry_processing/threads/Thread_team.h>

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// the report of a search, without what is measured on the surface
void tell_search(const Control_point_search& of, double unit, Spin_report& report)
{
  const Dirac_solution& costs = of.search().costs();
  const Dirac_solution& solution = of.search().present().solution;
  static_cast<Dirac_evidence&>(report) = in_units(solution, unit);
  static_cast<Dirac_evidence::Seconds&>(report.seconds) = costs.seconds;
  report.cancelled = costs.cancelled;
  report.iterations = report.factorizations = report.solves = 0;
  add_costs(static_cast<Dirac_evidence&>(report), costs);
  report.reached = of.reached();
  report.steps = of.steps();
  report.realised_share = report.reached;
  report.limits.realised_share = 1;
}

inline std::optional<Region_of_interest> region_of(const Mesh_view& mesh,
                                                   const Conformal_deformation_options& options,
                                                   const std::string& function)
{
  if (options.region.size() == 0) return std::nullopt;
  return Region_of_interest(mesh, options.region, function);
}

/// options for the mesh of the region alone
inline Conformal_deformation_options options_in(const std::optional<Region_of_interest>& region,
                                                Conformal_deformation_options options)
{
  if (!region) return options;
  for (Eigen::VectorXd* of : {&options.surface.scales.factors, &options.surface.scales.weights})
    if (of->size() > 0) *of = (*of)(region->vertices()).eval();
  return options;
}

Conformal_deformation::Conformal_deformation(const Mesh_view& mesh,
                                             const Conformal_deformation_options& options,
                                             const std::string& function)
    : m_function(function),
      m_size(mesh.size_of_vertices()),
      m_region(region_of(mesh, options, function)),
      m_options(options_in(m_region, options)),
      m_transformation(m_region ? m_region->mesh() : mesh, m_options.surface, function)
{
  if (options.surface.boundary.kind != Boundary_condition::Kind::free)
    throw Precondition_error(function, "the boundary has to be free");
  if (!(options.position_weight > 0))
    throw Precondition_error(function, "the position weight is not positive");
}

std::vector<Control_point> Conformal_deformation::all_points(
    const std::vector<Control_point>& points) const
{
  require_control_points(points, m_size, m_function);
  if (!m_region) return points;
  std::vector<Control_point> all = m_region->in_part(points, m_function);
  all.insert(all.end(), m_region->anchors().begin(), m_region->anchors().end());
  return all;
}

Spin_result Conformal_deformation::deform(const std::vector<Control_point>& given,
                                          const Dirac_options& options,
                                          const Go_further& go_further)
{
  const internal::Thread_team team;
  m_visits.require_no_visit(m_function);
  const std::vector<Control_point> points = all_points(given);
  require_extent(points);
  if (!m_search || !m_search->is_for(points))
    m_search = std::make_unique<Search>(m_transformation, points, m_options);
  const Framed_surface& domain = m_transformation.domain();
  m_search->run(domain.frame().to_frame(targets_of(points)), options, m_visits.guarded(go_further));
  const auto& found = m_search->search().present();
  m_rho = {found.rho.on, found.rho.values / domain.unit()};
  Spin_result result;
  if (!m_search->search().costs().cancelled)
    result = m_transformation.integrate(found.solution.lambda);
  tell_search(*m_search, domain.unit(), result.report);
  add_costs(result.report, m_transformation.take_unreported());
  if (result.report.cancelled) return result;
  result.report.period_defect = m_search->period_defect();
  if (m_options.surface.scales.bound) result.report.scales = m_search->scales();
  place(points, result);
  if (m_region) {
    m_rho.values = m_region->in_whole(m_rho.values);
    result.positions = m_region->in_whole(result.positions);
    result.lambda = m_region->in_whole(result.lambda);
  }
  return result;
}

void Conformal_deformation::require_extent(const std::vector<Control_point>& points) const
{
  const double smallest = 1e-6;
  const Normalized_frame& frame = m_transformation.domain().frame();
  const Points from = frame.to_frame(positions_of(points, m_transformation.positions()));
  if (!(placement(from, frame.to_frame(targets_of(points))).scale > smallest))
    throw Precondition_error(m_function, "the targets are at one place, the points are not");
}

void Conformal_deformation::place(const std::vector<Control_point>& points,
                                  Spin_result& result) const
{
  const Framed_surface& domain = m_transformation.domain();
  const Eigen::Index anchors =
      m_region ? static_cast<Eigen::Index>(m_region->anchors().size()) : Eigen::Index{0};
  const Eigen::Index placed = anchors > 0 ? anchors : static_cast<Eigen::Index>(points.size());
  const Points f = domain.frame().to_frame(result.positions), targets = targets_of(points);
  const Alignment a = placement(positions_of(points, f).rightCols(placed),
                                domain.frame().to_frame(targets).rightCols(placed));
  result.positions = domain.frame().from_frame(a.apply(f));
  const Quaternion<double> turn = spin_of(a.rotation, a.scale);
  for (Eigen::Index i = 0; i < result.lambda.size(); ++i)
    result.lambda[i] = result.lambda[i] * turn;
  if (m_region) {
    m_region->fade(result.positions, result.lambda);
    result.report.collar = m_region->collar_conformality(result.positions, result.lambda);
  }
  certify(domain.measured(), domain.frame().to_frame(result.positions), result.lambda,
          result.report);
  const Eigen::RowVectorXd distances =
      (positions_of(points, result.positions) - targets).colwise().norm();
  result.report.position_error = {distances.mean(), distances.maxCoeff()};
}

}  // namespace Conformal_geometry_processing::internal
