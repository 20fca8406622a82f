// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Conformal_deformation.h>

#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/spin/Relaxed_positions.h>
#include <Quaternionic_linear_algebra/algebra/rotor.h>
#include <Quaternionic_linear_algebra/exceptions.h>
#include <Quaternionic_linear_algebra/threads/Thread_team.h>

#include <algorithm>
#include <set>
#include <utility>

namespace Conformal_geometry_processing {

namespace internal {

constexpr int most_anchors = 32;
constexpr double held_weight = .5;  // anchors are where weights are at most this

/// the faces with a vertex of positive weight
inline Mesh_component weighted_part(const Mesh_view& mesh, const Eigen::VectorXd& weights)
{
  std::vector<char> is_in_part;
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto& v = mesh.corners(f);
    is_in_part.push_back(weights[v[0]] > 0 || weights[v[1]] > 0 || weights[v[2]] > 0);
  }
  return selected_faces(mesh, is_in_part);
}

Eigen::VectorXd weights_at(const std::vector<Control_point>& points, const Mesh_view& mesh,
                           Eigen::VectorXd weights, const std::string& function)
{
  require_control_points(points, mesh.size_of_vertices(), function);
  if (weights.size() == 0) return weights;
  const Mesh_component part = weighted_part(mesh, weights);
  const std::vector<int> components = connected_components(part.mesh);
  std::vector<int> component_of(static_cast<std::size_t>(mesh.size_of_vertices()), -1);
  for (std::size_t k = 0; k < part.vertices.size(); ++k)
    component_of[static_cast<std::size_t>(part.vertices[k])] = components[k];
  std::set<int> kept;
  for (const Control_point& p : points)
    for (const int v : p.vertices) kept.insert(component_of[static_cast<std::size_t>(v)]);
  if (*kept.rbegin() < 0) return weights;  // all are outside
  for (const int v : part.vertices)
    if (kept.count(component_of[static_cast<std::size_t>(v)]) == 0) weights[v] = 0;
  return weights;
}

void require_region(const Mesh_view& mesh, const Eigen::VectorXd& weights,
                    const std::string& function)
{
  refuse_if_any(
      mesh.size_of_vertices(), [&](int v) { return !(weights[v] >= 0 && weights[v] <= 1); },
      name_of_vertex, function, "#vertex whose weight in the region is not in [0, 1]",
      "1: moves, 0: stays, between: the collar");
  if (!(weights.maxCoeff() == 1))
    throw Precondition_error(function, "no vertex has the weight 1 in the region");
}

}  // namespace internal

internal::Region_of_interest::Region_of_interest(const Mesh_view& mesh,
                                                 const Eigen::VectorXd& weights,
                                                 const std::string& function)
    : m_positions(mesh.positions())
{
  require_region(mesh, weights, function);
  m_part = weighted_part(mesh, weights);
  const std::vector<int> components = connected_components(m_part.mesh);
  const int count = *std::max_element(components.begin(), components.end()) + 1;
  if (count > 1)
    throw Precondition_error(function,
                             "the region has " + std::to_string(count) +
                                 " parts with targets that are not connected; deform each alone");
  m_weights = weights(m_part.vertices);
  m_shares = m_weights.array().square() * (3 - 2 * m_weights.array());
  m_in_part.assign(static_cast<std::size_t>(mesh.size_of_vertices()), -1);
  for (std::size_t k = 0; k < m_part.vertices.size(); ++k)
    m_in_part[static_cast<std::size_t>(m_part.vertices[k])] = static_cast<int>(k);
  choose_anchors();
}

// Each next one as far as possible from those before.
void internal::Region_of_interest::choose_anchors()
{
  const Points& p = m_part.mesh.positions();
  Eigen::Array<bool, 1, Eigen::Dynamic> is_held = (m_weights.array() <= held_weight).transpose();
  Eigen::RowVectorXd distances = (p.colwise() - p.rowwise().mean()).colwise().norm();
  for (int k = 0; k < most_anchors; ++k) {
    int next;
    distances = is_held.select(distances, -1.);
    if (!(distances.maxCoeff(&next) > 0)) return;
    m_anchors.push_back(control_point(next, p.col(next)));
    const Eigen::RowVectorXd others = (p.colwise() - p.col(next)).colwise().norm();
    distances = k == 0 ? others : Eigen::RowVectorXd(distances.cwiseMin(others));
  }
}

std::vector<internal::Control_point> internal::Region_of_interest::in_part(
    std::vector<Control_point> points, const std::string& function) const
{
  for (std::size_t k = 0; k < points.size(); ++k)
    for (int& v : points[k].vertices) {
      const int there = m_in_part[static_cast<std::size_t>(v)];
      if (there < 0 || m_weights[there] < 1)
        throw Precondition_error(function, "control point " + std::to_string(k) + " is at " +
                                               name_of_vertex(v) +
                                               ", which is outside of the region or in its collar");
      v = there;
    }
  return points;
}

