// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/curves/close_polygon.h>

#include <Conformal_geometry_processing/curves/integrate_curvature.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <cmath>

namespace Conformal_geometry_processing {
namespace internal {

Eigen::Vector2d end_to_end(const Plane_points& tangents, Plane_points& points)
{
  Eigen::Vector2d p = tangents.col(0);
  for (Eigen::Index i = 1; i < tangents.cols(); ++i) {
    points.col(i) = p;
    p += tangents.col(i);
  }
  points.col(0) = p;
  return p;
}

void correct_curvatures(const Eigen::Vector2d& gap, double turning, const Plane_points& points,
                        const Closing_functions& functions, const Plane_points& shape,
                        const Polygon_lengths& lengths, Eigen::VectorXd& curvatures)
{
  // Turning at vertex i by d_i k_i rotates the end p about f_i: the gap changes by
  // J (p - f_i) d_i k_i. The change is therefore determined by the moments d_i k_i (1, f_i); p,
  // whose distance from 0 is the gap, contributes to second order only.
  const Eigen::VectorXd& d = lengths.duals();
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (Eigen::Index i = 0; i < d.size(); ++i)
    moments += d[i] * Eigen::Vector3d(1, points(0, i), points(1, i)) *
               functions.values(shape.col(i)).transpose();
  const Eigen::Vector3d wanted(turning - d.dot(curvatures), gap.y(), -gap.x());
  const Eigen::Vector3d share = moments.fullPivLu().solve(wanted);
  for (Eigen::Index i = 0; i < d.size(); ++i)
    curvatures[i] += share.dot(functions.values(shape.col(i)));
}

}  // namespace internal

internal::Closing_result close_polygon(const internal::Polygon_lengths& lengths, int turning_number,
                                       double angle, const internal::Plane_points& shape,
                                       Eigen::VectorXd& curvatures,
                                       internal::Plane_points& tangents,
                                       internal::Plane_points& points)
{
  constexpr int max_iterations = 20;
  constexpr double tolerance = 1e-13;
  const double turning = turning_number * two_pi;
  const internal::Closing_functions functions(shape, lengths.duals());
  points.resize(2, lengths.size_of_vertices());
  internal::Closing_result result;
  for (; result.iterations <= max_iterations; ++result.iterations) {
    integrate_curvature(curvatures, lengths, angle, tangents);
    const Eigen::Vector2d gap = internal::end_to_end(tangents, points);
    const double excess = std::abs(lengths.duals().dot(curvatures) - turning);
    result.gap = gap.norm() / lengths.total();
    if (result.iterations == 0) result.first_gap = result.gap;
    result.is_closed = result.gap <= tolerance && excess <= tolerance * two_pi;
    if (result.is_closed || !std::isfinite(result.gap)) break;
    internal::correct_curvatures(gap, turning, points, functions, shape, lengths, curvatures);
  }
  return result;
}

}  // namespace Conformal_geometry_processing
