// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/distortion.h>

#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Quaternionic_linear_algebra/threads/Thread_team.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

// The first part ends so that upper quantiles are most likely in the few values beyond it.
double weighted_quantile(const Eigen::VectorXd& values, const Eigen::VectorXd& weights,
                         double share)
{
  std::vector<std::pair<double, double>> pairs;  // side by side, as halving reads them often
  pairs.reserve(static_cast<std::size_t>(values.size()));
  for (Eigen::Index i = 0; i < values.size(); ++i) pairs.emplace_back(values[i], weights[i]);
  const double wanted = share * weights.sum();
  double below = 0;  // the weight before `first`; the quantile is in [first, last)
  double part = (std::max)(.5, 2 * share - 1);
  auto first = pairs.begin(), last = pairs.end();
  for (; last - first > 1; part = .5) {
    const auto size = last - first;
    const auto middle =
        first + std::clamp(static_cast<std::ptrdiff_t>(part * static_cast<double>(size)),
                           std::ptrdiff_t{1}, size - 1);
    std::nth_element(first, middle, last);
    const double weight = std::accumulate(
        first, middle, 0., [](double sum, const auto& pair) { return sum + pair.second; });
    if (below + weight >= wanted) {
      last = middle;
    } else {
      below += weight;
      first = middle;
    }
  }
  return first->first;
}

}  // namespace internal

internal::Distribution distribution(const Eigen::VectorXd& values, const Eigen::VectorXd& weights)
{
  if (values.size() == 0) return {};
  return {values.dot(weights) / weights.sum(), internal::weighted_quantile(values, weights, 0.99),
          values.maxCoeff()};
}

Eigen::VectorXd histogram(const Eigen::VectorXd& values, const Eigen::VectorXd& weights, int bins,
                          double low, double high)
{
  Eigen::VectorXd share = Eigen::VectorXd::Zero(bins);
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const double t = (values[i] - low) / (high - low) * bins;
    share[t > 0 ? static_cast<Eigen::Index>((std::min)(t, bins - 1.)) : 0] += weights[i];
  }
  return share / weights.sum();
}

namespace internal {

/// a triangle laid out in the plane, at (0, 0), (length, 0) and (x, y), y >= 0
struct Flat_triangle {
  double length, x, y, area;

  Flat_triangle(const Points& positions, const std::array<int, 3>& corners)
  {
    const Eigen::Vector3d u = positions.col(corners[1]) - positions.col(corners[0]);
    const Eigen::Vector3d v = positions.col(corners[2]) - positions.col(corners[0]);
    const double parallelogram = u.cross(v).norm();
    length = u.norm();
    x = u.dot(v) / length;
    y = parallelogram / length;
    area = parallelogram / 2;
  }
};

/// the ratio of the singular values of the linear map between two triangles
double quasi_conformal_error(const Flat_triangle& s, const Flat_triangle& t)
{
  // The map is the upper triangular matrix (a b; 0 d).
  const double a = t.length / s.length, b = (t.x - a * s.x) / s.y, d = t.y / s.y;
  const double sum = a + d, difference = a - d;
  const double largest =
      (std::sqrt(sum * sum + b * b) + std::sqrt(difference * difference + b * b)) / 2;
  const double Q = largest / (a * d / largest);  // the smaller one from the determinant: no
                                                 // cancellation
  return std::isnan(Q) ? HUGE_VAL : Q;
}

Face_maps::Face_maps(const Mesh_view& mesh, const Points& positions)
    : quasi_conformal(mesh.size_of_faces()),
      areas(mesh.size_of_faces()),
      new_areas(mesh.size_of_faces())
{
  for_each_index(mesh.size_of_faces(), 512, [&](int f) {
    const Flat_triangle s(mesh.positions(), mesh.corners(f)), t(positions, mesh.corners(f));
    quasi_conformal[f] = quasi_conformal_error(s, t);
    areas[f] = s.area;
    new_areas[f] = t.area;
  });
}

Eigen::VectorXd Face_maps::length_scales() const
{
  return new_areas.cwiseQuotient(areas).cwiseSqrt();
}

}  // namespace internal

Eigen::VectorXd quasi_conformal_errors(const Mesh_view& mesh, const Points& positions)
{
  return internal::Face_maps(mesh, positions).quasi_conformal;
}

internal::Distribution quasi_conformal_error(const Mesh_view& mesh, const Points& positions)
{
  const internal::Face_maps maps(mesh, positions);
  return distribution(maps.quasi_conformal, maps.areas);
}

Eigen::VectorXd length_scales(const Mesh_view& mesh, const Points& positions)
{
  return internal::Face_maps(mesh, positions).length_scales();
}

