// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Spin_transformation.h
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "quaternionic_linear_algebra/threads/threads.h"
#include "support/dense.h"
#include "support/meshes.h"

namespace cgp_test::spin_transformation_invariance_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;

class Invariance_of_spin_transformations : public testing::Test {
 protected:
  CGP::Spin_result transformed(const Mesh_view& surface, const Curvature_potential& potential) const
  {
    return CGP::Spin_transformation(surface).transform(potential);
  }

  /// the result of the mesh and rho multiplied by s, which is the old one multiplied by s
  CGP::Spin_result scaled_back(double s) const
  {
    CGP::Spin_result r = transformed(scaled(mesh, s), {rho.on, rho.values / s});
    r.positions /= s;
    r.report.eigenvalue *= s;
    return r;
  }

  void expect_equal_numbers(const CGP::Spin_report& a, double tolerance) const
  {
    EXPECT_NEAR(a.eigenvalue, expected.report.eigenvalue, tolerance);
    EXPECT_NEAR(a.conformality.quasi_conformal.mean,
                expected.report.conformality.quasi_conformal.mean, tolerance);
    EXPECT_NEAR(a.conformality.quasi_conformal.max,
                expected.report.conformality.quasi_conformal.max, tolerance);
    EXPECT_NEAR(a.min_spin_ratio, expected.report.min_spin_ratio, tolerance);
  }

  const Mesh_view mesh = radially_perturbed(icosphere(2), 0.03);
  const Curvature_potential rho =
      Curvature_potential::on_vertices(rho_of_section_3_on_vertices(mesh));
  const CGP::Spin_result expected = transformed(mesh, rho);
};

double greatest_displacement(const Points& a, const Points& b)
{
  return (a - b).colwise().norm().maxCoeff();
}

TEST_F(Invariance_of_spin_transformations, under_rigid_motion)
{
  Random random(3);
  for (int i = 0; i < 3; ++i) {
    const Eigen::Matrix3d R = random.rotation();
    const Eigen::Vector3d t = 10 * random.vector();
    const auto moved =
        mapped(mesh, [&](const Eigen::Vector3d& p) -> Eigen::Vector3d { return R * p + t; });
    const CGP::Spin_result r = transformed(moved, rho);
    expect_equal_numbers(r.report, 1e-8);
    // The gauge makes the mean of lambda real before and after: the motion goes along.
    EXPECT_LT(greatest_displacement(r.positions, (R * expected.positions).colwise() + t), 1e-7);
  }
}

TEST_F(Invariance_of_spin_transformations, under_scaling_by_powers_of_two_to_the_last_bit)
{
  for (const int exponent : {-100, -7, 5, 99}) {
    const CGP::Spin_result r = scaled_back(std::ldexp(1., exponent));
    EXPECT_EQ(r.positions, expected.positions) << exponent;
    EXPECT_EQ(r.lambda, expected.lambda);
    EXPECT_EQ(r.report.eigenvalue, expected.report.eigenvalue);
    EXPECT_EQ(r.report.iterations, expected.report.iterations);
  }
}

TEST_F(Invariance_of_spin_transformations, under_scaling_by_anything)
{
  for (const double s : {1e-30, 1e-9, 0.3, 1e3, 7e15, 1e30}) {
    const CGP::Spin_result r = scaled_back(s);
    EXPECT_LT(greatest_displacement(r.positions, expected.positions), 1e-9) << s;
    expect_equal_numbers(r.report, 1e-9);
  }
}

TEST_F(Invariance_of_spin_transformations, under_a_far_origin)
{
  const Eigen::Vector3d offset(2e6, -1e6, 1.5e6);  // about a million diameters
  const CGP::Spin_result r =
      transformed({mesh.positions().colwise() + offset, mesh.corners()}, rho);
  EXPECT_LT(greatest_displacement(r.positions.colwise() - offset, expected.positions), 1e-6);
  expect_equal_numbers(r.report, 1e-6);
}

TEST_F(Invariance_of_spin_transformations, under_renumbering_of_vertices)
{
  const std::vector<int> number = random_permutation(mesh.size_of_vertices(), 4);
  Eigen::VectorXd values(mesh.size_of_vertices());
  for (int v = 0; v < mesh.size_of_vertices(); ++v) values[number[at(v)]] = rho.values[v];
  const CGP::Spin_result r =
      transformed(renumbered(mesh, number), Curvature_potential::on_vertices(values));
  Points back(3, mesh.size_of_vertices());
  for (int v = 0; v < mesh.size_of_vertices(); ++v) back.col(v) = r.positions.col(number[at(v)]);
  EXPECT_LT(greatest_displacement(back, expected.positions), 1e-8);
  expect_equal_numbers(r.report, 1e-8);
}

TEST_F(Invariance_of_spin_transformations, under_another_order_of_faces_and_corners)
{
  const std::vector<int> order = random_permutation(mesh.size_of_faces(), 5);
  Corners corners;
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto& v = mesh.corners(order[at(f)]);
    corners.push_back({v[at(f % 3)], v[at((f + 1) % 3)], v[at((f + 2) % 3)]});
  }
  const CGP::Spin_result r = transformed({mesh.positions(), corners}, rho);
  EXPECT_LT(greatest_displacement(r.positions, expected.positions), 1e-8);
  expect_equal_numbers(r.report, 1e-8);
}

TEST_F(Invariance_of_spin_transformations, under_doing_it_again)
{
  CGP::Spin_transformation transformation(mesh);
  for (int i = 0; i < 2; ++i) {
    const CGP::Spin_result r = transformation.transform(rho);
    EXPECT_EQ(r.positions, expected.positions);
    EXPECT_EQ(r.lambda, expected.lambda);
  }
}

// Large enough for several threads to be worth it, in the ordering and in the factorization.
TEST(Spin_transformation_of_a_large_mesh, gives_the_same_bits_for_any_number_of_threads)
{
  const Mesh_view mesh = geodesic_sphere(21);
  const auto rho = Curvature_potential::on_vertices(rho_of_section_3_on_vertices(mesh));
  const CGP::Spin_result one = CGP::Spin_transformation(mesh).transform(rho);
  for (const int threads : {2, 3}) {
    const Threads setting(threads);
    const CGP::Spin_result r = CGP::Spin_transformation(mesh).transform(rho);
    EXPECT_EQ(r.positions, one.positions);
    EXPECT_EQ(r.lambda, one.lambda);
  }
}

}  // namespace cgp_test::spin_transformation_invariance_tests
