// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Spin_transformation.h
#include "spin/boundary_tools.h"

namespace cgp_test::spin_transformation_boundary_directions_tests {

/// New directions at the boundary of plane disks, with closed forms and with tables of numbers
/// computed by other code.

using Boundary_fault = CGP::Spin_report::Boundary_fault;

struct Row {
  double gamma, Q, Q_max, shape, direction;
};

std::vector<double> column(const std::vector<Row>& rows, double Row::*field)
{
  std::vector<double> values;
  for (const Row& row : rows) values.push_back(row.*field);
  return values;
}

Row measured(const CGP::Spin_result& r, const Points& exact)
{
  EXPECT_TRUE(r.report);
  return {r.report.eigenvalue, mean_Q(r), r.report.conformality.quasi_conformal.max,
          shape_error(r.positions, exact), degrees(r.report.direction_error.mean)};
}

/// Maps disk(n) to F = z + .3 z^2, by prescribing the image of the direction t T + n N + b B
std::vector<Row> to_quadratic_map(const Eigen::Vector3d& tnb)
{
  std::vector<Row> rows;
  for (const int n : {8, 16, 32, 64}) {
    const Mesh_view mesh = disk(n);
    const auto condition = Boundary_condition::directions(tnb, quadratic_directions(mesh, tnb));
    const CGP::Spin_result r = transformed(mesh, condition, constant_potential(mesh, 0));
    rows.push_back(measured(r, mapped(mesh, quadratic_map).positions()));
  }
  return rows;
}

/// tangents of an ellipse where the disk has the same parameter
Points ellipse_tangents(const Mesh_view& disk, double a, double b)
{
  return at_boundary(disk, [=](const Eigen::Vector3d& p, const auto&) {
    return Eigen::Vector3d(-a * p.y(), b * p.x(), 0);
  });
}

double aspect(const Points& p)
{
  const Eigen::Vector3d size = p.rowwise().maxCoeff() - p.rowwise().minCoeff();
  return size.x() / size.y();
}

void expect_column(const std::vector<double>& found, const std::vector<double>& table,
                   double tolerance)
{
  for (std::size_t i = 0; i < table.size(); ++i)
    EXPECT_NEAR(found[i], table[i], tolerance * table[i]) << i;
}

std::vector<double> less_one(std::vector<double> values)
{
  for (double& value : values) value -= 1;
  return values;
}

TEST(Spin_transformation_to_new_tangents, finds_the_holomorphic_map)
{
  const std::vector<Row> rows = to_quadratic_map({1, 0, 0});
  expect_column(less_one(column(rows, &Row::Q)), {.05388, .02661, .01322, .00659}, .02);
  expect_column(less_one(column(rows, &Row::Q_max)), {.1320, .0671, .0338, .0169}, .02);
  expect_column(column(rows, &Row::gamma), {.0093, .0047, .0023, .00118}, .03);
  expect_column(column(rows, &Row::shape), {2.94e-5, 7.35e-6, 1.84e-6, 4.6e-7}, .1);
  expect_column(column(rows, &Row::direction), {.0945, .0239, .0060, .0015}, .1);
  EXPECT_LE(rows[2].direction, .02);
  expect_order(1, column(rows, &Row::gamma));
  expect_order(2, column(rows, &Row::shape));
  expect_order(2, column(rows, &Row::direction));
}

TEST(Spin_transformation_to_new_directions, finds_the_same_map_with_all_of_them)
{
  for (const Eigen::Vector3d& tnb : {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(1, 0, 1),
                                     Eigen::Vector3d(0, 1, 1), Eigen::Vector3d(1, 2, -3)}) {
    const std::vector<Row> rows = to_quadratic_map(tnb);
    expect_column(less_one(column(rows, &Row::Q)), {.05388, .02661, .01322, .00659}, .02);
    EXPECT_LT(rows[0].shape, 1e-4);
    expect_order(2, column(rows, &Row::shape));
    EXPECT_LE(rows[2].direction, .02);
  }
}

TEST(Spin_transformation_to_new_tangents, of_an_ellipse_finds_not_the_ellipse_but_artanh)
{
  const double m = 1. / 3;
  const auto exact = [=](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    const Complex F = std::atanh(std::sqrt(m) * complex_of(p));
    return {F.real(), F.imag(), 0};
  };
  std::vector<Row> rows;
  std::vector<double> aspects;
  for (const int n : {8, 16, 32, 64}) {
    const Mesh_view mesh = disk(n);
    const auto condition = Boundary_condition::tangents(ellipse_tangents(mesh, 2, 1));
    const CGP::Spin_result r = transformed(mesh, condition, constant_potential(mesh, 0));
    rows.push_back(measured(r, mapped(mesh, exact).positions()));
    aspects.push_back(aspect(r.positions));
  }
  expect_column(aspects, {1.25640, 1.25731, 1.25753, 1.25758}, 2e-5);
  const double limit = std::atanh(std::sqrt(m)) / std::atan(std::sqrt(m));
  EXPECT_NEAR(limit, 1.257602, 1e-6);
  EXPECT_NEAR(aspects[3] + (aspects[3] - aspects[2]) / 3, limit, 2e-5);  // of order two
  expect_column(less_one(column(rows, &Row::Q)), {.03788, .01887, .00940, .00469}, .02);
  expect_column(column(rows, &Row::shape), {1.9e-4, 5.0e-5, 1.3e-5, 3.1e-6}, .1);
  expect_order(2, column(rows, &Row::shape));
}

TEST(Spin_transformation_to_new_tangents, of_a_slender_ellipse_stays_far_from_affine)
{
  std::vector<double> aspects, Q;
  for (const int n : {8, 16, 32, 64}) {
    const Mesh_view mesh = disk(n);
    const auto condition = Boundary_condition::tangents(ellipse_tangents(mesh, 4, 1));
    const CGP::Spin_result r = transformed(mesh, condition, constant_potential(mesh, 0));
    aspects.push_back(aspect(r.positions));
    Q.push_back(mean_Q(r) - 1);
  }
  expect_column(aspects, {1.54888, 1.56090, 1.56428, 1.56515}, 2e-5);
  expect_column(Q, {.07141, .03540, .01757, .00874}, .02);
}

TEST(Spin_transformation_to_new_directions, turns_the_disk_around_if_they_are_opposite)
{
  const Mesh_view mesh = disk(16);
  for (const Eigen::Vector3d& tnb : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 0, 1)}) {
    const Points opposite = -at_boundary(
        mesh, [&](const auto&, const auto& frame) { return Eigen::Vector3d(frame * tnb); });
    const CGP::Spin_result r = transformed(mesh, Boundary_condition::directions(tnb, opposite),
                                           constant_potential(mesh, 0));
    EXPECT_TRUE(r.report);
    EXPECT_LT(std::abs(r.report.eigenvalue), 1e-6);
    const Eigen::Vector3d half_turn(-1, -1, 1);
    EXPECT_LT((r.positions - half_turn.asDiagonal() * mesh.positions()).cwiseAbs().maxCoeff(),
              1e-7);
  }
}

TEST(Spin_transformation_to_new_directions, turns_any_surface_that_turns_as_a_whole)
{
  const Mesh_view mesh = perturbed(cap_from_disk(jittered_disk(6, .3), 1.2), .01);
  Random random(5);
  for (int i = 0; i < 5; ++i) {
    const Eigen::Matrix3d R = random.rotation();
    const Eigen::Vector3d tnb(random.number(), random.number(), 1);
    const Points turned = at_boundary(
        mesh, [&](const auto&, const auto& frame) { return Eigen::Vector3d(R * frame * tnb); });
    const CGP::Spin_result r =
        transformed(mesh, Boundary_condition::directions(tnb, turned), constant_potential(mesh, 0));
    EXPECT_TRUE(r.report);
    const Eigen::Vector3d mean = mesh.positions().rowwise().mean();
    const Points exact = R * (mesh.positions().colwise() - mean);
    const Points centred = r.positions.colwise() - r.positions.rowwise().mean().eval();
    EXPECT_LT((centred - exact).cwiseAbs().maxCoeff(), 1e-6);
    EXPECT_LT(r.report.direction_error.max, 1e-6);
  }
}

}  // namespace cgp_test::spin_transformation_boundary_directions_tests
