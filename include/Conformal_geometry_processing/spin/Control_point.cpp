// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Control_point.h>

#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Quaternionic_linear_algebra/dense/hermitian_eigen_decomposition.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <cmath>
#include <cstddef>
#include <map>

namespace Conformal_geometry_processing::internal {

Control_point control_point(int vertex, const Eigen::Vector3d& target)
{
  return {{vertex}, Eigen::VectorXd::Ones(1), target};
}

// The point c + r a on an axis a is the combination with weights w (1 + <a, x - c> / r), where w
// are the shares of the area and r^2 is the mean of <a, x - c>^2.
std::vector<Control_point> region_control_points(const Mesh_view& mesh,
                                                 const std::vector<int>& vertices,
                                                 const Eigen::Affine3d& motion)
{
  const double flat = 1e-3;  // of the longest axis: a thinner region does not extend
  Eigen::VectorXd shares = vertex_areas(mesh)(vertices);
  shares /= shares.sum();
  const Points x = mesh.positions()(Eigen::indexing::all, vertices);
  const Eigen::Vector3d centre = x * shares;
  const Points arms = x.colwise() - centre;
  std::vector<Control_point> points = {{vertices, shares, motion * centre}};
  const auto axes =
      hermitian_eigen_decomposition<double>(arms * shares.asDiagonal() * arms.transpose());
  const Eigen::Vector3d radii = axes.values.cwiseMax(0).cwiseSqrt();
  for (Eigen::Index k = 2; k >= 0 && radii[k] > flat * radii[2]; --k) {
    const Eigen::Vector3d axis = axes.vectors.col(k);
    const Eigen::VectorXd heights = arms.transpose() * axis / radii[k];
    points.push_back({vertices, shares.cwiseProduct((heights.array() + 1).matrix()),
                      motion * Eigen::Vector3d(centre + radii[k] * axis)});
  }
  return points;
}

Points positions_of(const std::vector<Control_point>& points, const Points& positions)
{
  Points result(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t k = 0; k < points.size(); ++k)
    result.col(static_cast<Eigen::Index>(k)) =
        positions(Eigen::indexing::all, points[k].vertices) * points[k].weights;
  return result;
}

Points targets_of(const std::vector<Control_point>& points)
{
  Points targets(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t k = 0; k < points.size(); ++k)
    targets.col(static_cast<Eigen::Index>(k)) = points[k].target;
  return targets;
}

/// what is wrong with the point, empty if nothing
std::string fault(const Control_point& p, int size_of_vertices)
{
  const double rounding = 1e-9;
  if (p.vertices.empty()) return "has no vertices";
  for (int v : p.vertices)
    if (v < 0 || v >= size_of_vertices)
      return "is for vertex " + std::to_string(v) + ", but the mesh has " +
             std::to_string(size_of_vertices);
  if (p.weights.size() != static_cast<Eigen::Index>(p.vertices.size()) ||
      !(std::abs(p.weights.sum() - 1) <= rounding))
    return "has weights whose sum is not 1";
  return p.target.allFinite() ? "" : "has a position that is not finite";
}

void require_control_points(const std::vector<Control_point>& points, int size_of_vertices,
                            const std::string& function)
{
  if (points.empty()) throw Precondition_error(function, "there are no targets");
  std::map<int, std::size_t> first;  // of each vertex
  for (std::size_t k = 0; k < points.size(); ++k) {
    std::string what = fault(points[k], size_of_vertices);
    const int v = what.empty() ? points[k].vertices[0] : 0;
    if (what.empty() && points[k].vertices.size() == 1 && !first.emplace(v, k).second)
      what = "is for vertex " + std::to_string(v) + ", as is target " + std::to_string(first[v]);
    if (!what.empty())
      throw Precondition_error(function, "target " + std::to_string(k) + " " + what);
  }
}

}  // namespace Conformal_geometry_processing::internal
