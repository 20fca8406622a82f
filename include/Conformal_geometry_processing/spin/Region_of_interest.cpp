// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Region_of_interest.h>

#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/spin/certify.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <set>

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

}  // namespace Conformal_geometry_processing
