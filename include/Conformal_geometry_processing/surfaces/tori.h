// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/forms/Hodge_decomposition.h>
#include <Conformal_geometry_processing/forms/conformal_modulus.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <complex>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgSurfaces
/// \brief Creates a torus as a grid of m x n vertices and 2 m n faces, with vertex i n + j at
/// `point(i, j)`; row m is row 0 shifted by `shift` columns.
///
/// The diagonals run from (i, j) to (i + 1, j + 1). The faces are counter-clockwise if j points
/// upwards and i to the right. If `point` is conformal, and its grid consists of squares, the
/// modulus is that of the lattice of i and (m - i shift) / n, up to SL(2, Z).
/// \param m, n at least three
/// \param shift any integer
/// \param point returns a position for 0 <= i < m, 0 <= j < n; the caller ensures that
/// (m, j) would be (0, j + shift)
/// \throw Precondition_error if there are fewer rows or columns
template <class Point>
Mesh_view torus_grid(int m, int n, int shift, Point point)
{
  if (m < 3 || n < 3)
    throw Precondition_error("torus_grid", "the grid is " + std::to_string(m) + " x " +
                                               std::to_string(n) +
                                               ", wanted three at least each way");
  const int step = (shift % n + n) % n;
  const auto number = [&](int i, int j) { return i % m * n + (j + (i == m ? step : 0)) % n; };
  Points p(3, m * n);
  Mesh_view::Corners corners;
  corners.reserve(static_cast<std::size_t>(2 * m * n));
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      p.col(i * n + j) = point(i, j);
      corners.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1)});
      corners.push_back({number(i, j), number(i + 1, j + 1), number(i, j + 1)});
    }
  return {std::move(p), std::move(corners)};
}

/// \ingroup PkgSurfaces
/// \brief Returns the stereographic projection of a point of the 3-sphere, a unit quaternion q:
/// Im q / (1 - Re q), a conformal map; 1 is mapped to infinity, -1 to the origin.
///
/// To project from another point p, multiply by its conjugate: conjugate(p) q. All these images of
/// a surface are Moebius transforms of each other.
/// \pre q has unit length and is not 1
Eigen::Vector3d stereographic_projection(const Quaternion<double>& q);

/// \ingroup PkgSurfaces
/// \brief Creates the torus of revolution about the axis z whose tube of radius r has the distance
/// R from the axis; normals point outward.
///
/// It is the image of a product of two circles in the 3-sphere, with vertices at equal steps along
/// both: its faces are, up to discretization, conformal to halves of one rectangle, large outside
/// and small inside. The torus is conformal to the rectangle of sides 1 and b = sqrt((R/r)^2 - 1),
/// its Willmore energy is pi^2 (b + 1/b), and for b from 1/sqrt(3) to sqrt(3) no torus with less
/// energy is known in its conformal class [CGP 6.5.4].
/// \param m, n number of vertices around the axis, and around the tube
/// \throw Precondition_error unless R > r > 0, and m and n are at least three
Mesh_view round_torus(double R, double r, int m, int n);

/// \ingroup PkgSurfaces
/// \brief Creates the homogeneous torus of modulus i b: the round one with r = 1 and
/// R = sqrt(1 + b^2), in nearly square pairs of faces; b = 1 is the Clifford torus, of energy
/// 2 pi^2.
/// \param n number of vertices around the tube; b n, rounded, are around the axis
/// \throw Precondition_error unless b is positive, and n and b n are at least three
Mesh_view homogeneous_torus(double b, int n);

