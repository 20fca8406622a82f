// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Constrained_direction.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "flow_tools.h"

namespace cgp_test::constrained_direction_tests {

struct Prescribed {
  Eigen::VectorXd values;
  Eigen::VectorXd operator()(const Mesh_view&) const { return values; }
};

/// the direction of one surface
template <class Direction>
struct Directed {
  Directed(const Mesh_view& mesh_, Direction direction, const CGP::Flow_options& options = {})
      : mesh(mesh_),
        transformation(mesh),
        constrained(transformation, direction, options, nullptr, "f"),
        areas(CGP::vertex_areas(mesh))
  {}
  auto operator()() { return constrained(mesh); }

  Mesh_view mesh;
  CGP::Spin_transformation transformation;
  CGP::internal::Constrained_direction constrained;
  Eigen::VectorXd areas;
};

std::string refusal(const Eigen::VectorXd& values)
{
  const Mesh_view mesh = icosphere(1);
  Directed<Prescribed> directed(mesh, {values});
  try {
    (void)directed();
  } catch (const CGP::Precondition_error& error) {
    return error.what();
  }
  return "";
}

Eigen::VectorXd harmonic(const Mesh_view& sphere, int k)
{
  Eigen::VectorXd Y(sphere.size_of_vertices());
  for (int v = 0; v < Y.size(); ++v) Y[v] = legendre(k, sphere.position(v).z());
  return Y;
}

TEST(Constrained_direction, has_no_mean_and_no_part_along_the_normals)
{
  const Mesh_view mesh = bumpy_sphere(2);
  Directed<CGP::Willmore_direction> directed(mesh, {});
  const auto result = directed();
  EXPECT_NEAR(directed.areas.dot(result.v), 0, 1e-12);
  EXPECT_LT((CGP::vertex_normals(mesh, CGP::internal::Normal_weight::angle) *
             directed.areas.cwiseProduct(result.v))
                .norm(),
            1e-12);
  EXPECT_NEAR(result.norm, std::sqrt(directed.areas.dot(result.v.cwiseAbs2())), 1e-12);
  EXPECT_NEAR(result.share,
              result.norm / std::sqrt(directed.areas.dot(CGP::mean_curvature(mesh).cwiseAbs2())),
              1e-12);
}

TEST(Constrained_direction, leaves_what_is_allowed_as_it_is)
{
  const Mesh_view mesh = icosphere(3);
  const Eigen::VectorXd v = harmonic(mesh, 3);
  Directed<Prescribed> directed(mesh, {v});
  EXPECT_LT((directed().v - v).cwiseAbs().maxCoeff(), 1e-3);
  EXPECT_NEAR(directed().share, 1, 1e-5);
}

TEST(Constrained_direction, is_nothing_where_everything_is_forbidden)
{
  const Mesh_view mesh = icosphere(2);
  const Eigen::VectorXd z = mesh.positions().row(2).transpose();  // the normal of a sphere
  Directed<Prescribed> forbidden(mesh, {Eigen::VectorXd((z.array() + 3).matrix())});
  EXPECT_LT(forbidden().share, 0.01);
  Directed<Prescribed> none(mesh, {Eigen::VectorXd::Zero(z.size())});
  EXPECT_EQ(none().share, 0);
}

TEST(Constrained_direction, has_vanished_where_little_is_left_of_it_or_of_the_curvature_of_a_sphere)
{
  decltype(std::declval<Directed<Prescribed>>()()) all;
  all.share = 1;
  const double of_spheres = 2 * std::sqrt(pi);  // whose mean curvature is the root of 4 pi / area
  all.norm = .0099 * of_spheres;
  EXPECT_TRUE(all.has_vanished(.01));
  all.norm = .0101 * of_spheres;
  EXPECT_FALSE(all.has_vanished(.01));
  all.share = .0099;
  EXPECT_TRUE(all.has_vanished(.01));
}

TEST(Constrained_direction, is_orthogonal_to_what_opens_handles)
{
  const Mesh_view mesh = btorus(16);
  Directed<CGP::Willmore_direction> directed(mesh, {});
  const auto result = directed();
  const Eigen::MatrixXd functions =
      directed.transformation.exactness(CGP::Curvature_potential::On::vertices).functions;
  const Eigen::VectorXd products = functions.transpose() * directed.areas.cwiseProduct(result.v);
  EXPECT_LT(products.norm(), 1e-10);
  const Eigen::VectorXd part = directed.constrained.exact_part(random_numbers(256, 1));
  EXPECT_LT((functions.transpose() * directed.areas.cwiseProduct(part)).norm(), 1e-10);
  EXPECT_NEAR(directed.areas.dot(part), 0, 1e-12);
}

TEST(Constrained_direction, is_filtered_by_the_gain_of_each_frequency)
{
  const Mesh_view mesh = icosphere(4);
  CGP::Flow_options options;
  options.filter_weight = 1. / 30;
  for (const int k : {2, 6, 10}) {
    const double l = k * (k + 1), gain = l / 30 / (1 + l / 30);
    Directed<Prescribed> directed(mesh, {harmonic(mesh, k)}, options);
    EXPECT_NEAR(directed().share, gain, 0.02 * gain) << k;
  }
}

TEST(Constrained_direction, cannot_be_found_on_a_surface_that_has_collapsed)
{
  Mesh_view mesh = torus(2, 1, 12, 8);
  Directed<Prescribed> directed(mesh, {random_numbers(96, 1)});
  Points line = mesh.positions();  // nearly: every face has an area
  line.bottomRows(2) *= 1e-9;
  directed.transformation.set_positions(line);
  EXPECT_THROW((void)directed(), CGP::Solver_error);
}

TEST(Constrained_direction, refuses_what_is_no_function_on_the_vertices)
{
  EXPECT_NE(refusal(Eigen::VectorXd::Ones(41)).find("f: the direction has 41 values"),
            std::string::npos);
  Eigen::VectorXd v = Eigen::VectorXd::Ones(42);
  v[7] = std::numeric_limits<double>::infinity();
  EXPECT_NE(refusal(v).find("vertex 7"), std::string::npos);
}

}  // namespace cgp_test::constrained_direction_tests
