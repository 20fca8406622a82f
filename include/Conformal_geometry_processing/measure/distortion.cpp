// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/distortion.h>

#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Quaternionic_linear_algebra/threads/Thread_team.h>

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

// The range is halved, and what is outside given up, until one value is left.
double weighted_quantile(const Eigen::VectorXd& values, const Eigen::VectorXd& weights,
                         double share, const Surface_part& part)
{
  std::vector<std::pair<double, double>> left;  // side by side, as halving reads them often
  left.reserve(static_cast<std::size_t>(values.size()));
  for (Eigen::Index i = 0; i < values.size(); ++i) left.emplace_back(values[i], weights[i]);
  const double wanted = share * part.sum(weights.sum());
  double below = 0, low = part.smallest(values), high = part.largest(values);
  while (low < high) {
    const double middle = (std::min)(low / 2 + high / 2, std::nextafter(high, low));
    const auto upper = std::partition(left.begin(), left.end(),
                                      [&](const auto& pair) { return pair.first <= middle; });
    const double half = part.sum(std::accumulate(
        left.begin(), upper, 0., [](double sum, const auto& pair) { return sum + pair.second; }));
    if (below + half >= wanted) {
      left.erase(upper, left.end());
    } else {
      below += half;
      left.erase(left.begin(), upper);
    }
    Eigen::VectorXd ends;  // none where this part has no value left
    if (const auto [least, most] = std::minmax_element(left.begin(), left.end()); !left.empty())
      ends = Eigen::Vector2d(least->first, most->first);
    low = part.smallest(ends);
    high = part.largest(ends);
  }
  return high;
}

/// the weight in each of the intervals of `histogram()`
Eigen::VectorXd weights_of_bins(const Eigen::VectorXd& values, const Eigen::VectorXd& weights,
                                int bins, double low, double high)
{
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(bins);
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const double t = (values[i] - low) / (high - low) * bins;
    sums[t > 0 ? static_cast<Eigen::Index>((std::min)(t, bins - 1.)) : 0] += weights[i];
  }
  return sums;
}

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

Face_maps::Face_maps(const Mesh_view& mesh, const Points& positions, const Surface_part& part)
    : quasi_conformal(part.own_faces(mesh.size_of_faces())),
      areas(quasi_conformal.size()),
      new_areas(quasi_conformal.size())
{
  for_each_index(static_cast<int>(areas.size()), 512, [&](int f) {
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

internal::Distribution distribution(const Eigen::VectorXd& values, const Eigen::VectorXd& weights,
                                    const internal::Surface_part& part)
{
  const Eigen::Vector3d sums = part.sum(
      Eigen::Vector3d(values.dot(weights), weights.sum(), static_cast<double>(values.size())));
  if (sums[2] == 0) return {};
  return {sums[0] / sums[1], internal::weighted_quantile(values, weights, 0.99, part),
          part.largest(values)};
}

Eigen::VectorXd histogram(const Eigen::VectorXd& values, const Eigen::VectorXd& weights, int bins,
                          double low, double high)
{
  return internal::weights_of_bins(values, weights, bins, low, high) / weights.sum();
}

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

Area_distortion area_distortion(const Face_maps& maps, const Surface_part& part)
{
  const Eigen::VectorXd scale = maps.length_scales(), u = scale.array().log();
  const Eigen::VectorXd &areas = maps.areas, &now = maps.new_areas;
  const Eigen::Vector3d sums = part.sum(Eigen::Vector3d(areas.sum(), now.sum(), areas.dot(u)));
  const double mean = sums[2] / sums[0];
  // the root mean square, which keeps the total area
  const double usual = std::log(sums[1] / sums[0]) / 2, limit = std::log2(10.);
  const Eigen::ArrayXd octaves = (u.array() - usual) / std::log(2.);
  Area_distortion d;
  Eigen::VectorXd shares(3 + d.histogram.size());
  shares << areas.dot((u.array() - mean).square().matrix()),
      (octaves < -limit).select(areas.array(), 0).sum(),
      (octaves > limit).select(now.array(), 0).sum(),
      weights_of_bins(octaves, areas, static_cast<int>(d.histogram.size()), -d.octaves, d.octaves);
  shares = part.sum(shares);
  d.min_scale = part.smallest(scale);
  d.max_scale = part.largest(scale);
  d.log_deviation = std::sqrt(shares[0] / sums[0]);
  d.collapsed_share = (std::max)(shares[1] / sums[0], shares[2] / sums[1]);
  d.histogram = shares.tail(d.histogram.size()) / sums[0];
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
                                                              const Points& positions,
                                                              const internal::Surface_part& part)
{
  Eigen::VectorXd log_stretch(mesh.size_of_edges());
  internal::for_each_index(mesh.size_of_edges(), 1024, [&](int k) {
    log_stretch[k] = std::log(internal::squared_length(mesh, positions, k) /
                              internal::squared_length(mesh, mesh.positions(), k)) /
                     2;
  });
  const Eigen::VectorXd change = internal::log_cross_ratios(mesh, log_stretch);
  Eigen::Vector2d sums(0, 0);
  double most = 0;
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    if (part.counts(k) && mesh.halfedges_end(k) - mesh.halfedges_begin(k) == 2) {
      sums += Eigen::Vector2d(change[k] * change[k], 1);
      most = (std::max)(most, std::abs(change[k]));
    }
  sums = part.sum(sums);
  if (sums[1] == 0) return {};
  return {std::sqrt(sums[0] / sums[1]), part.largest(Eigen::VectorXd::Constant(1, most))};
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

int flipped_faces(const Mesh_view& mesh, const Points& positions, const Points& expected,
                  const internal::Surface_part& part)
{
  int count = 0;
  for (int f = 0; f < part.own_faces(mesh.size_of_faces()); ++f)
    count += !(mesh.double_area_vector(f, positions).dot(expected.col(f)) > 0);
  return static_cast<int>(part.sum(count));
}

}  // namespace Conformal_geometry_processing
