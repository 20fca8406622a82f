// Tests include/Quaternionic_linear_algebra/algebra/Moebius_map.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>
#include <Quaternionic_linear_algebra/algebra/Moebius_map.h>

#include <gtest/gtest.h>

#include <Eigen/QR>

#include <limits>

#include "support/meshes.h"

namespace cgp_test::moebius_map_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::imaginary;
using CGP::Moebius_map;
using CGP::norm;
using Eigen::Vector3d;

constexpr Quaternion<double> one = {1, 0, 0, 0};

/// f^-1 of the quaternions, for a vector
Vector3d inverted(const Vector3d& f)
{
  return -f / f.squaredNorm();
}

Moebius_map some_map(std::uint64_t seed)
{
  Random random(seed);
  const Vector3d c = .2 * random.vector();
  return Moebius_map::translation(random.vector()) * Moebius_map::rotation(random.quaternion()) *
         Moebius_map::sphere_inversion(c) * Moebius_map::translation(.5 * random.vector());
}

std::string message(const Moebius_map& map, const Points& points)
{
  try {
    map.transform(points, "test");
  } catch (const CGP::Precondition_error& e) {
    return e.what();
  }
  return "";
}

TEST(Moebius_map, is_the_identity_at_first)
{
  EXPECT_EQ(Moebius_map()(Vector3d(1, 2, 3)), Vector3d(1, 2, 3));
  EXPECT_EQ(Moebius_map().spin(Vector3d(1, 2, 3)), one);
}

TEST(Moebius_map, translates_rotates_and_scales)
{
  const Vector3d p(1, 2, 3);
  EXPECT_EQ(Moebius_map::translation({4, -1, 0})(p), Vector3d(5, 1, 3));
  EXPECT_LT((Moebius_map::scaling(9)(p) - 9 * p).norm(), 1e-14);
  // cos 45 - sin 45 k turns by +90 degrees about z
  const double r = std::sqrt(.5);
  EXPECT_LT((Moebius_map::rotation({r, 0, 0, -r})(p) - Vector3d(-2, 1, 3)).norm(), 1e-14);
  EXPECT_LT((Moebius_map::rotation({2 * r, 0, 0, -2 * r})(p) - Vector3d(-8, 4, 12)).norm(), 1e-14);
}

TEST(Moebius_map, inverts_in_the_unit_sphere_and_reflects_in_its_centre)
{
  EXPECT_LT((Moebius_map::inversion()(Vector3d(1, 2, 2)) - Vector3d(-1, -2, -2) / 9).norm(), 1e-16);
}

TEST(Moebius_map, of_a_sphere_inversion_is_a_translation_between_two_inversions)
{
  Random random(2);
  for (int i = 0; i < 20; ++i) {
    const Vector3d f = random.vector(), c = .5 * random.vector();
    const Moebius_map map = Moebius_map::sphere_inversion(c);
    EXPECT_LT((map(f) - inverted(inverted(f) - c)).norm(), 1e-13);
    // (1 - c f) lambda = 1
    const Quaternion<double> product = (one - imaginary(c) * imaginary(f)) * map.spin(f);
    EXPECT_LT(norm(product - one), 1e-15);
  }
  EXPECT_EQ(Moebius_map::sphere_inversion({.3, .2, 1})(Vector3d(0, 0, 0)), Vector3d(0, 0, 0));
}

TEST(Moebius_map, composes_as_functions_do)
{
  const Moebius_map A = some_map(1), B = some_map(2);
  Random random(3);
  for (int i = 0; i < 20; ++i) {
    const Vector3d f = random.vector();
    EXPECT_LT(((A * B)(f)-A(B(f))).norm(), 1e-11);
    // conjugate(mu) conjugate(lambda) df lambda mu
    EXPECT_LT(norm((A * B).spin(f) - B.spin(f) * A.spin(B(f))), 1e-11);
  }
}

TEST(Moebius_map, is_undone_by_its_inverse)
{
  const Moebius_map A = some_map(4);
  Random random(5);
  for (int i = 0; i < 20; ++i) {
    const Vector3d f = random.vector();
    EXPECT_LT((A.inverse()(A(f)) - f).norm(), 1e-12);
    EXPECT_LT((A(A.inverse()(f)) - f).norm(), 1e-12);
  }
}

TEST(Moebius_map, maps_the_difference_of_any_two_points_exactly_by_the_spins_at_both)
{
  const Moebius_map map = some_map(6);
  Random random(7);
  for (int i = 0; i < 20; ++i) {
    const Vector3d f = random.vector(), g = random.vector();
    const Quaternion<double> expected = conjugate(map.spin(f)) * imaginary(g - f) * map.spin(g);
    EXPECT_LT(norm(imaginary(map(g) - map(f)) - expected), 1e-12);
  }
}

