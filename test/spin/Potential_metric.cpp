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
using On = CGP::Curvature_potential::On;
using System = CGP::internal::Dirac_system;

Eigen::VectorXd heights(const Mesh_view& mesh, On on)
{
  if (on == On::vertices) return mesh.positions().row(1);
  Eigen::VectorXd z(mesh.size_of_faces());
  for (int f = 0; f < z.size(); ++f) {
    z[f] = 0;
    for (const int v : mesh.sheet(f).corners) z[f] += mesh.position(v).y() / 3;
  }
  return z;
}

void expect_inner_product(const Surface_ref& surface, On on)
{
  const System system(surface);
  const Metric metric(system, on, .3);
  const int n = static_cast<int>(metric.areas().size());
  Eigen::MatrixXd d(n, 2);
  d << random_numbers(n, 1), random_numbers(n, 2);
  const Eigen::MatrixXd image = metric.apply(d);
  EXPECT_LT((metric.solve(image) - d).norm(), 1e-9 * d.norm());
  EXPECT_NEAR(d.col(0).dot(image.col(1)), d.col(1).dot(image.col(0)), 1e-10 * image.norm());
  EXPECT_GT(metric.squared_norm(d.col(0)), metric.areas().dot(d.col(0).cwiseAbs2()));
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(n);
  EXPECT_LT((metric.apply(ones) - metric.areas()).norm(), 1e-10 * image.norm());
}

TEST(Potential_metric, is_an_inner_product)
{
  const Mesh_view sphere = perturbed(icosphere(2), .1), torus = btorus(8);
  for (const On on : {On::vertices, On::faces}) {
    expect_inner_product(sphere, on);
    expect_inner_product(CGP::Delaunay_view(sphere), on);
    expect_inner_product(torus, on);
  }
}

// The integral of y^2 over the unit sphere is 4 pi / 3, that of |grad y|^2 is 8 pi / 3.
TEST(Potential_metric, approximates_integrals)
{
  const double unit = 4 * std::acos(-1.) / 3;
  for (const On on : {On::vertices, On::faces})
    for (const double s : {0., .5, 2.}) {
      double before = 0;
      for (const int level : {2, 3}) {
        const Mesh_view mesh = icosphere(level);
        const Metric metric(System(mesh), on, s);
        const double error =
            std::abs(metric.squared_norm(heights(mesh, on)) / (unit * (1 + 2 * s)) - 1);
        EXPECT_LT(error, level > 2 ? .3 * before : .06);
        before = error;
      }
    }
}

TEST(Potential_metric, smooths)
{
  const Mesh_view mesh = perturbed(icosphere(3), .03);
  const System system(mesh);
  for (const On on : {On::vertices, On::faces}) {
    const Metric rough(system, on, 0), smooth(system, on, 1);
    const Eigen::VectorXd b =
        rough.areas().cwiseProduct(random_numbers(static_cast<int>(rough.areas().size()), 1));
    const Eigen::VectorXd d = smooth.solve(b), y = rough.areas().cwiseProduct(heights(mesh, on));
    EXPECT_LT(rough.squared_norm(d), .05 * rough.squared_norm(rough.solve(b)));
    const Eigen::VectorXd of_height = smooth.solve(y);
    EXPECT_NEAR(
        heights(mesh, on).dot(rough.areas().cwiseProduct(of_height)) / heights(mesh, on).dot(y),
        1. / 3, .03);
  }
}

}  // namespace cgp_test::potential_metric_tests
