// Tests spin/Nearest_spin_transformation.h
// Tests spin/spin_structure.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/spin/Nearest_spin_transformation.h>
#include <Conformal_geometry_processing/spin/spin_structure.h>

#include <gtest/gtest.h>

#include "support/bends.h"
#include "support/bounded_meshes.h"
#include "support/spheres.h"

namespace cgp_test::nearest_spin_transformation_targets_tests {

namespace CGP = Conformal_geometry_processing;

/// mean quasi-conformal errors: of a target, of its spins integrated, and of the nearest surface
struct Errors {
  double target, direct, nearest, distance;
};

Errors errors(const Mesh_view& mesh, const Mesh_view& target,
              const Eigen::Vector3d& direction = {1, 0, 0})
{
  CGP::Nearest_spin_options options;
  options.direction = direction;
  options.keep_curvature = true;
  CGP::Nearest_spin_transformation near(mesh, target.positions(), "test", options);
  const CGP::Nearest_spin_result result = near.transform();
  EXPECT_TRUE(result.report);
  EXPECT_EQ(near.sign_conflicts(), 0);
  EXPECT_EQ(result.report.conformality.flipped_faces, 0);
  return {CGP::quasi_conformal_error(mesh, target.positions()).mean,
          near.blend(result, 1).report.conformality.quasi_conformal.mean,
          result.report.conformality.quasi_conformal.mean, result.distance};
}

/// Up to 2 % of the difference from 1
void expect_error(double error, double expected)
{
  EXPECT_NEAR(error - 1, expected - 1, 0.02 * (expected - 1));
}

TEST(Nearest_spin_transformation_to, a_bend_of_90_degrees)
{
  const Mesh_view mesh = beam(8);
  const Errors e = errors(mesh, bent_beam(mesh, pi / 2, 0.5));
  expect_error(e.target, 1.099);
  expect_error(e.direct, 1.063);
  expect_error(e.nearest, 1.0064);
}

TEST(Nearest_spin_transformation_to, a_twist_of_90_degrees_is_nearly_the_beam_itself)
{
  const Mesh_view mesh = beam(8), target = twisted_beam(mesh, pi / 2);
  const Errors e = errors(mesh, target);
  expect_error(e.target, 1.129);
  expect_error(e.direct, 1.122);
  EXPECT_LT(e.nearest, 1.0025);
  CGP::Nearest_spin_options options;
  options.keep_curvature = true;
  CGP::Nearest_spin_transformation near(mesh, target.positions(), "test", options);
  const double from_beam = CGP::align(near.transform().positions, mesh.positions()).rms;
  EXPECT_LT(from_beam, e.distance / 2);
}

TEST(Nearest_spin_transformation_to, a_bent_ellipsoid_is_conformal_to_the_sphere)
{
  const Mesh_view mesh = icosphere(4);
  const Errors e = errors(mesh, mapped(mesh, [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
                            return {p.x() + 0.3 * p.z() * p.z(), p.y(), 1.6 * p.z()};
                          }));
  EXPECT_GT(e.target, 1.4);
  EXPECT_GT(e.direct, 1.1);
  EXPECT_LT(e.nearest, 1.01);
  EXPECT_LT(e.distance, 0.08);
}

TEST(Nearest_spin_transformation_to, a_target_of_a_disk_that_is_not_conformal)
{
  const Eigen::Vector3d T(1, 0, 0), B(0, 0, 1);
  const auto expect_errors = [&](int n, const Eigen::Vector3d& direction, double expected) {
    const Mesh_view mesh = disk(n);
    const Errors e =
        errors(mesh,
               mapped(mesh,
                      [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
                        const double x = p.x(), y = p.y(), square = (x - 0.2) * (x - 0.2) + y * y;
                        return {1.3 * x, y + 0.1 * x * x, 0.35 * std::exp(-5 * square)};
                      }),
               direction);
    expect_error(e.target, 1.3111);
    expect_error(e.direct, 1.0406);
    expect_error(e.nearest, expected);
    EXPECT_NEAR(e.distance, 0.033, 0.002);
  };
  expect_errors(16, T, 1.01019);
  expect_errors(32, T, 1.00518);
  expect_errors(16, B, 1.01012);
  expect_errors(32, B, 1.00514);
}

TEST(Nearest_spin_transformation_to, a_cap_comes_nearer_by_second_order)
{
  std::vector<double> h, distances;
  for (int n : {8, 16, 32}) {
    const Mesh_view mesh = disk(n);
    h.push_back(1. / n);
    distances.push_back(errors(mesh, cap_from_disk(mesh, 1.2)).distance);
  }
  EXPECT_LT(distances.back(), 5e-5);
  EXPECT_GT(slope(h, distances), 1.9);
}

TEST(Nearest_spin_transformation_to, a_bend_of_324_degrees_needs_signs)
{
  const Mesh_view mesh = beam(8), target = bent_beam(mesh, 324 * pi / 180);
  Points normals(3, mesh.size_of_faces());
  for (int f = 0; f < mesh.size_of_faces(); ++f) normals.col(f) = target.double_area_vector(f);
  const auto of_single_faces = CGP::vertex_spins(mesh, CGP::face_spins(mesh, target.positions()));
  const CGP::Spin_result naive = CGP::Spin_transformation(mesh).integrate(of_single_faces);
  CGP::Nearest_spin_options options;
  options.keep_curvature = true;
  CGP::Nearest_spin_transformation near(mesh, target.positions(), "test", options);
  const CGP::Nearest_spin_result nearest = near.transform(), direct = near.blend(nearest, 1);
  const auto flips = [&](const Points& positions) {
    return CGP::flipped_faces(mesh, positions, normals);
  };
  EXPECT_GT(naive.report.conformality.quasi_conformal.max, 20);
  EXPECT_GT(flips(naive.positions), 0);
  EXPECT_LT(direct.report.conformality.quasi_conformal.max, 1.6);
  EXPECT_LT(nearest.report.conformality.quasi_conformal.max, 1.06);
  EXPECT_EQ(flips(direct.positions), 0);
  EXPECT_EQ(nearest.report.conformality.flipped_faces, 0);
}

}  // namespace cgp_test::nearest_spin_transformation_targets_tests
