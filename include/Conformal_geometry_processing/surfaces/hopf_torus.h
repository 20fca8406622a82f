// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SURFACES_HOPF_TORUS_H
#define CONFORMAL_GEOMETRY_PROCESSING_SURFACES_HOPF_TORUS_H

#include <Conformal_geometry_processing/algebra/Quaternion.h>
#include <Conformal_geometry_processing/algebra/rotor.h>
#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/surfaces/stereographic_projection.h>
#include <Conformal_geometry_processing/surfaces/torus_grid.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <complex>
#include <cstddef>
#include <string>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgSurfaces
/// \brief the closed curve on the unit sphere over which a Hopf torus is, and with it the torus
/// itself, in the 3-sphere of unit quaternions.
///
/// The fibration is q -> conjugate(q) k q; over each point of the sphere there is a circle
/// e^(k x) q. Along the curve q is transported at right angles to the fibres, which makes it half
/// as long, and comes back as e^(-k A/2) q, A being the area to the left of the curve. So the torus
/// e^(k x) q(y) is the plane modulo the lattice of 2 pi and A/2 + i L/2, isometrically in the
/// 3-sphere and conformally after projection to space [CGP 7]. Its Willmore energy is pi times the
/// integral of 1 + curvature^2 along the curve.
class Hopf_torus {
 public:
  /// \param curve 3 x m points; the curve goes from each to the next, and back from the last to the
  /// first, by the shorter great arcs. They are scaled to length one.
  /// \throw Precondition_error if there are fewer than three points, one is zero or not finite, or
  /// two that follow each other are the same or opposite
  explicit Hopf_torus(const Points& curve, const std::string& function = "Hopf_torus")
  {
    const auto m = curve.cols();
    if (m < 3)
      throw Precondition_error(
          function, "the curve has " + std::to_string(m) + " points, wanted three at least");
    Eigen::Vector3d last = direction(curve, 0, function);
    m_lift.push_back(rotor<double>(Eigen::Vector3d::UnitZ(), last));
    m_places.push_back(0);
    for (Eigen::Index k = 1; k <= m; ++k) {
      const Eigen::Vector3d next = direction(curve, k % m, function);
      const double angle = std::atan2(last.cross(next).norm(), last.dot(next));
      if (!(angle > 1e-12 && angle < 3.14159265))
        throw Precondition_error(function, "point " + std::to_string(k % m) +
                                               " is the last one again, or opposite to it");
      m_lift.push_back(m_lift.back() * rotor(last, next));
      m_places.push_back(m_places.back() + angle);
      last = next;
    }
  }

  /// L, the length of the curve
  double length() const { return m_places.back(); }

  /// A, the area on the left of the curve, in [0, 4 pi)
  double area() const
  {
    const double whole = 16 * std::atan(1.), A = 2 * std::fmod(-holonomy(), whole / 2);
    return A < 0 ? A + whole : A;
  }

  /// (A/2 + i L/2) / (2 pi), not reduced
  std::complex<double> modulus() const
  {
    const double turn = 8 * std::atan(1.);
    return {area() / 2 / turn, length() / 2 / turn};
  }

  /// \brief its image in space, a grid of m x n vertices: n on each circle, one circle over each
  /// point of the curve. The circle over (0, 0, 1) would go to the axis z.
  ///
  /// Where the curve has that point to its left, normals point outward, for (0, 0, 1) is where
  /// infinity is; the modulus of the mesh is then minus the conjugate of `modulus()`, reduced.
  /// \param n at least three; for squares, 4 pi m / L
  /// \throw Precondition_error if it is not, or the curve goes through (0, 0, 1)
  Mesh_view mesh(int n, const std::string& function = "Hopf_torus") const
  {
    const double turn = 8 * std::atan(1.), columns = n / turn;
    const int m = static_cast<int>(m_lift.size()) - 1;
    // The grid comes back to itself at a whole number of columns: the rest is a shear, by less
    // than half a column in all.
    const int shift = static_cast<int>(std::round(holonomy() * columns));
    const double shear = shift / columns - holonomy();
    return torus_grid(m, n, shift, [&](int i, int j) {
      const std::size_t row = static_cast<std::size_t>(i);
      const double x = j / columns + shear * m_places[row] / length();
      const Quaternion<double> q = Quaternion<double>{std::cos(x), 0, 0, std::sin(x)} * m_lift[row];
      // That point's fibre is the one of quaternions without i and j.
      if (!(q.x * q.x + q.y * q.y > 1e-20))
        throw Precondition_error(function,
                                 "the curve goes through (0, 0, 1), which is sent to "
                                 "infinity; turn the curve");
      return stereographic_projection(q);
    });
  }

 private:
  static Eigen::Vector3d direction(const Points& curve, Eigen::Index k, const std::string& function)
  {
    const double size = curve.col(k).stableNorm();
    if (!(size > 0) || !std::isfinite(size))
      throw Precondition_error(
          function, "point " + std::to_string(k) + " of the curve is zero or not finite");
    return curve.col(k) / size;
  }

  /// x with e^(k x) times the first lift being the last
  double holonomy() const
  {
    const Quaternion<double> e = m_lift.back() * conjugate(m_lift.front());
    return std::atan2(e.z, e.w);
  }

  std::vector<Quaternion<double>> m_lift;  // m + 1: over the points, and again over the first
  std::vector<double> m_places;            // m + 1: lengths up to them
};

}  // namespace Conformal_geometry_processing

#endif