// Of the two signs of lambda, the one nearer to 1, on average over the collar.
void internal::Region_of_interest::fade(Points& positions, Quaternion_vector<double>& lambda) const
{
  const auto& p = m_part.mesh.positions();
  const Eigen::VectorXd real = components(lambda).row(0).transpose();
  const double sign = real.dot((1 - m_shares.array()).matrix()) < 0 ? -1 : 1;
  for (Eigen::Index v = 0; v < lambda.size(); ++v) {
    const double s = m_shares[v];
    if (s == 0) positions.col(v) = p.col(v);
    if (s > 0 && s < 1) positions.col(v) = p.col(v) + s * (positions.col(v) - p.col(v));
    lambda[v] = (1 - s) * Quaternion<double>{1, 0, 0, 0} + (sign * s) * lambda[v];
  }
}

std::optional<Conformality> internal::Region_of_interest::collar_conformality(
    const Points& positions, const Quaternion_vector<double>& lambda) const
{
  if (m_weights.minCoeff() == 1) return std::nullopt;
  std::vector<char> is_in_collar;
  for (int f = 0; f < mesh().size_of_faces(); ++f) {
    const auto& v = mesh().corners(f);
    is_in_collar.push_back(m_weights[v[0]] < 1 || m_weights[v[1]] < 1 || m_weights[v[2]] < 1);
  }
  const Mesh_component collar = selected_faces(mesh(), is_in_collar);
  const Points there = positions(Eigen::indexing::all, collar.vertices);
  return conformality(collar.mesh, there,
                      rotated_normals(collar.mesh, lambda(collar.vertices).eval()));
}

Points internal::Region_of_interest::in_whole(const Points& positions) const
{
  Points all = m_positions;
  all(Eigen::indexing::all, vertices()) = positions;
  return all;
}

Quaternion_vector<double> internal::Region_of_interest::in_whole(
    const Quaternion_vector<double>& lambda) const
{
  Quaternion_vector<double> all =
      Quaternion_vector<double>::Constant(m_positions.cols(), {1, 0, 0, 0});
  all(vertices()) = lambda;
  return all;
}

Eigen::VectorXd internal::Region_of_interest::in_whole(const Eigen::VectorXd& numbers) const
{
  Eigen::VectorXd all = Eigen::VectorXd::Zero(m_positions.cols());
  all(vertices()) = numbers;
  return all;
}

