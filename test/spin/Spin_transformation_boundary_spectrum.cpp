// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Spin_transformation.h
// Tests include/Conformal_geometry_processing/spin/Dirac_solution.h
#include "spin/boundary_tools.h"

namespace cgp_test::spin_transformation_boundary_spectrum_tests {

/// The spectrum of D on the flat unit disk with its own binormals: the zeros of J_n and of J_n',
/// with both signs. Those of n = 0 belong to surfaces of revolution.

double bessel(int n, double x)
{
  return n < 0 ? -std::cyl_bessel_j(1, x) : std::cyl_bessel_j(n, x);  // J_-1 = -J_1
}

double bessel_derivative(int n, double x)
{
  return (bessel(n - 1, x) - std::cyl_bessel_j(n + 1, x)) / 2;
}

/// the zero of f within .05 of x
template <class Function>
double zero_near(double x, Function f)
{
  double low = x - .05, high = x + .05;
  const bool falls = f(low) > 0;
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    ((f(middle) > 0) == falls ? low : high) = middle;
  }
  return low;
}

double zero_of_bessel(int n, double near)
{
  return zero_near(near, [=](double x) { return bessel(n, x); });
}

double zero_of_bessel_derivative(int n, double near)
{
  return zero_near(near, [=](double x) { return bessel_derivative(n, x); });
}

/// the eigenvector of D whose eigenvalue is nearest to s
CGP::Spin_result nearest_to(const Mesh_view& disk, double s)
{
  CGP::Dirac_options options;
  options.branch = CGP::Dirac_options::Branch::smallest;
  return transformed(disk, Boundary_condition::binormals(), constant_potential(disk, s), options);
}

void expect_eigenvalue(double exact, double shift)
{
  std::vector<double> errors;
  for (const int n : {8, 16, 32}) {
    const CGP::Spin_result r = nearest_to(disk(n), shift);
    EXPECT_TRUE(r.report.converged);
    errors.push_back(r.report.eigenvalue + shift - exact);
  }
  EXPECT_LT(std::abs(errors[2]), 2.5e-3 * std::abs(exact)) << exact;
  expect_order(2, {errors[1], errors[2]});
}

TEST(Dirac_disk, has_the_zeros_of_bessel_functions_as_eigenvalues)
{
  expect_eigenvalue(zero_of_bessel(0, 2.40483), 2.4);
}

TEST(Dirac_disk, has_the_zeros_of_their_derivatives_as_eigenvalues)
{
  expect_eigenvalue(zero_of_bessel_derivative(1, 1.84118), 1.84);
  expect_eigenvalue(zero_of_bessel_derivative(2, 3.05424), 3.05);
  expect_eigenvalue(zero_of_bessel_derivative(3, 4.20119), 4.2);
}

TEST(Dirac_disk, has_eigenvalues_of_both_signs)
{
  expect_eigenvalue(-zero_of_bessel(0, 2.40483), -2.4);
  expect_eigenvalue(-zero_of_bessel_derivative(1, 1.84118), -1.84);
}

// With binormals tilted by t, its spins are J_0(g r) and J_1(g r), with J_1(g) = tan(t / 2) J_0(g).
TEST(Dirac_disk, between_tilted_binormals_has_a_constant_that_makes_up_for_that_of_rho)
{
  const double t = pi / 6;
  const double g =
      zero_near(.52, [t](double x) { return bessel(1, x) - std::tan(t / 2) * bessel(0, x); });
  for (const double rho : {0., .5, 1.}) {
    std::vector<double> errors;
    for (const int n : {8, 16, 32}) {
      const Mesh_view mesh = disk(n);
      const auto tilted =
          at_boundary(mesh, [t](const Eigen::Vector3d&, const auto& frame) -> Eigen::Vector3d {
            return std::cos(t) * frame.col(2) + std::sin(t) * frame.col(1);
          });
      CGP::Spin_result r =
          transformed(mesh, Boundary_condition::binormals(tilted), constant_potential(mesh, rho));
      EXPECT_TRUE(r.report);
      r.report.limits.gamma_radius = 1.2;
      errors.push_back(r.report.gamma_radius() - (-g - rho));
      EXPECT_EQ(r.report.fault() == CGP::Spin_report::Fault::curvature, rho > .9);
    }
    EXPECT_LT(std::abs(errors.back()), .01);
  }
}

TEST(Dirac_disk, becomes_the_surface_of_revolution_with_bessel_functions)
{
  const double g = zero_of_bessel(0, 2.40483);
  const std::vector<double> table_shape = {6.0e-4, 1.5e-4, 3.8e-5, 9.5e-6},
                            table_Q = {1.15108, 1.07302, 1.03586, 1.01776};
  std::vector<double> shape;
  for (std::size_t i = 0; i < 4; ++i) {
    const Mesh_view mesh = disk(8 << i);
    const Points exact =
        mapped(mesh, [=](const Eigen::Vector3d& p) -> Eigen::Vector3d {
          const double J0 = bessel(0, g * p.norm()), J1 = bessel(1, g * p.norm());
          return (J0 * J0 + J1 * J1) * p + Eigen::Vector3d(0, 0, (J0 * J0 - 1) / g);
        }).positions();
    const CGP::Spin_result r = nearest_to(mesh, g);
    shape.push_back(shape_error(r.positions, exact));
    EXPECT_NEAR(shape.back(), table_shape[i], .1 * table_shape[i]);
    expect_Q(r, table_Q[i]);
  }
  expect_order(2, shape);
}

}  // namespace cgp_test::spin_transformation_boundary_spectrum_tests
