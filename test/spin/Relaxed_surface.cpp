// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Spin_transformation_directions.cpp
#include <Conformal_geometry_processing/spin/Directions_selection.h>
#include <Conformal_geometry_processing/spin/Relaxed_surface.h>

#include <complex>
#include <string>

#include "spin/boundary_tools.h"
#include "support/random_delaunay.h"
#include "support/weierstrass.h"

namespace cgp_test::relaxed_surface_tests {

using Fault = CGP::Spin_report::Boundary_fault;

const Circle hole{{.1, .05}, .275};

int size_of_kernel(const std::vector<Circle>& holes, const Eigen::Vector3d& tnb, double rho)
{
  const Mesh_view mesh = random_domain(.1, 5, holes);
  CGP::internal::Dirac_system system(mesh, Boundary_condition::directions(tnb));
  CGP::internal::Dirac_solution costs;
  const Curvature_potential potential = constant_potential(mesh, rho);
  system.set_potential(potential, costs.seconds);
  const auto kernel = CGP::internal::Directions_selection(system, potential, {})
                          .kernel(costs, CGP::internal::Always_go_further());
  EXPECT_GT(costs.solves, 0);
  return static_cast<int>(kernel.cols());
}

TEST(Kernel_of_directions, has_one_vector_more_around_a_hole)
{
  for (const Eigen::Vector3d& tnb : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 0, 1)}) {
    EXPECT_EQ(size_of_kernel({}, tnb, 0), 1);
    EXPECT_EQ(size_of_kernel({hole}, tnb, 0), 2);
  }
  EXPECT_EQ(size_of_kernel({hole}, {0, 0, 1}, .8), 0);  // that is not in the spectrum
}

/// a minimal surface that turns the ring inside out
Eigen::Vector3d inside_out(const Eigen::Vector3d& p)
{
  static const auto X = Weierstrass_surface::random(1005);
  const Complex z(p.x() - hole.center.x(), p.y() - hole.center.y()), w = .8 * hole.radius / z;
  return X({w.real(), w.imag(), 0});
}

struct Ring {
  Mesh_view plane, target;

  explicit Ring(double h) : plane(random_domain(h, 5, {hole})), target(mapped(plane, inside_out)) {}

  /// an axis of the frames at the boundary of the target
  Points axes(int axis) const
  {
    return at_boundary(target, [&](const auto&, const CGP::internal::Boundary_frame& frame) {
      return Eigen::Vector3d(frame.col(axis));
    });
  }

  CGP::Spin_result of(const Boundary_condition& condition) const
  {
    return CGP::Spin_transformation(plane, {condition}).transform(constant_potential(plane, 0));
  }

  double error(const CGP::Spin_result& r) const
  {
    return CGP::align(r.positions, target.positions()).rms;
  }
};

// The plane ring that is turned over has nearly the same binormals, and is nearer to the guide.
TEST(Ring_turned_inside_out, has_the_binormals_that_are_asked_for_and_closes_up)
{
  std::vector<double> errors;
  for (const double h : {.1, .05}) {
    const Ring ring(h);
    const CGP::Spin_result r = ring.of(Boundary_condition::binormals(ring.axes(2)));
    EXPECT_TRUE(r.report) << to_string(r.report.fault());
    EXPECT_LT(r.report.added_share, .03);
    EXPECT_LE(r.report.period_defect, r.report.period_limit);
    errors.push_back(ring.error(r));
  }
  EXPECT_LT(errors[0], .01);
  EXPECT_LT(errors[1], errors[0] / 1.9);
}

TEST(Ring_turned_inside_out, has_the_tangents_that_are_asked_for)
{
  const Ring ring(.05);
  const CGP::Spin_result r = ring.of(Boundary_condition::tangents(ring.axes(0)));
  EXPECT_TRUE(r.report) << to_string(r.report.fault());
  EXPECT_LT(ring.error(r), .005);
  EXPECT_LT(r.report.added_share, .02);
}

TEST(Ring_turned_inside_out, is_told_from_the_one_turned_over_or_refused)
{
  const Ring ring(.2);
  const CGP::Spin_result of_binormals = ring.of(Boundary_condition::binormals(ring.axes(2)));
  EXPECT_EQ(of_binormals.report.boundary_fault, Fault::ambiguous);
  EXPECT_EQ(of_binormals.report.fault(), CGP::Spin_report::Fault::boundary);
  EXPECT_FALSE(ring.of(Boundary_condition::tangents(ring.axes(0))).report);
}

// Data that no minimal surface has: the surface that turns least gets what rho lacks.
TEST(Ring_with_tilted_binormals, is_not_ambiguous)
{
  const Mesh_view plane = random_domain(.1, 5, {hole});
  const Points tilted =
      at_boundary(plane, [](const Eigen::Vector3d& p, const CGP::internal::Boundary_frame& frame) {
        const double angle = .3 + .2 * std::sin(2 * p.x());
        return Eigen::Vector3d(std::cos(angle) * frame.col(2) + std::sin(angle) * frame.col(1));
      });
  const CGP::Spin_result r =
      CGP::Spin_transformation(plane, {Boundary_condition::binormals(tilted)})
          .transform(constant_potential(plane, 0));
  EXPECT_TRUE(r.report) << to_string(r.report.fault());
  EXPECT_EQ(r.report.boundary_fault, Fault::none);
}

}  // namespace cgp_test::relaxed_surface_tests