/// \ingroup PkgSurfaces
/// \brief A closed curve on the unit sphere and the Hopf torus over it, in the 3-sphere of unit
/// quaternions.
///
/// The Hopf fibration is q -> conjugate(q) k q; the fibre over a point of the sphere is a circle
/// e^(k x) q. The horizontal lift of the curve is half as long as the curve and ends at
/// e^(-k A/2) q, where A is the area to the left of the curve. The torus e^(k x) q(y) is therefore
/// isometric, in the 3-sphere, and conformal, after projection to space, to the plane modulo the
/// lattice of 2 pi and A/2 + i L/2 [CGP 7]. Its Willmore energy is pi times the integral of
/// 1 + curvature^2 along the curve.
class Hopf_torus {
 public:
  /// \param curve 3 x m points; connects consecutive points, and the last to the first, by the
  /// shorter great arcs. The points are normalized.
  /// \throw Precondition_error if there are fewer than three points, one is zero or not finite, or
  /// two consecutive ones are equal or opposite
  explicit Hopf_torus(const Points& curve, const std::string& function = "Hopf_torus");

  /// L, the length of the curve
  double length() const { return m_places.back(); }

  /// A, the area on the left of the curve, in [0, 4 pi)
  double area() const;

  /// (A/2 + i L/2) / (2 pi), not reduced
  std::complex<double> modulus() const;

  /// \brief Returns its image in space, a grid of m x n vertices: n on each circle, one circle over
  /// each point of the curve. The circle over (0, 0, 1) would be mapped to the axis z.
  ///
  /// If the curve has (0, 0, 1), which corresponds to infinity, on its left, normals point outward;
  /// the modulus of the mesh is then minus the conjugate of `modulus()`, reduced.
  /// \param n at least three; for squares, 4 pi m / L
  /// \throw Precondition_error if it is not, or the curve contains (0, 0, 1)
  Mesh_view mesh(int n, const std::string& function = "Hopf_torus") const;

 private:
  static Eigen::Vector3d direction(const Points& curve, Eigen::Index k,
                                   const std::string& function);

  /// Returns x such that the last lift is e^(k x) times the first one
  double holonomy() const;

  std::vector<Quaternion<double>> m_lift;  // m + 1: over the points, and again over the first
  std::vector<double> m_places;            // m + 1: arc lengths
};

/// \ingroup PkgSurfaces
/// \brief Returns the reduced modulus of a mesh of a torus; computes a harmonic basis.
/// \throw Precondition_error if the mesh is not a closed torus
/// \throw Solver_error if the Laplacian cannot be factored
inline std::complex<double> conformal_modulus(const Mesh_view& mesh)
{
  return conformal_modulus(mesh, Hodge_decomposition(mesh).harmonic_basis());
}

/// \ingroup PkgSurfaces
/// \brief Finds the torus of a family whose modulus has the imaginary part b. If all tori of the
/// family are conformally rectangular by reflection symmetry, it is the one of sides 1 and b.
///
/// Computes about ten moduli, with one factorization of the Laplacian each.
/// \param family maps a number to a mesh, whose modulus must be a continuous function of it
/// \param low, high bracket the solution: the imaginary part is below b at one, and above it at the
/// other
/// \throw Precondition_error if they do not, or a mesh is not a closed torus
/// \throw Solver_error if a factorization fails
template <class Family>
Mesh_view torus_of_class(Family family, double b, double low, double high)
{
  const auto excess = [&](double x) { return conformal_modulus(family(x)).imag() - b; };
  double at_low = excess(low), at_high = excess(high);
  if (!(at_low * at_high <= 0))
    throw Precondition_error("torus_of_class", "the moduli are " + std::to_string(at_low + b) +
                                                   " i and " + std::to_string(at_high + b) +
                                                   " i at the ends; " + std::to_string(b) +
                                                   " i is not between them");
  // Illinois variant of regula falsi: halves the value at a retained end.
  const double tolerance = 1e-10;
  for (int i = 0; i < 100; ++i) {
    const double x = (low * at_high - high * at_low) / (at_high - at_low), at_x = excess(x);
    if (std::abs(at_x) < tolerance || x == high) return family(x);
    if ((at_x < 0) == (at_high < 0))
      at_low /= 2;
    else
      low = high, at_low = at_high;
    high = x, at_high = at_x;
  }
  return family(high);
}

}  // namespace Conformal_geometry_processing
