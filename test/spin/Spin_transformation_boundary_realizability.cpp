// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests spin/Spin_transformation.h
// Tests spin/Spin_report.h
#include "spin/boundary_tools.h"

namespace cgp_test::spin_transformation_boundary_realizability_tests {

/// Which tangents can be prescribed: those of plane curves with odd turning number for any rho,
/// others in general not. The reference values come from independent code.

using Boundary_fault = CGP::Spin_report::Boundary_fault;

Mesh_view graph(int n)
{
  return mapped(disk(n), [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    const double x = p.x(), y = p.y();
    return {x, y, .4 * x * y + .3 * x * x - .2 * y * y * y};
  });
}

/// gamma of the graph with new tangents and a rho of no particular kind
template <class Tangents>
std::vector<double> gammas(Tangents tangents)
{
  std::vector<double> list;
  for (const int n : {8, 16, 32, 64}) {
    const Mesh_view mesh = graph(n);
    const auto rho = potential_on_vertices(mesh, [](const Eigen::Vector3d& p) {
      return 1.5 * (std::cos(2 * p.x() + 1) + p.x() * p.y());
    });
    const CGP::Spin_result r = transformed(mesh, Boundary_condition::tangents(tangents(n)), rho);
    EXPECT_TRUE(r.report.converged);
    list.push_back(r.report.eigenvalue);
  }
  return list;
}

/// `disk(n)` with tangents T + .3 (c + cos 2t) e_z
CGP::Spin_report tilted(int n, double c)
{
  const Mesh_view mesh = disk(n);
  const Points tangents = at_boundary(mesh, [=](const Eigen::Vector3d& p, const auto& frame) {
    const double t = std::atan2(p.y(), p.x());
    return Eigen::Vector3d(frame.col(0) + Eigen::Vector3d(0, 0, .3 * (c + std::cos(2 * t))));
  });
  return transformed(mesh, Boundary_condition::tangents(tangents), constant_potential(mesh, 0))
      .report;
}

/// `disk(n)` with tangents at the angle turns * t + pi/2
CGP::Spin_report winding(int n, int turns)
{
  const Mesh_view mesh = disk(n);
  const Points tangents = at_boundary(mesh, [=](const Eigen::Vector3d& p, const auto&) {
    const double angle = turns * std::atan2(p.y(), p.x());
    return Eigen::Vector3d(-std::sin(angle), std::cos(angle), 0);
  });
  return transformed(mesh, Boundary_condition::tangents(tangents), constant_potential(mesh, 0))
      .report;
}

void expect_near_to_3_percent(const std::vector<double>& found, const std::vector<double>& table)
{
  for (std::size_t i = 0; i < table.size(); ++i)
    EXPECT_NEAR(found[i], table[i], .03 * table[i]) << i;
}

TEST(Tangents_of_a_plane_curve, can_be_prescribed_with_any_rho_on_any_surface)
{
  const std::vector<double> circle = gammas([](int n) {
    return at_boundary(
        disk(n), [](const auto&, const auto& frame) -> Eigen::Vector3d { return frame.col(0); });
  });
  expect_near_to_3_percent(circle, {.07162, .03682, .01856, .00930});
  expect_order(1, circle);
}

TEST(Tangents_of_a_plane_curve, can_lie_in_any_plane)
{
  const Eigen::AngleAxisd tilt(.5, Eigen::Vector3d(1, 0, 0));
  const std::vector<double> ellipse = gammas([&](int n) {
    return at_boundary(disk(n), [&](const Eigen::Vector3d& p, const auto&) -> Eigen::Vector3d {
      return tilt * Eigen::Vector3d(-1.3 * p.y(), p.x(), 0);
    });
  });
  expect_order(1, ellipse);
}

TEST(Tangents_of_a_space_curve, leave_a_singular_value)
{
  const std::vector<double> kept = gammas([](int) { return Points(3, 0); });
  expect_near_to_3_percent(kept, {.07442, .03980, .02300, .01612});
  EXPECT_LT(kept[2] / kept[3], 1.5);  // tends to .0130, not to zero
}

TEST(Tangents_of_a_space_curve, leave_one_in_proportion_to_the_condition_they_miss)
{
  const std::vector<double> none = {tilted(8, 0).eigenvalue, tilted(16, 0).eigenvalue,
                                    tilted(32, 0).eigenvalue};
  expect_order(1, none);
  EXPECT_NEAR(tilted(32, .1).eigenvalue, .0285, .0285 * .03);
  EXPECT_NEAR(tilted(32, 1).eigenvalue, .2772, .2772 * .02);
  EXPECT_TRUE(tilted(16, 0));
  EXPECT_EQ(tilted(16, 1).boundary_fault, Boundary_fault::not_realizable);
  EXPECT_FALSE(tilted(16, 1));
}

TEST(Boundary_fault_of_a_transformation, tells_that_constant_tangents_are_impossible)
{
  for (const int n : {8, 16, 32}) {
    const CGP::Spin_report report = winding(n, 0);
    EXPECT_EQ(report.boundary_fault, Boundary_fault::not_realizable);
    EXPECT_FALSE(report);
    EXPECT_NEAR(report.eigenvalue, 1.4342, .01);
  }
}

TEST(Boundary_fault_of_a_transformation, tells_that_tangents_with_two_turns_are_impossible)
{
  for (const int n : {16, 32}) {
    const CGP::Spin_report report = winding(n, 2);
    EXPECT_NE(report.boundary_fault, Boundary_fault::none);
    EXPECT_FALSE(report);
  }
}

TEST(Boundary_fault_of_a_transformation, is_none_for_data_with_a_solution)
{
  for (const int n : {4, 8, 16}) {
    EXPECT_EQ(winding(n, 1).boundary_fault, Boundary_fault::none);
    const Mesh_view mesh = jittered_disk(n, .3);
    const auto condition = Boundary_condition::tangents(enneper_directions(mesh, {1, 0, 0}));
    EXPECT_TRUE(transformed(mesh, condition, constant_potential(mesh, 0)).report);
  }
}

}  // namespace cgp_test::spin_transformation_boundary_realizability_tests
