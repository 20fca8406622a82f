// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Potential_metric.h
#include <Conformal_geometry_processing/mesh/Delaunay_view.h>
#include <Conformal_geometry_processing/spin/Potential_metric.h>

#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.h"

namespace cgp_test::potential_metric_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Surface_ref;
using Metric = CGP::internal::Potential_metric;
using System = CGP::internal::Dirac_system;

Eigen::VectorXd heights(const Mesh_view& mesh)
{
  return mesh.positions().row(1);
}

void expect_inner_product(const Surface_ref& surface)
{
  const System system(surface);
  const Metric metric(system, .3);
  const int n = static_cast<int>(metric.areas().size());
  Eigen::MatrixXd d(n, 2);
  d << random_numbers(n, 1), random_numbers(n, 2);
  const Eigen::MatrixXd image = metric.apply(d);
  EXPECT_NEAR(d.col(0).dot(image.col(1)), d.col(1).dot(image.col(0)), 1e-10 * image.norm());
  EXPECT_GT(metric.squared_norm(d.col(0)), metric.areas().dot(d.col(0).cwiseAbs2()));
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(n);
  EXPECT_LT((metric.apply(ones) - metric.areas()).norm(), 1e-10 * image.norm());
}

TEST(Potential_metric, is_an_inner_product)
{
  const Mesh_view sphere = perturbed(icosphere(2), .1), torus = btorus(8);
  expect_inner_product(sphere);
  expect_inner_product(CGP::Delaunay_view(sphere));
  expect_inner_product(torus);
}

// The integral of y^2 over the unit sphere is 4 pi / 3, that of |grad y|^2 is 8 pi / 3.
TEST(Potential_metric, approximates_integrals)
{
  const double unit = 4 * std::acos(-1.) / 3;
  for (const double s : {0., .5, 2.}) {
    double before = 0;
    for (const int level : {2, 3}) {
      const Mesh_view mesh = icosphere(level);
      const Metric metric(System(mesh), s);
      const double error = std::abs(metric.squared_norm(heights(mesh)) / (unit * (1 + 2 * s)) - 1);
      EXPECT_LT(error, level > 2 ? .3 * before : .06);
      before = error;
    }
  }
}

// With a weight that vanishes.
TEST(Potential_metric, smooths)
{
  const Mesh_view mesh = perturbed(icosphere(3), .03);
  const System system(mesh);
  Metric rough(system, 0), smooth(system, 1);
  for (Metric* metric : {&rough, &smooth}) metric->couple(1e-14);
  const Eigen::VectorXd y = rough.areas().cwiseProduct(heights(mesh));
  const Eigen::VectorXd b = rough.areas().cwiseProduct(random_numbers(mesh.size_of_vertices(), 1));
  const Eigen::VectorXd d = smooth.solve_coupled(b), of_height = smooth.solve_coupled(y);
  EXPECT_LT((smooth.apply(d) - b).norm(), 1e-6 * b.norm());
  EXPECT_LT(rough.squared_norm(d), .05 * rough.squared_norm(rough.solve_coupled(b)));
  EXPECT_NEAR(heights(mesh).dot(rough.areas().cwiseProduct(of_height)) / heights(mesh).dot(y),
              1. / 3, .03);
}

}  // namespace cgp_test::potential_metric_tests
