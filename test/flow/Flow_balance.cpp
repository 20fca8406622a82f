// Tests include/Conformal_geometry_processing/flow/Moebius_balancing.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Moebius_balancing.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <gtest/gtest.h>

#include <string>

#include "flow_tools.h"
#include "support/moebius.h"

namespace cgp_test::flow_balance_tests {

using Balance = CGP::Flow_options::Balance;
using Balancing = CGP::Flow_options::Balancing;

CGP::Flow_options options_for(Balance balance, Balancing balancing = Balancing::inversion)
{
  CGP::Flow_options options;
  options.balance = balance;
  options.balancing = balancing;
  return options;
}

Mesh_view inverted_torus()
{
  return scaled_to_area(inverted(torus(2, 1, 32, 24), {4, 0.5, 0.3}), 4 * pi);
}

double greatest_log_difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b)
{
  return (a.array() / a.sum() / (b.array() / b.sum())).log().abs().maxCoeff();
}

CGP::internal::Flow_balance balance_of(const Mesh_view& mesh, const CGP::Flow_options& options)
{
  CGP::Spin_transformation transformation(mesh);
  return {mesh, options, transformation, "f"};
}

std::string refusal(const Mesh_view& mesh, const CGP::Flow_options& options)
{
  try {
    (void)balance_of(mesh, options);
  } catch (const CGP::Precondition_error& error) {
    return error.what();
  }
  return "";
}

TEST(Flow_balance, does_nothing_unless_it_is_asked_for)
{
  const Mesh_view mesh = icosphere(1);
  const CGP::internal::Flow_balance balance = balance_of(mesh, {});
  EXPECT_FALSE(balance.is_by_inversion());
  EXPECT_EQ(balance.potential(mesh), Eigen::VectorXd::Zero(42));
}

TEST(Flow_balance, undoes_an_inversion_of_the_surface_it_started_from)
{
  const Mesh_view mesh = torus(2, 1, 32, 24), moved = inverted_torus();
  const CGP::internal::Flow_balance balance = balance_of(mesh, options_for(Balance::initial));
  ASSERT_TRUE(balance.is_by_inversion());
  EXPECT_EQ(balance.potential(moved), Eigen::VectorXd::Zero(mesh.size_of_vertices()));
  const Mesh_view back(balance.inverted(moved), mesh.corners());
  EXPECT_GT(greatest_log_difference(CGP::vertex_areas(moved), CGP::vertex_areas(mesh)), 0.5);
  EXPECT_LT(greatest_log_difference(CGP::vertex_areas(back), CGP::vertex_areas(mesh)), 0.01);
  EXPECT_NEAR(area(back), 4 * pi, 1e-9);
}

TEST(Flow_balance, leads_to_prescribed_areas_the_same)
{
  const Mesh_view mesh = torus(2, 1, 32, 24), moved = inverted_torus();
  CGP::Flow_options options = options_for(Balance::prescribed);
  options.target_areas = 7 * CGP::vertex_areas(mesh);  // only their ratios count
  const CGP::internal::Flow_balance balance = balance_of(moved, options);
  const Mesh_view back(balance.inverted(moved), mesh.corners());
  EXPECT_LT(greatest_log_difference(CGP::vertex_areas(back), CGP::vertex_areas(mesh)), 0.01);
}

TEST(Flow_balance, finds_the_torus_of_revolution_by_its_canonical_metric)
{
  const Mesh_view moved = inverted_torus();
  const CGP::internal::Flow_balance balance = balance_of(moved, options_for(Balance::canonical));
  const Mesh_view back(balance.inverted(moved), moved.corners());
  const Mesh_view round = scaled_to_area(torus(2, 1, 32, 24), 4 * pi);
  EXPECT_LT(greatest_log_difference(CGP::vertex_areas(back), CGP::vertex_areas(round)), 0.15);
}

TEST(Flow_balance, is_a_change_of_curvature_along_one_direction_or_nothing)
{
  const Mesh_view mesh = torus(2, 1, 32, 24), moved = inverted_torus();
  const CGP::internal::Flow_balance balance =
      balance_of(mesh, options_for(Balance::initial, Balancing::potential));
  EXPECT_FALSE(balance.is_by_inversion());
  EXPECT_LT(balance.potential(mesh).norm(), 1e-12);
  const Points N = CGP::vertex_normals(moved, CGP::internal::Normal_weight::angle);
  const Eigen::VectorXd rho = balance.potential(moved);
  const Eigen::Vector3d a = -(N * N.transpose()).ldlt().solve(N * rho) / 2;
  EXPECT_GT(a.norm(), 0.05);
  EXPECT_LT((rho + 2 * N.transpose() * a).norm(), 1e-9);
}

TEST(Flow_balance, refuses_areas_that_are_none)
{
  CGP::Flow_options options = options_for(Balance::prescribed);
  EXPECT_NE(refusal(icosphere(1), options).find("f: 0 target areas"), std::string::npos);
  options.target_areas = Eigen::VectorXd::Ones(42);
  options.target_areas[5] = 0;
  EXPECT_NE(refusal(icosphere(1), options).find("target area of vertex 5"), std::string::npos);
}

TEST(Flow_balance, refuses_the_canonical_metric_of_a_sphere)
{
  EXPECT_NE(
      refusal(icosphere(1), options_for(Balance::canonical)).find("f: the surface is a sphere"),
      std::string::npos);
}

TEST(Flow_balance, refuses_surfaces_with_boundary)
{
  EXPECT_NE(refusal(without_face(icosphere(1), 3), options_for(Balance::initial))
                .find("f: 3 boundary edges"),
            std::string::npos);
}

}  // namespace cgp_test::flow_balance_tests
