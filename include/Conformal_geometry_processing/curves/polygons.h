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

/// \brief The functions 1, f^x, f^y on the vertices of a curve f, orthogonalized: a change of
/// curvature that is orthogonal to them keeps the curve closed, to first order [CGP 4.2].
///
/// They are 1 and the coordinates along the principal axes of the curve, so they depend neither on
/// its position nor on its first vertex. O(m).
class Closing_functions {
 public:
  /// \param points 2 x m \param weights of the inner product: the dual lengths, m positive numbers
  Closing_functions(const Plane_points& points, const Eigen::VectorXd& weights);

  /// Returns the three functions at a point
  Eigen::Vector3d values(const Eigen::Vector2d& point) const;

  /// Returns the linear combination of the three functions that has these inner products with them
  Eigen::Vector3d combination(const Eigen::Vector3d& products) const;

 private:
  Eigen::Vector2d m_mean, m_axis;
  Eigen::Vector3d m_norms;  // squared
};

/// \brief A compensated running sum of vectors of the plane, accurate to one rounding.
///
/// The vertices of a polygon are such sums of its edges. Without compensation, their rounding
/// errors grow with the number of edges, and accumulate in the edge that closes the polygon.
class Compensated_sum {
 public:
  void add(const Eigen::Vector2d& x);

  Eigen::Vector2d value() const { return m_sum + m_lost; }

 private:
  Eigen::Vector2d m_sum = Eigen::Vector2d::Zero(), m_lost = Eigen::Vector2d::Zero();
};

/// Result of closing a polygon
struct Closing_result {
  double first_gap = 0;  ///< between its ends before, relative to its length
  double gap = 0;        ///< likewise, afterwards
  int iterations = 0;    ///< of Newton's method
  bool is_closed = false;
};

/// Returns the gap of the edges, and computes the vertices; the last edge ends at the first vertex,
/// as required by the derivative of the gap.
Eigen::Vector2d end_to_end(const Plane_points& tangents, Plane_points& points);

/// One step of Newton's method: changes the curvature by a combination of the functions at the
/// vertices of `shape`, such that to first order the gap is closed and the total turning is
/// `turning`.
void correct_curvatures(const Eigen::Vector2d& gap, double turning, const Plane_points& points,
                        const Closing_functions& functions, const Plane_points& shape,
                        const Polygon_lengths& lengths, Eigen::VectorXd& curvatures);

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

/// \ingroup PkgCurves
/// \brief Computes the polygon whose edges are closest to given ones: it minimizes
/// sum |f_{i+1} - f_i - T_i|^2 / l_i [CGP 6.4.3].
///
/// For a closed polygon this is the solution of the Poisson equation L f = b, where L is cyclic
/// and tridiagonal with -1/l_i off its diagonal, and b_i = T_{i-1}/l_{i-1} - T_i/l_i (the thesis
/// has b with the opposite sign, which gives -f). In the unknowns q_i = (f_{i+1} - f_i)/l_i it
/// reads q_i - q_{i-1} = T_i/l_i - T_{i-1}/l_{i-1}: the q_i equal T_i/l_i up to a constant, which
/// is determined by the closing condition. Each edge therefore takes a share of the gap in
/// proportion to its length. Two passes solve the equation in O(m), without the cancellation of an
/// elimination, whose matrix has a condition number of order m^2. Every vertex is accurate to one
/// rounding of its coordinates.
///
/// \param tangents an edge per column \param points receives the vertices, the first one at 0
/// \returns the sum of the edges of a closed polygon: the gap that was distributed
Eigen::Vector2d integrate_tangents(const internal::Plane_points& tangents,
                                   const internal::Polygon_lengths& lengths,
                                   internal::Plane_points& points);

/// \ingroup PkgCurves
/// \brief Computes the edges of the polygon with these curvatures and lengths [CGP 6.4.3]:
/// T_i = l_i (cos theta_i, sin theta_i), theta_i = theta_{i-1} + d_i kappa_i. O(m).
///
/// Lengths are exact up to rounding, but the sum of the edges need not be zero. The curvature at
/// vertex 0 is not used: it turns the last edge of a closed polygon into the first.
/// \param curvatures one per vertex \param angle of edge 0, theta_0
/// \param tangents receives an edge per column, 2 x number of edges
void integrate_curvature(const Eigen::VectorXd& curvatures,
                         const internal::Polygon_lengths& lengths, double angle,
                         internal::Plane_points& tangents);

/// \ingroup PkgCurves
/// \brief Changes curvatures by a combination of 1, f^x and f^y such that the polygon with given
/// lengths closes, with a given turning number: Newton's method for these three equations. O(m)
/// per iteration; few iterations are needed.
///
/// \param turning_number of the closed polygon \param angle of edge 0
/// \param shape the vertices f of a similar closed polygon, 2 x m
/// \param curvatures one per vertex; they close the polygon afterwards, if the result says so
/// \param tangents receives its edges, 2 x m \param points is overwritten, 2 x m
/// \returns `is_closed` if the gap is below 1e-13 of the length
internal::Closing_result close_polygon(const internal::Polygon_lengths& lengths, int turning_number,
                                       double angle, const internal::Plane_points& shape,
                                       Eigen::VectorXd& curvatures,
                                       internal::Plane_points& tangents,
                                       internal::Plane_points& points);

/// \ingroup PkgCurves
/// \brief Aligns a curve to another one by the rigid motion that matches the centroids and
/// minimizes the weighted sum of squared distances.
///
/// Curvature determines a curve up to a rigid motion only; this choice depends neither on the
/// numbering of the vertices nor on the origin of the plane. If all rotations are equally good, the
/// curve is not rotated. O(m).
/// \param to 2 x m \param weights of the vertices, m numbers \param points are moved, 2 x m
/// \returns the angle of the rotation, counterclockwise
double align(const internal::Plane_points& to, const Eigen::VectorXd& weights,
             internal::Plane_points& points);

/// \ingroup PkgCurves
/// \brief Computes the time derivative of the curvature of a polygon: the gradient flow of the
/// bending energy, -2 kappa, without components that would open a closed polygon [CGP 6.4.3].
///
/// For a closed polygon the result is orthogonal to 1, f^x and f^y with the dual lengths as
/// weights: sum d_i v_i = 0 and sum d_i v_i f_i = 0. O(m).
/// \param curvatures kappa, one per vertex \param points the vertices, 2 x m
/// \param direction receives m numbers
void bending_descent(const Eigen::VectorXd& curvatures, const internal::Plane_points& points,
                     const internal::Polygon_lengths& lengths, Eigen::VectorXd& direction);

}  // namespace Conformal_geometry_processing
