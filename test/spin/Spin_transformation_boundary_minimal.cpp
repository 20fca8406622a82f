// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Spin_transformation.h
#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>

#include "spin/boundary_tools.h"

namespace cgp_test::spin_transformation_boundary_minimal_tests {

/// Minimal surfaces in one solve: from plane domains with rho = 0, from curved ones with rho = -H.

void expect_enneper(const Mesh_view& mesh, const Eigen::Vector3d& tnb)
{
  CGP::Dirac_options options;
  options.tolerance = 1e-13;
  const auto condition = Boundary_condition::directions(tnb, enneper_directions(mesh, tnb));
  const CGP::Spin_result r = transformed(mesh, condition, constant_potential(mesh, 0), options);
  EXPECT_TRUE(r.report);
  const Points exact = enneper(mesh).positions();
  EXPECT_LT(CGP::align(r.positions, exact).max, 1e-12);
  EXPECT_LT(r.report.closure_residual, 1e-11);
  EXPECT_LT(std::abs(r.report.eigenvalue), 1e-11);
}

const std::vector<Eigen::Vector3d> all_directions = {{1, 0, 0}, {0, 0, 1}, {1, 0, 1},
                                                     {0, 1, 1}, {1, 1, 0}, {-1, 2, 3}};

struct Row {
  double gamma, Q, shape, energy;
};

std::vector<double> column(const std::vector<Row>& rows, double Row::*field)
{
  std::vector<double> values;
  for (const Row& row : rows) values.push_back(row.*field);
  return values;
}

Row measured(const Mesh_view& mesh, const CGP::Spin_result& r, const Points& exact)
{
  EXPECT_TRUE(r.report);
  return {r.report.eigenvalue, mean_Q(r), shape_error(r.positions, exact),
          CGP::willmore_energy(Mesh_view(r.positions, mesh.corners()))};
}

void expect_column(const std::vector<double>& found, const std::vector<double>& table,
                   double tolerance, double offset = 0)
{
  for (std::size_t i = 0; i < table.size(); ++i)
    EXPECT_NEAR(found[i], table[i], tolerance * (table[i] - offset)) << i;
}

/// the strip [0, 4] x [0, 2] in 4n x 2n squares
Mesh_view strip(int n)
{
  return grid(4 * n, 2 * n, 4, 2);
}

/// The differential of `catenoid_strip()`
Eigen::Vector3d catenoid_differential(const Eigen::Vector3d& p, const Eigen::Vector3d& d)
{
  const double v = p.x(), u = p.y() - 1, c = std::cosh(u), s = std::sinh(u);
  return d.x() * c * Eigen::Vector3d(-std::sin(v), std::cos(v), 0) +
         d.y() * Eigen::Vector3d(s * std::cos(v), s * std::sin(v), 1);
}

std::vector<Row> strip_to_catenoid(const Eigen::Vector3d& tnb)
{
  std::vector<Row> rows;
  for (const int n : {8, 16, 32}) {
    const Mesh_view mesh = strip(n);
    const auto condition =
        Boundary_condition::directions(tnb, image_directions(mesh, catenoid_differential, tnb));
    rows.push_back(measured(mesh, transformed(mesh, condition, constant_potential(mesh, 0)),
                            catenoid_strip(n).positions()));
  }
  return rows;
}

/// with rho = sign * H and the tangents given
CGP::Spin_result without_curvature(const Mesh_view& mesh, Points tangents, double sign = -1)
{
  const auto rho = Curvature_potential::on_vertices(sign * CGP::mean_curvature(mesh));
  return transformed(mesh, Boundary_condition::tangents(std::move(tangents)), rho);
}

TEST(Enneper_s_surface, comes_out_of_the_disk_to_the_last_digits_by_all_directions)
{
  for (const Eigen::Vector3d& tnb : all_directions) expect_enneper(disk(8), tnb);
}

TEST(Enneper_s_surface, comes_out_of_irregular_plane_meshes_to_the_last_digits)
{
  for (const Eigen::Vector3d& tnb : all_directions) {
    expect_enneper(jittered_disk(8, .35), tnb);
    expect_enneper(moved_disk(8), tnb);
  }
}

TEST(Enneper_s_surface, comes_out_of_finer_disks_to_the_last_digits)
{
  for (const int n : {16, 32, 64}) {
    expect_enneper(disk(n), {1, 0, 0});
    expect_enneper(disk(n), {0, 0, 1});
  }
  expect_enneper(jittered_disk(32, .35), {1, 0, 1});
}

TEST(Enneper_s_surface, comes_out_as_conformal_as_it_is_sampled)
{
  const std::vector<double> table = {1.05334, 1.02637, 1.01310, 1.00653};
  for (std::size_t i = 0; i < 4; ++i) {
    const Mesh_view mesh = disk(8 << i);
    const auto condition = Boundary_condition::tangents(enneper_directions(mesh, {1, 0, 0}));
    EXPECT_NEAR(mean_Q(transformed(mesh, condition, constant_potential(mesh, 0))), table[i], 1e-5);
  }
}

TEST(Enneper_s_surface, comes_out_to_second_order_by_the_tangents_of_a_mesh_of_it)
{
  std::vector<double> errors;
  for (const int n : {8, 16, 32, 64}) {
    const Mesh_view mesh = disk(n), exact = enneper(mesh);
    const Points tangents = at_boundary(
        exact, [](const auto&, const auto& frame) -> Eigen::Vector3d { return frame.col(0); });
    const CGP::Spin_result r =
        transformed(mesh, Boundary_condition::tangents(tangents), constant_potential(mesh, 0));
    errors.push_back(shape_error(r.positions, exact.positions()));
  }
  expect_column({errors[1], errors[2]}, {3.3e-4, 8.1e-5}, .1);
  expect_order(2, errors);
}

TEST(Catenoid, comes_out_of_a_strip_to_second_order_by_tangents)
{
  const std::vector<Row> rows = strip_to_catenoid({1, 0, 0});
  expect_column(column(rows, &Row::gamma), {.0221, .0110, .0055}, .03);
  expect_column(column(rows, &Row::Q), {1.03929, 1.01941, 1.00964}, .02, 1);
  expect_column(column(rows, &Row::shape), {1.95e-4, 4.87e-5, 1.22e-5}, .1);
  expect_order(2, column(rows, &Row::shape));
  EXPECT_LT(rows[2].energy, 2e-6);  // of H squared
  EXPECT_GT(slope({4, 2, 1}, column(rows, &Row::energy)), 2.8);
}

TEST(Catenoid, comes_out_of_a_strip_to_second_order_by_binormals)
{
  // Other surfaces of constant H |df| have the same binormals. The smallest rotations to these
  // belong to neither surface: they do not close around the strip.
  const std::vector<Row> rows = strip_to_catenoid({0, 0, 1});
  expect_column(column(rows, &Row::Q), {1.03929, 1.01941, 1.00964}, .02, 1);
  expect_column(column(rows, &Row::shape), {1.6e-4, 4.0e-5, 1.0e-5}, .1);
  expect_order(2, column(rows, &Row::shape));
}

TEST(Catenoid, comes_out_of_a_cylinder_by_projection_on_the_kernel)
{
  // Planes and catenoids share tangents at both ends: the kernel has two dimensions.
  std::vector<Row> rows;
  for (const int n : {8, 16, 32}) {
    const Mesh_view mesh = cylinder(1, 2, 6 * n, 2 * n);
    const auto exact = mapped(mesh, [](const Eigen::Vector3d& p) {
      const double c = std::cosh(p.z() - 1);
      return Eigen::Vector3d(c * p.x(), c * p.y(), p.z());
    });
    CGP::Dirac_options options;
    options.kernel_tolerance = .8 / n;
    rows.push_back(measured(
        mesh,
        transformed(mesh, Boundary_condition::tangents(), constant_potential(mesh, -.5), options),
        exact.positions()));
  }
  expect_order(2, column(rows, &Row::shape));
  expect_order(1, column(rows, &Row::gamma));
  EXPECT_LT(rows[0].shape, 5e-4);
  EXPECT_NEAR((rows[0].Q - 1) / (rows[2].Q - 1), 4, .2);
}

TEST(Hemisphere, becomes_flat_by_minus_its_mean_curvature)
{
  std::vector<Row> rows;
  for (const int n : {8, 16, 32, 64}) {
    const Mesh_view mesh = cap_from_disk(disk(n), pi / 2);
    rows.push_back(measured(mesh, without_curvature(mesh, Points(3, 0)), disk(n).positions()));
  }
  expect_column(column(rows, &Row::gamma), {.0292, .0151, .0076, .0038}, .03);
  expect_column(column(rows, &Row::Q), {1.06728, 1.03318, 1.01646, 1.00820}, .02, 1);
  expect_order(2, column(rows, &Row::shape));
  // Smaller than in the table, where H is divided by another area.
  EXPECT_LT(rows[0].shape, 4.5e-4);
  EXPECT_LT(rows[0].energy, 2.9e-4);
  EXPECT_LT(rows[3].energy, 1.9e-6);
}

TEST(Hemisphere, becomes_twice_as_curved_with_the_other_sign)
{
  const Mesh_view mesh = cap_from_disk(disk(16), pi / 2);
  const CGP::Spin_result r = without_curvature(mesh, Points(3, 0), 1);
  EXPECT_NEAR(CGP::willmore_energy(mesh), 6.2, .2);
  EXPECT_NEAR(CGP::willmore_energy(Mesh_view(r.positions, mesh.corners())), 24.3, 1);
}

TEST(Inverted_enneper_surface, becomes_minimal_by_minus_its_mean_curvature)
{
  const Eigen::Vector3d centre(.3, .2, 1.2);
  std::vector<Row> rows;
  for (const int n : {8, 16, 32, 64}) {
    const Mesh_view flat = disk(n), exact = enneper(flat);
    const Mesh_view mesh = mapped(exact, [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
      return (p - centre) / (p - centre).squaredNorm();
    });
    const CGP::Spin_result r = without_curvature(mesh, enneper_directions(flat, {1, 0, 0}));
    rows.push_back(measured(mesh, r, exact.positions()));
  }
  expect_column(column(rows, &Row::shape), {8.5e-3, 2.1e-3, 5.1e-4, 1.26e-4}, .15);
  expect_column(column(rows, &Row::Q), {1.1640, 1.0787, 1.0392, 1.0195}, .03, 1);
  expect_order(2, column(rows, &Row::shape));
}

TEST(Annulus, becomes_the_image_of_a_holomorphic_map_by_the_tangents_of_both_circles)
{
  std::vector<Row> rows;
  for (const int n : {8, 16, 32}) {
    const Mesh_view mesh = annulus(.4, 1, 6 * n, n);
    const auto condition = Boundary_condition::tangents(quadratic_directions(mesh, {1, 0, 0}));
    rows.push_back(measured(mesh, transformed(mesh, condition, constant_potential(mesh, 0)),
                            mapped(mesh, quadratic_map).positions()));
  }
  expect_order(2, column(rows, &Row::shape));
  expect_order(1, column(rows, &Row::gamma));
  EXPECT_LT(rows[2].shape, 5e-5);
}

TEST(Annulus, becomes_a_piece_of_enneper_s_surface_by_the_directions_of_both_circles)
{
  for (const Eigen::Vector3d& tnb : all_directions) expect_enneper(annulus(.4, 1, 36, 6), tnb);
}

}  // namespace cgp_test::spin_transformation_boundary_minimal_tests
