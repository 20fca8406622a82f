// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <complex>
#include <string>
#include <vector>

namespace Conformal_geometry_processing {

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

}  // namespace Conformal_geometry_processing