namespace internal {

/// whether these are the same points, with whatever targets
bool are_same(const std::vector<Control_point>& points, const std::vector<Control_point>& others)
{
  const auto is_same = [](const Control_point& a, const Control_point& b) {
    return a.vertices == b.vertices && a.weights == b.weights;
  };
  return std::equal(points.begin(), points.end(), others.begin(), others.end(), is_same);
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

struct Conformal_deformation::Search : Relaxed_positions {
  Search(Transformation& transformation, Problem problem, const Points& targets)
      : Relaxed_positions(transformation, std::move(problem), targets), initial(state())
  {}

  const State initial;  // of the surface that is deformed
};

Conformal_deformation::Conformal_deformation(const Mesh_view& mesh,
                                             const Conformal_deformation_options& options,
                                             const std::string& function)
    : m_function(function), m_mesh(mesh), m_given(options)
{
  if (options.surface.boundary.kind != Boundary_condition::Kind::free)
    throw Precondition_error(function, "the boundary has to be free");
  if (!(options.position_weight > 0))
    throw Precondition_error(function, "the position weight is not positive");
  if (options.region.size() == 0)
    set_region({});
  else
    require_region(mesh, options.region, function);
}

Conformal_deformation::~Conformal_deformation() = default;

// Which parts move is known from the control points only.
void Conformal_deformation::set_region(Eigen::VectorXd weights)
{
  if (m_transformation && weights.size() == m_weights.size() && weights == m_weights) return;
  m_positions.reset();
  m_transformation.reset();
  m_region.reset();
  m_weights = std::move(weights);
  if (m_weights.size() > 0) m_region.emplace(m_mesh, m_weights, m_function);
  m_options = options_in(m_region, m_given);
  m_transformation.emplace(m_region ? m_region->mesh() : m_mesh, m_options.surface, m_function);
}

std::vector<Control_point> Conformal_deformation::all_points(
    const std::vector<Control_point>& points) const
{
  if (!m_region) return points;
  std::vector<Control_point> all = m_region->in_part(points, m_function);
  all.insert(all.end(), m_region->anchors().begin(), m_region->anchors().end());
  return all;
}

Spin_result Conformal_deformation::deform(const std::vector<Control_point>& given,
                                          const Go_further& go_further)
{
  const internal::Thread_team team;
  m_visits.require_no_visit(m_function);
  set_region(weights_at(given, m_mesh, m_given.region, m_function));
  const std::vector<Control_point> points = all_points(given);
  require_extent(points);
  Walk walk = search(points, m_visits.guarded(go_further));
  Spin_result result = walk.result ? std::move(*walk.result) : present(points, walk.reached);
  m_rho = Curvature_potential::on_vertices(m_positions->scales().spins().rho() /
                                           m_transformation->domain().unit());
  Spin_report& r = result.report;
  r.cancelled = walk.is_cancelled;
  r.reached = r.realised_share = walk.reached;
  r.limits.realised_share = 1;
  r.steps = walk.steps;
  add_costs(r, m_transformation->take_unreported());
  if (r.cancelled) {
    result.positions.resize(3, 0);
    return result;
  }
  if (m_region) {
    m_rho.values = m_region->in_whole(m_rho.values);
    result.positions = m_region->in_whole(result.positions);
    result.lambda = m_region->in_whole(result.lambda);
  }
  return result;
}

auto Conformal_deformation::search(const std::vector<Control_point>& points,
                                   const Go_further& go_further) -> Walk
{
  const Points targets = m_transformation->domain().frame().to_frame(targets_of(points));
  const bool has_run = m_positions && are_same(points, m_positions->points());
  if (!has_run) {
    const double w = m_options.position_weight;
    const Eigen::VectorXd no_rho = Eigen::VectorXd::Zero(m_transformation->system().areas().size());
    m_positions = std::make_unique<Search>(
        *m_transformation,
        Relaxed_positions::Problem{
            points, {}, no_rho, m_options.surface.scales, w * w, number_of_anchors()},
        targets);
  }
  m_positions->reset_costs();
  m_positions->renew_budget();
  Walk found = walk(points, go_further);
  if (!has_run || found.reached == 1 || found.is_cancelled) return found;
  m_positions->restart(m_positions->initial);
  return walk(points, go_further);
}

auto Conformal_deformation::walk(const std::vector<Control_point>& points,
                                 const Go_further& go_further) -> Walk
{
  const Points targets = m_transformation->domain().frame().to_frame(targets_of(points));
  const Points from = m_positions->present_points();
  const Alignment a = placement(from, targets);
  const Points to = a.rotation.transpose() * (targets.colwise() - a.translation) / a.scale;
  Walk walk;
  for (double step = 1; walk.reached < 1 && step >= m_options.min_step && !walk.is_cancelled;) {
    const double rest = 1 - walk.reached - step, share = rest < m_options.min_step ? 1 : 1 - rest;
    m_positions->set_targets(from + share * (to - from));
    if (!go_to(points, share, walk, go_further) && !m_positions->loosen()) step /= 2;
  }
  return walk;
}

bool Conformal_deformation::go_to(const std::vector<Control_point>& points, double share,
                                  Walk& walk, const Go_further& go_further)
{
  const Relaxed_positions::State before = m_positions->state();
  walk.result.reset();
  walk.is_cancelled = m_positions->go_on(go_further) == Relaxed_scales::End::cancelled;
  if (walk.is_cancelled) return false;
  if (m_positions->is_met()) {
    Spin_result there = present(points, share);
    if (there.report && there.report.conformality.flipped_faces == 0) {
      walk.result = std::move(there);
      walk.reached = share;
      ++walk.steps;
      return true;
    }
  }
  m_positions->restart(before);
  return false;
}

void Conformal_deformation::require_extent(const std::vector<Control_point>& points) const
{
  const double smallest = 1e-6;
  const Normalized_frame& frame = m_transformation->domain().frame();
  const Points from = frame.to_frame(positions_of(points, m_transformation->positions()));
  if (!(placement(from, frame.to_frame(targets_of(points))).scale > smallest))
    throw Precondition_error(m_function, "the targets are at one place, the points are not");
}

Spin_result Conformal_deformation::present(const std::vector<Control_point>& points,
                                           double share) const
{
  return m_positions->present(
      [&](Spin_result& result) { place(points, m_region ? share : 1, result); });
}

void Conformal_deformation::place(const std::vector<Control_point>& points, double share,
                                  Spin_result& result) const
{
  const Framed_surface& domain = m_transformation->domain();
  const double slack = 1e-10;  // of the squares of distances of anchors: targets are met first
  Eigen::VectorXd masses = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(points.size()));
  masses.tail(static_cast<Eigen::Index>(number_of_anchors())).setConstant(slack);
  const Points f = domain.frame().to_frame(result.positions), targets = targets_of(points);
  const Points from = positions_of(points, m_transformation->positions());
  const Alignment a = placement(positions_of(points, f),
                                domain.frame().to_frame(from + share * (targets - from)), masses);
  result.positions = domain.frame().from_frame(a.apply(f));
  const Quaternion<double> turn = spin_of(a.rotation, a.scale);
  for (Eigen::Index i = 0; i < result.lambda.size(); ++i)
    result.lambda[i] = result.lambda[i] * turn;
  if (m_region) {
    m_region->fade(result.positions, result.lambda);
    result.report.collar = m_region->collar_conformality(result.positions, result.lambda);
  }
  const Eigen::RowVectorXd distances =
      (positions_of(points, result.positions) - targets)
          .leftCols(targets.cols() - static_cast<Eigen::Index>(number_of_anchors()))
          .colwise()
          .norm();
  result.report.position_error = {distances.mean(), distances.maxCoeff()};
}

}  // namespace internal

}  // namespace Conformal_geometry_processing
