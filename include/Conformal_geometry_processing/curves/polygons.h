// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Core>

#include <string>

namespace Conformal_geometry_processing {
namespace internal {

/// One point or vector of the plane per column
using Plane_points = Eigen::Matrix2Xd;

/// \brief The lengths of the edges of a polygon, and of the dual edges of its vertices.
///
/// Edge i runs from vertex i to the next one, the last edge of a closed polygon to vertex 0; an
/// open polygon has one edge less than vertices. The dual edge of a vertex consists of half of each
/// incident edge. An isometric flow preserves these lengths and computes them only once. O(m).
class Polygon_lengths {
 public:
  Polygon_lengths() = default;

  /// \param points the vertices, 2 x m, m > 1
  Polygon_lengths(const Plane_points& points, bool is_closed);

  bool is_closed() const { return m_is_closed; }
  Eigen::Index size_of_vertices() const { return m_duals.size(); }
  Eigen::Index size_of_edges() const { return m_edges.size(); }

  const Eigen::VectorXd& edges() const { return m_edges; }
  const Eigen::VectorXd& duals() const { return m_duals; }

  /// Length of the whole polygon
  double total() const { return m_total; }

 private:
  Eigen::VectorXd m_edges, m_duals;
  double m_total = 0;
  bool m_is_closed = true;
};

}  // namespace internal

/// \ingroup PkgCurves
/// Returns the maximal relative change of the length of an edge
double length_distortion(const internal::Plane_points& points,
                         const internal::Polygon_lengths& original);

/// \ingroup PkgCurves
/// \brief Computes the turning angle at each vertex of a polygon: in (-pi, pi], positive to the
/// left. O(m).
///
/// The sum over a closed polygon is its turning number times 2 pi, up to rounding. If an edge
/// reverses its direction, the sign is arbitrary; `require_polygon()` rejects this case.
/// \param points the vertices, 2 x m, m > 2
/// \param angles receives m numbers, zero at the ends of an open polygon
void turning_angles(const internal::Plane_points& points, bool is_closed, Eigen::VectorXd& angles);

/// \relates turning_angles
Eigen::VectorXd turning_angles(const internal::Plane_points& points, bool is_closed);

/// A full turn
inline constexpr double two_pi = 6.283185307179586476925286766559;

/// \ingroup PkgCurves
/// \brief Returns the turning number of a closed polygon, counterclockwise: 1 for a convex one, 0
/// for a figure eight [CGP 4.2].
/// \param angles of `turning_angles()`
int turning_number(const Eigen::VectorXd& angles);

/// \ingroup PkgCurves
/// \brief Returns the bending energy, the integral of the squared curvature, sum kappa^2 d
/// [CGP 6.4.3].
///
/// In 1/length; its product with the length of the curve is scale-invariant, and 4 pi^2 k^2 for a
/// k-fold circle.
/// \param curvatures the turning angles divided by the dual lengths, one per vertex
double bending_energy(const Eigen::VectorXd& curvatures, const internal::Polygon_lengths& lengths);

namespace internal {

/// \brief Normalized coordinates of curve flows: `Normalized_frame` in the plane, which makes
/// results independent of the unit of length and of a distant origin.
class Curve_frame {
 public:
  /// \pre `points` is not empty and finite
  explicit Curve_frame(const Plane_points& points) : m_frame(in_space(points)) {}

  /// The unit of the frame in units of the curve, a power of two
  double unit() const { return m_frame.unit(); }

  Plane_points to_frame(const Plane_points& points) const;

  /// Transforms points from the frame to the curve, in the memory of `result`
  void from_frame(const Plane_points& points, Plane_points& result) const;

 private:
  static Points in_space(const Plane_points& points);

  Normalized_frame m_frame;
};

}  // namespace internal

/// An edge is rejected if it is shorter than this fraction of the whole polygon, because its
/// direction is then determined by the rounding of the coordinates
constexpr double relative_length_tolerance = 1e-14;

/// A turn is rejected if it differs from a half turn by less than this angle, because its sign is
/// then determined by the rounding of the coordinates
constexpr double half_turn_tolerance = 1e-10;

/// \ingroup PkgCurves
/// Requires at least three points with finite coordinates, none equal to the next one, and no turn
/// by +-pi
/// \param points 2 x m
/// \throw Precondition_error naming `function` and the first point that breaks a rule
void require_polygon(const internal::Plane_points& points, bool is_closed,
                     const std::string& function);

}  // namespace Conformal_geometry_processing
