// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Potential_search.h
// Tests spin/Spin_residual.h spin/Scale_residual.h spin/Period_residual.h
// Tests spin/Exactness_residual.h
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Exactness_residual.h>
#include <Conformal_geometry_processing/spin/Period_residual.h>
#include <Conformal_geometry_processing/spin/Potential_metric.h>
#include <Conformal_geometry_processing/spin/Potential_search.h>
#include <Conformal_geometry_processing/spin/Scale_residual.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/spin/log_scales.h>
#include <Conformal_geometry_processing/spin/transformed_edges.h>

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <utility>

#include "support/meshes.h"

namespace cgp_test::potential_search_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;
using Search = CGP::internal::Potential_search;
using CGP::internal::Scale_residual;

const CGP::internal::Always_go_further always;

Curvature_potential waves(const Mesh_view& mesh, double amplitude)
{
  Eigen::VectorXd rho(mesh.size_of_vertices());
  for (int v = 0; v < rho.size(); ++v)
    rho[v] =
        amplitude * std::sin(4 * mesh.position(v).y() + 1) * std::cos(3 * mesh.position(v).x());
  return Curvature_potential::on_vertices(std::move(rho));
}

double norm(const Eigen::VectorXd& v, const Eigen::VectorXd& areas)
{
  return std::sqrt(areas.dot(v.cwiseAbs2()));
}

TEST(Potential_search, without_residuals_finds_rho_itself)
{
  const Mesh_view mesh = perturbed(icosphere(3), .02);
  CGP::internal::Dirac_system system(mesh);
  const Curvature_potential rho = waves(mesh, 1);
  Search search(system, rho, {});
  EXPECT_TRUE(search.minimize({}, always, 0));
  EXPECT_LT((search.present().rho.values - rho.values).norm(), 1e-12 * rho.values.norm());
  EXPECT_LE(search.present().solution.residual, 1e-8);
}

// The spins of a rho' do not depend on the way to it.
TEST(Potential_search, moves_to_another_rho)
{
  const Mesh_view mesh = perturbed(icosphere(3), .02);
  CGP::internal::Dirac_system system(mesh);
  const Curvature_potential there = waves(mesh, 1);
  Search search(system, waves(mesh, .9), {});
  ASSERT_TRUE(search.minimize({}, always, 0));
  ASSERT_TRUE(search.move_to(there, {}, always));
  EXPECT_EQ(search.present().rho.values, there.values);
  const Quaternion_vector<double> found = search.present().solution.lambda;
  EXPECT_NEAR(system.overlap(CGP::solve_dirac_equation(system, there).lambda, found), 1, 1e-8);
  // Too far: the spins have nothing in common with the predicted ones.
  ASSERT_FALSE(search.move_to(waves(mesh, -12), {}, always));
  EXPECT_EQ(search.present().rho.values, there.values);
}

// The scales of a transformation are wanted, and no rho is given: the search finds the rho, up to
// a constant, and up to what the residual does not see at its weight.
TEST(Potential_search, recovers_rho_from_scales)
{
  const Mesh_view mesh = perturbed(icosphere(3), .02);
  CGP::internal::Dirac_system system(mesh);
  const Curvature_potential rho = waves(mesh, .6);
  const auto wanted = CGP::solve_dirac_equation(system, rho);
  const Eigen::VectorXd u = CGP::internal::log_scales(wanted.lambda), areas = system.areas();
  Scale_residual scales(areas, u);
  scales.set_weight(1e4);
  Search search(system, {rho.on, Eigen::VectorXd::Zero(areas.size())}, {&scales}, {}, .01);
  EXPECT_TRUE(search.minimize({}, always, 0));
  Eigen::VectorXd error = CGP::internal::log_scales(search.present().solution.lambda) - u;
  error.array() -= areas.dot(error) / areas.sum();
  EXPECT_LT(norm(error, areas), .02 * norm(u, areas));
}

// A search over weights asks at each of them. The gradient costs four solves, and products with the
// matrix four each: those that K shows to be of no use are not made.
TEST(Potential_search, knows_a_minimum_at_little_cost)
{
  for (const double weight : {1., 30.}) {
    const Mesh_view mesh = perturbed(icosphere(3), .02);
    CGP::internal::Dirac_system system(mesh);
    Scale_residual scales(system.areas(), Eigen::VectorXd::Zero(system.areas().size()));
    scales.set_weight(weight);
    Search search(system, waves(mesh, 1), {&scales});
    ASSERT_TRUE(search.minimize({}, always, 0));
    const Eigen::VectorXd rho = search.present().rho.values;
    search.reset_costs();
    ASSERT_TRUE(search.minimize({}, always, 0));
    EXPECT_EQ(search.present().rho.values, rho);
    EXPECT_EQ(search.costs().factorizations, 0);
    EXPECT_LE(search.costs().solves, 8);
  }
}

// Stationary: the gradient of the sum, by differences of transformations.
TEST(Potential_search, ends_where_the_sum_is_smallest)
{
  const Mesh_view mesh = perturbed(
      mapped(icosphere(2),
             [](const Eigen::Vector3d& p) { return Eigen::Vector3d(p.x(), 2 * p.y(), p.z()); }),
      .02);
  CGP::internal::Dirac_system system(mesh);
  const Curvature_potential rho = waves(mesh, 1);
  const Eigen::VectorXd areas = system.areas();
  Scale_residual scales(areas, Eigen::VectorXd::Zero(areas.size()));
  scales.set_weight(3);
  const double smoothness = .05;
  const CGP::internal::Potential_metric metric(system, rho.on, smoothness / system.unit());
  Search search(system, rho, {&scales}, {}, smoothness);
  ASSERT_TRUE(search.minimize({}, always, 0));
  const Eigen::VectorXd found = search.present().rho.values;
  const auto sum = [&](const Eigen::VectorXd& r) {
    scales.set_spins(CGP::solve_dirac_equation(system, {rho.on, r}).lambda);
    return metric.squared_norm(r - rho.values) + scales.values().squaredNorm();
  };
  const double least = sum(found);
  for (const int seed : {1, 2, 3}) {
    const Eigen::VectorXd d = random_numbers(static_cast<int>(found.size()), seed);
    for (const double step : {-.1, .1}) EXPECT_GT(sum(found + step * d), least);
  }
  for (const double share : {.8, 1.2}) EXPECT_GT(sum(share * found), least);
}

