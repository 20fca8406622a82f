// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Scale_control.h
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Scale_control.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "support/meshes.h"
#include "support/random.h"

namespace cgp_test::scale_control_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Scale_control, rejects_what_makes_no_sense)
{
  const Mesh_view mesh = icosphere(1);
  const int n = mesh.size_of_vertices();
  const auto make = [&](const CGP::Spin_transformation_options& options) {
    CGP::Spin_transformation transformation(mesh, options);
  };
  CGP::Spin_transformation_options options;
  for (const double bound : {1., 0., -2., std::numeric_limits<double>::infinity()}) {
    options.scales.bound = bound;
    EXPECT_THROW(make(options), CGP::Precondition_error) << bound;
  }
  options.scales.bound = 2;
  options.scales.factors = Eigen::VectorXd::Ones(n - 1);
  EXPECT_THROW(make(options), CGP::Precondition_error);
  options.scales.factors = Eigen::VectorXd::Ones(n);
  options.scales.factors[7] = 0;
  try {
    make(options);
    FAIL();
  } catch (const CGP::Precondition_error& e) {
    EXPECT_NE(std::string(e.what()).find("vertex 7"), std::string::npos) << e.what();
  }
  options.scales.factors.resize(0);
  options.scales.weights = Eigen::VectorXd::Zero(n);
  EXPECT_THROW(make(options), CGP::Precondition_error);
  options.scales.weights[3] = -1;
  EXPECT_THROW(make(options), CGP::Precondition_error);
}

TEST(Scale_control, measures_lengths_at_unchanged_area)
{
  const Mesh_view mesh = icosphere(2);
  const Eigen::VectorXd areas = CGP::vertex_areas(mesh);
  Quaternion_vector<double> lambda =
      Quaternion_vector<double>::Constant(mesh.size_of_vertices(), {0, 3, 0, 0});
  auto scales = CGP::internal::measured_scales(lambda, areas, {2., {}, {}});
  EXPECT_NEAR(scales.low, 1, 1e-12);  // a constant is a similarity
  EXPECT_NEAR(scales.max, 1, 1e-12);
  lambda[0] = lambda[0] * std::sqrt(5.);
  scales = CGP::internal::measured_scales(lambda, areas, {2., {}, {}});
  const double growth = (areas.sum() + 24 * areas[0]) / areas.sum();
  EXPECT_NEAR(scales.max, 5 / std::sqrt(growth), 1e-12);
  EXPECT_NEAR(scales.min, 1 / std::sqrt(growth), 1e-12);
  EXPECT_NEAR(scales.high, 1 / std::sqrt(growth), 1e-12);      // one vertex is less than 1 %
  EXPECT_NEAR(scales.tip_high, 5 / std::sqrt(growth), 1e-12);  // but a tip
  EXPECT_NEAR(scales.excess(), std::log(scales.tip_high) / std::log(3), 1e-12);
  Eigen::VectorXd counted = areas;  // as if it had been a tenth of the surface before
  counted[0] = areas.sum() / 9;
  scales = CGP::internal::measured_scales(lambda, areas, {2., {}, {}, counted});
  EXPECT_NEAR(scales.high, 5 / std::sqrt(growth), 1e-12);
  EXPECT_NEAR(scales.low, 1 / std::sqrt(growth), 1e-12);
}

// By their definition, in a distribution without steps.
TEST(Scale_control, measures_98_and_nearly_all_percent_of_the_area)
{
  const Mesh_view mesh = perturbed(icosphere(4), .05);
  const Eigen::VectorXd areas = CGP::vertex_areas(mesh);
  const auto lambda = random_quaternions(mesh.size_of_vertices(), 3);
  const auto scales = CGP::internal::measured_scales(lambda, areas, {2., {}, {}});
  Eigen::ArrayXd factors = CGP::components(lambda).colwise().squaredNorm().transpose();
  factors /= std::sqrt(areas.dot(factors.square().matrix()) / areas.sum());
  const auto share_beyond = [&](const Eigen::ArrayXd& growth, double line, double slack) {
    return (growth > line * (1 + slack)).select(areas.array(), 0).sum() / areas.sum();
  };
  const double step = 1e-12;
  const auto expect_quantile = [&](const Eigen::ArrayXd& growth, double line, double beyond) {
    EXPECT_LE(share_beyond(growth, line, step), beyond);
    EXPECT_GT(share_beyond(growth, line, -step), beyond);
  };
  expect_quantile(factors, scales.high, .01);
  expect_quantile(factors, scales.tip_high, .001);
  expect_quantile(factors.inverse(), 1 / scales.low, .01);
  expect_quantile(factors.inverse(), 1 / scales.tip_low, .001);
}

TEST(Scale_control, compares_rho_without_its_mean_where_that_has_no_effect)
{
  const auto kept = [](bool is_closed) {
    const Eigen::Vector4d areas(1, 2, 3, 4), rho(4, 4, 4, 5), found(2, 2, 2, 3);
    CGP::Spin_report::Scales scales;
    CGP::internal::measure_kept(rho, found, areas, is_closed, scales);
    return scales;
  };
  EXPECT_NEAR(kept(true).distance(), 0, 1e-7);
  EXPECT_NEAR(kept(false).kept_norm, std::sqrt((6 * 4 + 4 * 9) / (6 * 16 + 4 * 25.)), 1e-14);
  EXPECT_NEAR(kept(false).distance(), std::sqrt(10 * 4 / (6 * 16 + 4 * 25.)), 1e-14);
}

TEST(Scale_control, tells_the_distance_to_rho)
{
  CGP::Spin_report::Scales scales;
  EXPECT_EQ(scales.distance(), 0);
  scales.kept_norm = .5;
  EXPECT_NEAR(scales.distance(), .5, 1e-15);
  scales.kept_norm = 1;
  scales.kept_correlation = 0;
  EXPECT_NEAR(scales.distance(), std::sqrt(2.), 1e-15);
}

}  // namespace cgp_test::scale_control_tests
