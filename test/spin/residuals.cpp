// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests spin/Spin_residual.h spin/Period_residual.h
#include <Conformal_geometry_processing/spin/Period_residual.h>
#include <Conformal_geometry_processing/spin/Spin_residual.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.h"

namespace cgp_test::residuals_tests {

namespace CGP = Conformal_geometry_processing;
using Spins = Quaternion_vector<double>;

/// a torus and residuals on it, with weights
struct Residuals {
  Mesh_view mesh = btorus(12);
  CGP::Spin_transformation transformation{mesh};
  CGP::internal::Period_residual periods{
      transformation.system().surface(),
      transformation.exactness(CGP::Curvature_potential::On::vertices)};
  CGP::internal::Scale_residual scales{transformation.system().areas(),
                                       random_numbers(mesh.size_of_vertices(), 1)};
  CGP::internal::Nearness_residual nearness{3 * transformation.system().areas()};
  CGP::internal::Spin_residuals all{&periods, &scales, &nearness};

  Residuals()
  {
    periods.set_weight(4);
    scales.set_weight(2);
  }
};

TEST(Residuals, have_their_transposes)
{
  Residuals residuals;
  const int n = residuals.mesh.size_of_vertices();
  const Spins d = random_quaternions(n, 3);
  for (CGP::internal::Spin_residual* r : residuals.all) {
    r->set_spins(random_quaternions(n, 2));
    const Eigen::VectorXd y = random_numbers(static_cast<int>(r->values().size()), 4);
    const Eigen::VectorXd change = r->change(d);
    EXPECT_NEAR(y.dot(change), inner_product(r->gradient(y), d).w,
                1e-12 * y.norm() * change.norm());
  }
}

// That of periods is without the length of the edges, which counts as constant.
TEST(Residuals, know_their_derivatives)
{
  Residuals residuals;
  const int n = residuals.mesh.size_of_vertices();
  const double h = 1e-5;
  Spins lambda = .2 * random_quaternions(n, 2);
  for (auto& q : lambda) q.w += 1;
  const Spins d = .1 * random_quaternions(n, 3);
  for (CGP::internal::Spin_residual* r : residuals.all) {
    if (r->is_few()) continue;
    const auto at = [&](double t) {
      r->set_spins(lambda + t * d);
      return r->values();
    };
    const Eigen::VectorXd difference = (at(h) - at(-h)) / (2 * h);
    r->set_spins(lambda);
    EXPECT_LT((r->change(d) - difference).norm(), 1e-8 * difference.norm());
  }
}

TEST(Residuals, are_the_roots_of_their_weights)
{
  Residuals residuals;
  const Spins lambda = random_quaternions(residuals.mesh.size_of_vertices(), 2);
  const Eigen::VectorXd before = values_at(lambda, residuals.all);
  residuals.periods.set_weight(16);
  residuals.scales.set_weight(8);
  residuals.nearness.scale(4);
  EXPECT_LT((values_at(lambda, residuals.all) - 2 * before).norm(), 1e-12 * before.norm());
}

}  // namespace cgp_test::residuals_tests