// Rough changes of scale are wanted: rho' is smooth nevertheless.
TEST(Potential_search, changes_rho_smoothly)
{
  const Mesh_view mesh = perturbed(icosphere(2), .02);
  const auto roughness = [&](CGP::Curvature_potential::On on, double smoothness) {
    CGP::internal::Dirac_system system(mesh);
    const int n = mesh.size_of_vertices();
    Scale_residual scales(system.areas(), .1 * random_numbers(n, 5));
    scales.set_weight(300);
    const Eigen::VectorXd areas = CGP::curvature_areas(mesh, on);
    Search search(system, {on, Eigen::VectorXd::Zero(areas.size())}, {&scales}, {}, smoothness);
    EXPECT_TRUE(search.minimize({}, always, 0));
    const Eigen::VectorXd rho = search.present().rho.values;
    const CGP::internal::Potential_metric both(system, on, 1 / system.unit());
    return both.squared_norm(rho) / areas.dot(rho.cwiseAbs2()) - 1;
  };
  for (const auto on : {Curvature_potential::On::vertices, Curvature_potential::On::faces})
    EXPECT_LT(roughness(on, .3), .5 * roughness(on, 0));
}

TEST(Potential_search, keeps_a_torus_closed)
{
  const Mesh_view mesh = btorus(16);
  CGP::Spin_transformation transformation(mesh);
  const Curvature_potential rho = waves(mesh, 1);
  const auto& exactness = transformation.exactness(rho.on);
  auto& system = transformation.system();
  CGP::internal::Period_residual periods(system.surface(), exactness);
  Scale_residual scales(system.areas(), Eigen::VectorXd::Zero(system.areas().size()));
  Search search(system, {rho.on, rho.values * transformation.domain().unit()}, {&scales},
                {&periods});
  EXPECT_TRUE(search.minimize({}, always, 1e-8));
  const auto& lambda = search.present().solution.lambda;
  EXPECT_LT(exactness.period_defect(CGP::transformed_edges(system.surface(), lambda)), 1e-8);
  EXPECT_NEAR(search.present().constraints.norm(),
              exactness.period_defect(CGP::transformed_edges(system.surface(), lambda)), 1e-12);
}

TEST(Potential_search, residuals_have_their_transposes)
{
  const Mesh_view mesh = btorus(12);
  CGP::Spin_transformation transformation(mesh);
  const auto& exactness = transformation.exactness(Curvature_potential::On::vertices);
  const Eigen::VectorXd& areas = transformation.system().areas();
  const int n = mesh.size_of_vertices();
  CGP::internal::Period_residual periods(transformation.system().surface(), exactness);
  Scale_residual scales(areas, random_numbers(n, 1));
  CGP::internal::Exactness_residual inexact(transformation.system().surface(),
                                            transformation.reconstruction());
  inexact.set_weight(3);
  const Quaternion_vector<double> lambda = random_quaternions(n, 2), d = random_quaternions(n, 3);
  for (CGP::internal::Spin_residual* r :
       std::initializer_list<CGP::internal::Spin_residual*>{&periods, &scales, &inexact}) {
    r->set_spins(lambda);
    const Eigen::VectorXd y = random_numbers(static_cast<int>(r->values().size()), 4);
    const Eigen::VectorXd change = r->change(d);
    EXPECT_NEAR(y.dot(change), inner_product(r->gradient(y), d).w,
                1e-12 * y.norm() * change.norm());
  }
}

// Its norm is the closure residual; its change is that of the values at a constant length.
TEST(Potential_search, measures_inexact_edges)
{
  const Mesh_view mesh = perturbed(icosphere(2), .05);
  CGP::Spin_transformation transformation(mesh);
  const CGP::Spin_result r = transformation.transform(waves(mesh, 2));
  const CGP::Surface_ref& surface = transformation.system().surface();
  CGP::internal::Exactness_residual inexact(surface, transformation.reconstruction());
  inexact.set_weight(4);
  const Eigen::VectorXd roots = CGP::cotan_weights(surface).cwiseAbs().cwiseSqrt();
  const Quaternion_vector<double> d = random_quaternions(mesh.size_of_vertices(), 3);
  double length = 0;
  const auto values_at = [&](double t) {
    Quaternion_vector<double> lambda = r.lambda;
    components(lambda) += t * components(d);
    inexact.set_spins(lambda);
    length = (roots.asDiagonal() * CGP::transformed_edges(surface, lambda)).norm();
    return Eigen::VectorXd(inexact.values() * length);
  };
  const double h = 1e-4;
  const Eigen::VectorXd difference = (values_at(h) - values_at(-h)) / (2 * h);
  const Eigen::VectorXd values = values_at(0) / length;
  EXPECT_NEAR(inexact.size(), r.report.closure_residual, 1e-6);
  EXPECT_NEAR(values.norm(), 2 * inexact.size(), 1e-12);
  EXPECT_LT((inexact.change(d) * length - difference).norm(), 1e-8 * difference.norm());
}

}  // namespace cgp_test::potential_search_tests
