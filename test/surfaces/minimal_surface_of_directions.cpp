// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/surfaces/minimal_surface.h
#include <Conformal_geometry_processing/surfaces/minimal_surface.h>

#include "spin/boundary_tools.h"
#include "support/moebius.h"
#include "support/random_delaunay.h"
#include "support/weierstrass.h"

namespace cgp_test::minimal_surface_of_directions_tests {

using Boundary_fault = CGP::Spin_report::Boundary_fault;

const Eigen::Vector3d tangent(1, 0, 0), binormal(0, 0, 1);

Mesh_view plane_domain(double h, std::uint64_t seed, bool has_hole)
{
  const std::vector<Circle> hole{{Eigen::Vector2d(.1, .05), .35}};
  return random_domain(h, seed, has_hole ? hole : std::vector<Circle>{});
}

template <class Differential>
CGP::Spin_result minimal(const Mesh_view& plane, const Mesh_view& source, Differential differential,
                         const Eigen::Vector3d& tnb)
{
  const Points targets = image_directions(plane, differential, tnb);
  return CGP::spin_to_minimal_surface(source, {Boundary_condition::directions(tnb, targets)});
}

CGP::Spin_result minimal(const Mesh_view& plane, const Mesh_view& source,
                         const Weierstrass_surface& X, const Eigen::Vector3d& tnb)
{
  return minimal(
      plane, source,
      [&X](const Eigen::Vector3d& p, const Eigen::Vector3d& v) { return X.differential(p, v); },
      tnb);
}

double gamma_radius(const CGP::Spin_result& r, const Mesh_view& mesh)
{
  return std::abs(r.report.eigenvalue) * std::sqrt(area(mesh) / pi);
}

/// the catenoid is the image of the plane under (1/z, z)
Eigen::Vector3d catenoid(const Eigen::Vector3d& p)
{
  const double s = p.squaredNorm();
  return {-(p.x() / s + p.x()) / 2, -(p.y() / s + p.y()) / 2, std::log(s) / 2};
}

Eigen::Vector3d catenoid_differential(const Eigen::Vector3d& p, const Eigen::Vector3d& v)
{
  const Complex z = complex_of(p), dz = complex_of(v) / (z * z);
  return {(.5 * dz * (1. - z * z)).real(), (Complex(0, .5) * dz * (1. + z * z)).real(),
          (dz * z).real()};
}

TEST(Minimal_surface_of_directions, is_that_of_the_weierstrass_data_of_the_same_boundary)
{
  for (const bool has_hole : {false, true})
    for (const Eigen::Vector3d& tnb : {tangent, binormal}) {
      const std::vector<double> h{.24, .12, .06};
      std::vector<double> errors(h.size(), 0);
      for (std::size_t i = 0; i < h.size(); ++i)
        for (std::uint64_t seed = 0; seed < (i == 1 ? 24 : 4); ++seed) {
          const Mesh_view plane = plane_domain(h[i], seed, has_hole);
          const Weierstrass_surface X = Weierstrass_surface::random(100 + seed);
          const CGP::Spin_result r = minimal(plane, plane, X, tnb);
          ASSERT_TRUE(r.report) << h[i] << " " << seed;
          const double error = shape_error(r.positions, mapped(plane, X).positions());
          // On rings, the tangents have a second vector whose singular value tends to zero.
          const bool is_unique = !has_hole || tnb == binormal;
          EXPECT_LT(error, .12 * h[i] * h[i] + (is_unique ? 0 : 4e-4));
          if (seed < 4) errors[i] += error;
          EXPECT_LT(gamma_radius(r, plane), tnb == tangent ? h[i] : .1 * h[i] * h[i]);
        }
      EXPECT_GT(slope(h, errors), !has_hole ? 1.9 : tnb == binormal ? 1.6 : 1);
    }
}

// Binormals are had by other surfaces, too, of other constant mean curvatures, of which some are
// nearer to the plane: the Gauss map may be far from that of a plane.
TEST(Minimal_surface_of_directions, is_what_a_transformation_without_rho_finds)
{
  std::vector<Weierstrass_surface> surfaces{{{1, .5}, {.3, .6}}};
  for (const double a : {.1, .2, .3, .5, .7}) surfaces.push_back({{2}, {a, .9}});
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    surfaces.push_back(Weierstrass_surface::random(200 + seed));
  std::uint64_t seed = 7;
  for (const Weierstrass_surface& X : surfaces) {
    const Mesh_view plane = plane_domain(.15, seed++, false);
    const auto condition = Boundary_condition::binormals(image_directions(
        plane,
        [&X](const Eigen::Vector3d& p, const Eigen::Vector3d& v) { return X.differential(p, v); },
        binormal));
    const CGP::Spin_result r = transformed(plane, condition, constant_potential(plane, 0));
    EXPECT_TRUE(r.report) << seed;
    EXPECT_LT(gamma_radius(r, plane), 1e-2) << seed;
    EXPECT_LT(shape_error(r.positions, mapped(plane, X).positions()), 3e-3) << seed;
  }
}

TEST(Minimal_surface_of_directions, is_the_catenoid_on_a_ring_with_its_binormals)
{
  const std::vector<double> h{.2, .1, .05};
  std::vector<double> errors;
  for (const double length : h) {
    const Mesh_view ring = scaled(random_domain(length, 7, {{Eigen::Vector2d::Zero(), .35}}), 1.6);
    const CGP::Spin_result r = minimal(ring, ring, catenoid_differential, binormal);
    EXPECT_TRUE(r.report) << length;
    errors.push_back(shape_error(r.positions, mapped(ring, catenoid).positions()));
  }
  EXPECT_GT(slope(h, errors), 1.8);
  EXPECT_LT(errors.back(), 1e-3);
}

TEST(Minimal_surface_of_directions, is_found_from_a_curved_surface)
{
  for (const Eigen::Vector3d& tnb : {tangent, binormal}) {
    const std::vector<double> h{.2, .1, .05};
    std::vector<double> errors;
    for (const double length : h) {
      const Mesh_view plane = plane_domain(length, 9, false);
      const Weierstrass_surface X = Weierstrass_surface::random(102);
      const Mesh_view wanted = mapped(plane, X);
      const CGP::Spin_result r = minimal(
          plane,
          inverted(wanted, wanted.positions().rowwise().mean() + Eigen::Vector3d(.3, .2, 1.5)), X,
          tnb);
      EXPECT_TRUE(r.report) << length;
      errors.push_back(shape_error(r.positions, wanted.positions()));
    }
    EXPECT_GT(slope(h, errors), .9);  // as the mean curvature at the boundary
    EXPECT_LT(errors.back(), .005);
  }
}

TEST(Minimal_surface_of_directions, is_refused_where_no_eigenvalue_is_zero)
{
  // By balance: the integral of the binormals of a minimal surface is zero.
  for (const double h : {.3, .15, .075}) {
    const Mesh_view hemisphere = cap_from_disk(plane_domain(h, 3, false), pi / 2);
    const CGP::Spin_result r =
        CGP::spin_to_minimal_surface(hemisphere, {Boundary_condition::binormals()});
    EXPECT_FALSE(r.report);
    EXPECT_EQ(r.report.boundary_fault, Boundary_fault::not_realizable);
    EXPECT_GT(gamma_radius(r, hemisphere), 1);
  }
}

}  // namespace cgp_test::minimal_surface_of_directions_tests