TEST(Moebius_map, has_the_derivative_of_a_spin_transformation)
{
  const Moebius_map map = some_map(8);
  const Vector3d f(.3, -.2, .4), e = Vector3d(2, 1, -2) / 3;
  std::vector<double> h, error;
  for (double step : {.04, .02, .01}) {
    const Vector3d difference = map(f + step / 2 * e) - map(f - step / 2 * e);
    h.push_back(step);
    error.push_back((difference / step - CGP::spin(map.spin(f), e)).norm());
  }
  EXPECT_NEAR(slope(h, error), 2, .02);
}

TEST(Moebius_map, keeps_the_length_cross_ratios_of_every_mesh)
{
  for (const Mesh_view& mesh : {bumpy_sphere(2), torus(2, 1, 20, 10), disk(5)})
    EXPECT_LT(CGP::length_cross_ratio_change(mesh, some_map(9).transform(mesh.positions())).max,
              1e-12);
}

TEST(Moebius_map, takes_spheres_to_spheres)
{
  const Points p = some_map(10).transform(icosphere(2).positions());
  // |p|^2 = 2 <m, p> + r^2 - |m|^2 is linear in the unknowns
  Eigen::MatrixX4d A(p.cols(), 4);
  A << 2 * p.transpose(), Eigen::VectorXd::Ones(p.cols());
  const Eigen::VectorXd b = p.colwise().squaredNorm().transpose();
  EXPECT_LT((A * A.colPivHouseholderQr().solve(b) - b).norm(), 1e-12 * b.norm());
}

TEST(Moebius_map, keeps_the_orientation_of_space)
{
  const Moebius_map map = some_map(11) * Moebius_map::inversion();
  const Vector3d f(.6, .2, -.5);
  const double h = 1e-5;
  Eigen::Matrix3d jacobian;
  for (int i = 0; i < 3; ++i)
    jacobian.col(i) = (map(f + h * Vector3d::Unit(i)) - map(f - h * Vector3d::Unit(i))) / (2 * h);
  EXPECT_GT(jacobian.determinant(), 0);
}

TEST(Moebius_map, turns_a_surface_inside_out_whose_inside_has_the_pole)
{
  Mesh_view mesh = icosphere(2);
  mesh.set_positions(Moebius_map::sphere_inversion({.4, 0, 0}).transform(mesh.positions()));
  EXPECT_GT(CGP::mean_curvature(mesh).minCoeff(), 0);
  mesh.set_positions(Moebius_map::inversion().transform(icosphere(2).positions()));
  EXPECT_LT(CGP::mean_curvature(mesh).maxCoeff(), 0);
}

TEST(Moebius_map, comes_from_its_matrix_up_to_a_factor)
{
  const Vector3d c(.1, .3, -.2), f(.4, 1, .1);
  const Moebius_map map({3, 0, 0, 0}, {}, -3. * imaginary(c), {3, 0, 0, 0});
  EXPECT_LT((map(f) - Moebius_map::sphere_inversion(c)(f)).norm(), 1e-15);
  EXPECT_LT(norm(map.spin(f) - Moebius_map::sphere_inversion(c).spin(f)), 1e-15);
}

TEST(Moebius_map, refuses_matrices_that_leave_space)
{
  const Quaternion<double> i = {0, 1, 0, 0}, zero;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Moebius_map(one, one, zero, one), CGP::Precondition_error);    // f -> f + 1
  EXPECT_THROW(Moebius_map(one, zero, one, one), CGP::Precondition_error);    // f (f + 1)^-1
  EXPECT_THROW(Moebius_map(i, zero, zero, one), CGP::Precondition_error);     // f -> i f
  EXPECT_THROW(Moebius_map(-one, zero, zero, one), CGP::Precondition_error);  // f -> -f
  EXPECT_THROW(Moebius_map(zero, zero, zero, zero), CGP::Precondition_error);
  EXPECT_THROW(Moebius_map(one, zero, zero, {nan, 0, 0, 0}), CGP::Precondition_error);
}

TEST(Moebius_map, refuses_points_that_go_to_infinity_by_their_number)
{
  const Vector3d c(.3, .2, -.25), pole = inverted(c);
  const Moebius_map map = Moebius_map::sphere_inversion(c);
  EXPECT_THROW(map(pole), CGP::Precondition_error);
  EXPECT_THROW(map.spin(pole), CGP::Precondition_error);
  Points p = icosphere(1).positions();
  p.col(17) = pole + 1e-12 * Vector3d::UnitX();
  const std::string refusal =
      "test: point 17 goes to infinity or is not finite; the map must send no point there";
  EXPECT_EQ(message(map, p), refusal);
  EXPECT_THROW(map.spins(p), CGP::Precondition_error);
  p.col(17).setConstant(std::numeric_limits<double>::infinity());
  EXPECT_EQ(message(map, p), refusal);
  EXPECT_EQ(message(Moebius_map(), p), refusal);
  p.col(17).setConstant(1e-3);
  EXPECT_EQ(message(map, p), "");
}

}  // namespace cgp_test::moebius_map_tests