namespace internal {

double collapsed_share(const Eigen::VectorXd& octaves, const Face_maps& maps)
{
  const double limit = std::log2(10.);
  const auto shrank = octaves.array() < -limit;
  const auto grew = octaves.array() > limit;
  return (std::max)(shrank.select(maps.areas.array(), 0).sum() / maps.areas.sum(),
                    grew.select(maps.new_areas.array(), 0).sum() / maps.new_areas.sum());
}

Area_distortion area_distortion(const Face_maps& maps)
{
  const Eigen::VectorXd scale = maps.length_scales(), u = scale.array().log();
  const Eigen::VectorXd& areas = maps.areas;
  const double mean = areas.dot(u) / areas.sum();
  const double variance = areas.dot((u.array() - mean).square().matrix()) / areas.sum();
  // the root mean square, which keeps the total area
  const double usual = std::log(maps.new_areas.sum() / areas.sum()) / 2;
  const Eigen::VectorXd octaves = (u.array() - usual) / std::log(2.);
  Area_distortion d{scale.minCoeff(), scale.maxCoeff(), std::sqrt(variance),
                    collapsed_share(octaves, maps)};
  d.histogram =
      histogram(octaves, areas, static_cast<int>(d.histogram.size()), -d.octaves, d.octaves);
  return d;
}

/// of the logarithms of the lengths of edges
Eigen::VectorXd log_cross_ratios(const Mesh_view& mesh, const Eigen::VectorXd& lengths)
{
  Eigen::VectorXd ratio = Eigen::VectorXd::Zero(mesh.size_of_edges());
  for (int h = 0; h < mesh.size_of_halfedges(); ++h)
    if (mesh.twin(h) >= 0)  // both sides contribute the same quotient l_jk / l_ki
      ratio[mesh.edge(h)] += lengths[mesh.edge(Mesh_view::next_in_face(h))] -
                             lengths[mesh.edge(Mesh_view::previous_in_face(h))];
  return ratio;
}

double squared_length(const Mesh_view& mesh, const Points& positions, int edge)
{
  const auto [i, j] = mesh.ends(edge);
  return (positions.col(j) - positions.col(i)).squaredNorm();
}

}  // namespace internal

internal::Area_distortion area_distortion(const Mesh_view& mesh, const Points& positions)
{
  return internal::area_distortion(internal::Face_maps(mesh, positions));
}

Eigen::VectorXd log_length_cross_ratios(const Mesh_view& mesh, const Points& positions)
{
  Eigen::VectorXd log_length(mesh.size_of_edges());
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    log_length[k] = std::log(internal::squared_length(mesh, positions, k)) / 2;
  return internal::log_cross_ratios(mesh, log_length);
}

// The logarithm of the ratio of both cross-ratios is the cross-ratio of the stretched lengths.
internal::Length_cross_ratio_change length_cross_ratio_change(const Mesh_view& mesh,
                                                              const Points& positions)
{
  Eigen::VectorXd log_stretch(mesh.size_of_edges());
  internal::for_each_index(mesh.size_of_edges(), 1024, [&](int k) {
    log_stretch[k] = std::log(internal::squared_length(mesh, positions, k) /
                              internal::squared_length(mesh, mesh.positions(), k)) /
                     2;
  });
  int interior = 0;
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    interior += mesh.halfedges_end(k) - mesh.halfedges_begin(k) == 2;
  if (interior == 0) return {};
  const Eigen::VectorXd change = internal::log_cross_ratios(mesh, log_stretch);
  return {change.norm() / std::sqrt(interior), change.cwiseAbs().maxCoeff()};
}

Points neighbourhood_normals(const Mesh_view& mesh)
{
  const Points at_vertices = vertex_normals(mesh, internal::Normal_weight::area);
  Points normals(3, mesh.size_of_faces());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto& v = mesh.corners(f);
    normals.col(f) = at_vertices.col(v[0]) + at_vertices.col(v[1]) + at_vertices.col(v[2]);
  }
  return normals;
}

Points neighbourhood_normals(const Mesh_view& before, const Points& positions)
{
  Mesh_view after = before;
  after.set_positions(positions);
  const Points old_normals = neighbourhood_normals(before);
  Points normals = neighbourhood_normals(after);
  for (int f = 0; f < before.size_of_faces(); ++f) {
    const double side = before.double_area_vector(f).dot(old_normals.col(f));
    if (side < 0) normals.col(f) *= -1;
    if (side == 0) normals.col(f) = after.double_area_vector(f);
  }
  return normals;
}

int flipped_faces(const Mesh_view& mesh, const Points& positions, const Points& expected)
{
  int count = 0;
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    count += !(mesh.double_area_vector(f, positions).dot(expected.col(f)) > 0);
  return count;
}

}  // namespace Conformal_geometry_processing
