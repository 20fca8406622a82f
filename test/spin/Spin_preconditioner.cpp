// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Period_residual.h>
#include <Conformal_geometry_processing/spin/Relaxed_positions.h>
#include <Conformal_geometry_processing/spin/Spin_gauge.h>
#include <Conformal_geometry_processing/spin/Spin_preconditioner.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <gtest/gtest.h>

#include "spin/relaxed_surfaces.h"
#include "support/control_points.h"
#include "support/mesh_tools.h"

#include <cstddef>
#include <vector>

namespace cgp_test::spin_preconditioner_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::internal::Period_residual;
using CGP::internal::Spin_preconditioner;

constexpr int few = 8, many = 40;  // holes: 21 and 117 periods

/// a sphere without scattered faces that share no vertices
Mesh_view sieve(int holes)
{
  Mesh_view mesh = icosphere(3);
  std::vector<bool> is_used(static_cast<std::size_t>(mesh.size_of_vertices()));
  for (int f = mesh.size_of_faces() - 1; f >= 0 && holes > 0; f -= 5) {
    bool is_apart = true;
    for (const int v : mesh.corners(f))
      is_apart = is_apart && !is_used[static_cast<std::size_t>(v)];
    if (!is_apart) continue;
    for (const int v : mesh.corners(f)) is_used[static_cast<std::size_t>(v)] = true;
    mesh = without_face(mesh, f);
    --holes;
  }
  return mesh;
}

CGP::Spin_result bent(int holes)
{
  const Mesh_view mesh = sieve(holes);
  CGP::Spin_transformation transformation(mesh);
  return transformation.transform(CGP::Curvature_potential::on_vertices(waves_on(mesh, .5)));
}

TEST(Spin_preconditioner, takes_off_periods_of_few_and_many_holes)
{
  for (const int holes : {few, many}) {
    const Mesh_view mesh = sieve(holes);
    CGP::Spin_transformation transformation(mesh);
    auto& system = transformation.system();
    Period_residual periods(system.surface(), *transformation.closing());
    Spin_preconditioner preconditioner(system, {&periods}, 10, .2);
    Quaternion_vector<double> lambda =
        Quaternion_vector<double>::Constant(mesh.size_of_vertices(), {1, 0, 0, 0});
    lambda += .1 * random_quaternions(mesh.size_of_vertices(), 3);
    periods.set_spins(lambda);
    CGP::internal::Relaxed_costs costs;
    preconditioner.update(lambda, Eigen::VectorXd::Zero(lambda.size()), costs);
    EXPECT_EQ(preconditioner.leaves_few(), holes == many);
    EXPECT_EQ(costs.block_columns > 0, holes == few);
    const Eigen::VectorXd values = periods.values();
    const Eigen::VectorXd taken = periods.change(preconditioner.correction(values, costs));
    EXPECT_LT((taken - values).norm(), .1 * values.norm()) << holes;
  }
}

TEST(Spin_preconditioner, knows_the_few_by_their_columns)
{
  const Mesh_view mesh = sieve(few);
  const int count = mesh.size_of_vertices();
  CGP::Spin_transformation transformation(mesh);
  CGP::internal::Dirac_system& system = transformation.system();
  Period_residual periods(system.surface(), *transformation.closing());
  Spin_preconditioner preconditioner(system, {&periods}, 10, .2);
  const Quaternion_vector<double> lambda =
      Quaternion_vector<double>::Constant(count, {1, 0, 0, 0}) + .1 * random_quaternions(count, 3);
  CGP::internal::Relaxed_costs costs;
  periods.set_spins(lambda);
  preconditioner.update(lambda, Eigen::VectorXd::Zero(count), costs);
  const CGP::internal::Spin_gauge gauge(system);
  const auto y = gauge.projected(lambda, random_quaternions(count, 4));
  const auto expected = gauge.projected_gradient(lambda, periods.gradient(periods.change(y)));
  const Quaternion_vector<double> difference = preconditioner.residual_product(y) - expected;
  EXPECT_GT(CGP::components(expected).norm(), 0);
  EXPECT_LT(CGP::components(difference).norm(), 1e-10 * CGP::components(expected).norm());
}

// With P for (S + G G^T)^-1 and T for S^-1, P + T G G^T P is T.
TEST(Spin_preconditioner, inverts_what_few_residuals_add)
{
  const Mesh_view mesh = btorus(12);
  const int count = mesh.size_of_vertices();
  CGP::Spin_transformation t(mesh);
  Period_residual periods(t.system().surface(), *t.closing());
  const auto points = one_moved(mesh, 5, .2);
  CGP::internal::Position_residual positions(t.system().surface(), t.reconstruction(), points);
  positions.set_targets(t.domain().frame().to_frame(CGP::internal::targets_of(points)));
  positions.set_weight(1e4);
  const Quaternion_vector<double> lambda =
      Quaternion_vector<double>::Constant(count, {1, 0, 0, 0}) + .1 * random_quaternions(count, 3);
  Spin_preconditioner with(t.system(), {&positions, &periods}, 10, .2),
      without(t.system(), {}, 10, .2);
  CGP::internal::Relaxed_costs costs;
  periods.set_spins(lambda);
  positions.set_spins(lambda);
  for (Spin_preconditioner* p : {&without, &with})
    p->update(lambda, Eigen::VectorXd::Zero(count), costs);
  EXPECT_EQ(costs.block_columns, 5 + 2);
  const CGP::internal::Spin_gauge gauge(t.system());
  const auto g = gauge.projected_gradient(lambda, random_quaternions(count, 4));
  const Quaternion_vector<double> y = with.apply(g, costs).col(0),
                                  expected = without.apply(g, costs).col(0),
                                  rest = without.apply(with.residual_product(y), costs).col(0),
                                  difference = y + rest - expected;
  EXPECT_GT(CGP::components(rest).norm(), .01 * CGP::components(expected).norm());
  EXPECT_LT(CGP::components(difference).norm(), 1e-9 * CGP::components(expected).norm());
}

TEST(Spin_preconditioner, closes_surfaces_with_many_holes)
{
  const CGP::Spin_report report = bent(many).report;
  EXPECT_TRUE(report.converged);
  EXPECT_LE(report.period_defect, report.period_limit);
  EXPECT_LT(report.conformality.quasi_conformal.mean, 1.05);
}

TEST(Spin_preconditioner, costs_no_more_solves_for_more_holes)
{
  EXPECT_LT(bent(2 * many).report.solves, 1.5 * bent(many).report.solves);
}

}  // namespace cgp_test::spin_preconditioner_tests
