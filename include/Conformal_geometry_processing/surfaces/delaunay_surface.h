// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/surfaces/Jacobi_functions.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgSurfaces
/// \brief The meridian of a surface of revolution with constant mean curvature, as a function of
/// its conformal length u: distances from the axis, and heights.
///
/// The force along the axis is constant, x dz/ds - H x^2 = c, and du = ds/x. Therefore
/// dz/du = c + H x^2 and (dx/du)^2 = x^2 - (dz/du)^2, hence d^2x/du^2 = (1 - 2 H c) x - 2 H^2 x^3,
/// with the solution x = bulge dn(t), z = c u + bulge E(am t), where t = H bulge u and |neck| /
/// bulge is the complementary modulus. Accurate to rounding for necks of any width.
class Delaunay_meridian {
 public:
  /// \param neck, bulge the minimal and the maximal distance from the axis, the former negative for
  /// nodoids, whose meridian has loops: neck = bulge is the cylinder, neck -> 0 a chain of spheres
  /// \throw Precondition_error unless bulge >= |neck| > 0 and neck > -bulge, both finite
  Delaunay_meridian(double neck, double bulge);

  /// H of the surface whose normals point away from the axis at the bulge
  double mean_curvature() const { return m_H; }

  /// The conformal length from one bulge to the next; pi / (H bulge) for the cylinder
  double period() const { return m_period; }

  /// \brief Returns points at equal steps of u, from a bulge at height zero, with n steps per
  /// period. \param count number of points; the result is 2 x count
  Eigen::Matrix2Xd points(int n, int count) const;

 private:
  /// at the share s of a period, 0 <= s <= 1/2
  Eigen::Vector2d point(double s) const;

  double m_bulge, m_H, m_force, m_period;
  Jacobi_functions m_functions;
};

}  // namespace internal

/// \ingroup PkgSurfaces
/// \brief Creates a piece of a Delaunay surface, an unduloid or a nodoid, with axis z and constant
/// mean curvature 1 / (bulge + neck). Its two boundary loops are at bulges.
///
/// Its faces are, up to discretization, conformal to halves of one rectangle.
/// \param neck, bulge as for `Delaunay_meridian`
/// \param m number of vertices around the axis
/// \param n number of rows per period
/// \param periods number of periods
/// \throw Precondition_error if the radii are invalid, m < 3, or n or periods < 1
Mesh_view delaunay_surface(double neck, double bulge, int m, int n, int periods = 1);

}  // namespace Conformal_geometry_processing
