// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests spin/Spin_transformation.h
#include <functional>

#include <Conformal_geometry_processing/spin/Spin_report.h>
#include "spin/boundary_tools.h"

namespace cgp_test::spin_transformation_boundary_revolution_tests {

/// Surfaces of revolution: for rho(r) on the unit disk, l = a(r) - b(r) T with a' = -rho b,
/// b' + b/r = rho a, a(0) = 1 and b(0) = 0. They are f~ = r (a^2 + b^2) e_r + h e_z, h' = -2 a b.

struct Profile {
  double a = 1, b = 0, h = 0;
};

Profile operator+(const Profile& p, const Profile& q)
{
  return {p.a + q.a, p.b + q.b, p.h + q.h};
}

Profile operator*(double s, const Profile& p)
{
  return {s * p.a, s * p.b, s * p.h};
}

using Radial_function = std::function<double(double)>;

/// the profile at r = 0, 1/n, ... 1, by the method of Runge and Kutta
std::vector<Profile> profile(const Radial_function& rho, int n)
{
  const int substeps = 2000 / n;
  const double dr = 1. / (n * substeps);
  const auto derivative = [&](double r, const Profile& p) {
    const double b = r > 0 ? rho(r) * p.a - p.b / r : rho(0) / 2;
    return Profile{-rho(r) * p.b, b, -2 * p.a * p.b};
  };
  std::vector<Profile> list(1);
  Profile p;
  for (int i = 0; i < n * substeps; ++i) {
    const double r = i * dr;
    const Profile k1 = derivative(r, p), k2 = derivative(r + dr / 2, p + (dr / 2) * k1),
                  k3 = derivative(r + dr / 2, p + (dr / 2) * k2),
                  k4 = derivative(r + dr, p + dr * k3);
    p = p + (dr / 6) * (k1 + 2 * k2 + 2 * k3 + k4);
    if ((i + 1) % substeps == 0) list.push_back(p);
  }
  return list;
}

/// the surface on the vertices of `disk(n)`
Points surface(const Radial_function& rho, int n)
{
  const std::vector<Profile> list = profile(rho, n);
  return mapped(disk(n),
                [&](const Eigen::Vector3d& x) -> Eigen::Vector3d {
                  const Profile& p = list[static_cast<std::size_t>(std::lround(n * x.norm()))];
                  return (p.a * p.a + p.b * p.b) * x + Eigen::Vector3d(0, 0, p.h);
                })
      .positions();
}

double bump(double r)
{
  return 3 * std::exp(-r * r / (2 * .3 * .3));
}

/// gamma between two bounds for which b(1) = 0, so that the binormals stay
double gamma_of_bump(double low, double high)
{
  const auto b = [](double gamma) {
    return profile([=](double r) { return bump(r) + gamma; }, 1).back().b;
  };
  const bool falls = b(low) > 0;
  for (int i = 0; i < 45; ++i) {
    const double middle = (low + high) / 2;
    ((b(middle) > 0) == falls ? low : high) = middle;
  }
  return low;
}

struct Row {
  double gamma, Q, shape;
};

/// Results for rho on disks of 8, 16, 32, 64 rings, against the surface for rho + gamma
std::vector<Row> rows(const Boundary_condition& condition, const Radial_function& rho,
                      double gamma = 0)
{
  std::vector<Row> list;
  for (const int n : {8, 16, 32, 64}) {
    const Mesh_view mesh = disk(n);
    const CGP::Spin_result r = transformed(
        mesh, condition,
        potential_on_faces(mesh, [&](const Eigen::Vector3d& p) { return rho(p.norm()); }));
    EXPECT_TRUE(r.report) << n << ": " << r.report;
    const Points exact = surface([&](double s) { return rho(s) + gamma; }, n);
    list.push_back({r.report.eigenvalue, mean_Q(r), shape_error(r.positions, exact)});
  }
  return list;
}

std::vector<double> column(const std::vector<Row>& rows, double Row::*field)
{
  std::vector<double> values;
  for (const Row& row : rows) values.push_back(row.*field);
  return values;
}

void expect_second_order_shape(const std::vector<Row>& found, const std::vector<double>& table)
{
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(found[i].shape, table[i], .1 * table[i]) << i;
  expect_order(2, column(found, &Row::shape));
}

void expect_Q(const std::vector<Row>& found, const std::vector<double>& table)
{
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(found[i].Q - 1, table[i] - 1, .02 * (table[i] - 1)) << i;
}

TEST(Surface_of_revolution, of_constant_rho_is_made_of_bessel_functions)
{
  const double c = 2;
  const std::vector<Profile> list = profile([=](double) { return c; }, 4);
  for (std::size_t i = 0; i <= 4; ++i) {
    const double r = static_cast<double>(i) / 4, J0 = std::cyl_bessel_j(0, c * r);
    EXPECT_NEAR(list[i].a, J0, 1e-9);
    EXPECT_NEAR(list[i].b, std::cyl_bessel_j(1, c * r), 1e-9);
    EXPECT_NEAR(list[i].h, (J0 * J0 - 1) / c, 1e-9);
  }
}

TEST(Spin_transformation_between_tangents, finds_the_surface_of_revolution_of_a_bump)
{
  const std::vector<Row> found = rows(Boundary_condition::tangents(), bump);
  expect_second_order_shape(found, {1.32e-3, 3.43e-4, 8.71e-5, 2.19e-5});
  expect_Q(found, {1.03690, 1.01887, 1.00946, 1.00473});
  const std::vector<double> gamma = {.08029, .04182, .02119, .01064};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(found[i].gamma, gamma[i], .02 * gamma[i]);
  expect_order(1, column(found, &Row::gamma));
}

TEST(Spin_transformation_between_tangents, finds_the_surface_of_revolution_of_any_constant)
{
  const auto constant = [](double c) {
    return rows(Boundary_condition::tangents(), [=](double) { return c; });
  };
  const std::vector<Row> one = constant(1), two = constant(2), negative = constant(-1.5);
  expect_Q(one, {1.02786, 1.01390, 1.00693, 1.00346});
  expect_second_order_shape(one, {8.6e-5, 2.1e-5, 5.4e-6, 1.3e-6});
  expect_Q(two, {1.10971, 1.05390, 1.02664, 1.01323});
  expect_second_order_shape(two, {1.0e-3, 2.6e-4, 6.5e-5, 1.6e-5});
  expect_Q(negative, {1.06290, 1.03118, 1.01549, 1.00772});
  expect_order(2, column(negative, &Row::shape));
}

TEST(Spin_transformation_between_binormals, realises_the_bump_up_to_a_constant_with_a_sign)
{
  const double exact = gamma_of_bump(-1, 0);
  EXPECT_NEAR(exact, -.5509978750, 1e-9);
  const std::vector<Row> found = rows(Boundary_condition::binormals(), bump, exact);
  const std::vector<double> gamma = {-.55160, -.55118, -.551045, -.55101};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(found[i].gamma, gamma[i], 1e-5) << i;
  EXPECT_NEAR(found[3].gamma, exact, 1e-4);
  EXPECT_NEAR((found[2].gamma - exact) / (found[3].gamma - exact), 4, .4);
  expect_second_order_shape(found, {8.1e-4, 2.1e-4, 5.3e-5, 1.3e-5});
  expect_Q(found, {1.01244, 1.00650, 1.00328, 1.00164});
}

TEST(Spin_transformation_between_binormals, changes_gamma_by_the_mean_of_rho_and_little_more)
{
  const Mesh_view mesh = cap_from_disk(disk(12), 1);
  Curvature_potential rho = potential_on_vertices(
      mesh, [](const Eigen::Vector3d& p) { return std::cos(3 * p.x()) + p.y() * p.z(); });
  const double mean = CGP::mean(mesh, rho);
  std::vector<double> gamma;
  for (const double t : {.2, .1, .05}) {
    const Curvature_potential with_mean{rho.on, t * rho.values};
    const Curvature_potential without{rho.on, t * (rho.values.array() - mean)};
    gamma.push_back(transformed(mesh, Boundary_condition::binormals(), without).report.eigenvalue);
    const double shifted =
        transformed(mesh, Boundary_condition::binormals(), with_mean).report.eigenvalue;
    EXPECT_NEAR(shifted, gamma.back() - t * mean, .01 * t * t);
  }
  expect_order(2, gamma);
}

}  // namespace cgp_test::spin_transformation_boundary_revolution_tests
