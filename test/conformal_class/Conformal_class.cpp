// Tests include/Conformal_geometry_processing/conformal_class/Conformal_class.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/conformal_class/Conformal_class.h>
#include <Conformal_geometry_processing/measure/distortion.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "support/meshes.h"
#include "support/moebius.h"
#include "support/random.h"
#include "support/tori.h"

namespace cgp_test::conformal_class_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::internal::Conformal_class;

std::vector<Mesh_view> surfaces()
{
  return {icosphere(2),
          bumpy_sphere(3),
          torus(2, 1, 20, 10),
          irregular_torus(2, 1, 24, 12),
          disk(5),
          perturbed(icosphere(1), .3)};
}

double change(const Mesh_view& mesh, const Points& f)
{
  return CGP::length_cross_ratio_change(mesh, f).max;
}

Points stretched(const Mesh_view& mesh, double factor)
{
  Points f = mesh.positions();
  f.row(0) *= factor;
  return f;
}

Points snapped(const Mesh_view& mesh, Points f)
{
  EXPECT_TRUE(Conformal_class(mesh).snap(f).converged);
  return f;
}

TEST(Conformal_class, contains_the_moebius_images_of_a_surface_which_do_not_move)
{
  for (const Mesh_view& mesh : surfaces()) {
    const Points image = inverted(mesh, {.3, .1, 2.5}).positions();
    Points f = image;
    const auto report = Conformal_class(mesh).snap(f);
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(report.iterations, 0);
    EXPECT_EQ(f, image);
  }
}

TEST(Conformal_class, is_reached_from_stretched_and_from_perturbed_surfaces)
{
  for (const Mesh_view& mesh : surfaces())
    for (const Points& f : {stretched(mesh, 1.3), perturbed(mesh, .05).positions(),
                            perturbed(inverted(mesh, {.3, .1, 3.5}), .02).positions()}) {
      EXPECT_GT(change(mesh, f), .05);
      EXPECT_LT(change(mesh, snapped(mesh, f)), 1e-10);
    }
}

TEST(Conformal_class, of_a_bumpy_sphere_has_one_next_to_a_round_one)
{
  const Mesh_view round = icosphere(4), bumpy = bumpy_sphere(4);
  const Points f = snapped(bumpy, round.positions());
  EXPECT_LT(change(bumpy, f), 1e-10);
  EXPECT_LT((f.colwise().norm().array() - 1).abs().maxCoeff(), .05);
}

TEST(Conformal_class, is_reached_by_a_displacement_of_the_order_of_the_distance)
{
  const Mesh_view mesh = bumpy_sphere(3);
  std::vector<double> moved;
  for (const double amount : {1e-2, 1e-3, 1e-4}) {
    const Points f = perturbed(mesh, amount).positions();
    moved.push_back((snapped(mesh, f) - f).norm());
  }
  EXPECT_NEAR(moved[0] / moved[1], 10, 2);
  EXPECT_NEAR(moved[1] / moved[2], 10, .2);
}

TEST(Conformal_class, is_reached_alike_from_moved_and_scaled_surfaces)
{
  const Mesh_view mesh = bumpy_sphere(3);
  const Points f = perturbed(mesh, .05).positions();
  const Eigen::Matrix3d turn =
      7 * Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const Points image = (turn * f).colwise() + Eigen::Vector3d(1, -2, 3);
  const Points expected = (turn * snapped(mesh, f)).colwise() + Eigen::Vector3d(1, -2, 3);
  EXPECT_LT((snapped(mesh, image) - expected).cwiseAbs().maxCoeff(), 1e-8);
}

TEST(Conformal_class, does_not_depend_on_the_scale_of_the_reference)
{
  const Mesh_view mesh = disk(5);
  const Points f = stretched(mesh, 1.2);
  EXPECT_LT((snapped(scaled(mesh, 1e3), f) - snapped(mesh, f)).cwiseAbs().maxCoeff(), 1e-8);
}

TEST(Conformal_class, keeps_each_component_in_its_place_and_those_that_belong_to_it_unmoved)
{
  const Mesh_view a = bumpy_sphere(2), b = torus(2, 1, 20, 10);
  const Mesh_view both = disjoint_union(a, b, {5, 0, 0});
  const int n = a.size_of_vertices(), m = b.size_of_vertices();
  Points f = both.positions();
  f.leftCols(n) = perturbed(a, .03).positions();
  const Points after = snapped(both, f);
  EXPECT_LT(change(both, after), 1e-10);
  EXPECT_LT((after.rightCols(m) - f.rightCols(m)).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_LT((after.leftCols(n).rowwise().mean() - f.leftCols(n).rowwise().mean()).norm(), 1e-12);
}

TEST(Conformal_class, is_reached_again_with_the_factor_at_hand)
{
  const Mesh_view mesh = bumpy_sphere(3);
  Conformal_class conformal_class(mesh);
  CGP::internal::Snap_options options;
  options.keep_factor = true;
  Points f = perturbed(mesh, .01, 1).positions(), g = perturbed(mesh, .001, 2).positions();
  EXPECT_GT(conformal_class.snap(f, options).factorizations, 0);
  const auto again = conformal_class.snap(g, options);
  EXPECT_TRUE(again.converged);
  EXPECT_EQ(again.factorizations, 0);
  EXPECT_LT(change(mesh, g), 1e-10);
}

TEST(Conformal_class, is_reached_with_a_factor_from_afar_where_a_new_one_leads)
{
  // The steps with the old factor take away a part of what is left in each; together they arrive.
  for (const Mesh_view& mesh : {bumpy_sphere(3), irregular_torus(2, 1, 24, 12)}) {
    Conformal_class conformal_class(mesh);
    CGP::internal::Snap_options options;
    options.keep_factor = true;
    Points f = stretched(mesh, 1.1), g = stretched(mesh, 1.15);
    (void)conformal_class.snap(f, options);
    const auto report = conformal_class.snap(g, options);
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(report.factorizations, 0);
    EXPECT_LT(change(mesh, g), 1e-10);
    const Points directly = snapped(mesh, stretched(mesh, 1.15));
    EXPECT_LT((g - directly).norm(), .1 * (directly - stretched(mesh, 1.15)).norm());
  }
}

// A factor that leads there in more than half of the steps that are left is replaced.
TEST(Conformal_class, is_reached_in_few_steps_whatever_the_last_factor_is)
{
  const Mesh_view mesh = bumpy_sphere(3);
  for (const auto& [factor, steps] : {std::pair(1.05, 5), {1.4, 8}, {1.6, 9}}) {
    Conformal_class conformal_class(mesh);
    CGP::internal::Snap_options options;
    Points first = stretched(mesh, 1.1), f = stretched(mesh, factor);
    (void)conformal_class.snap(first, options);
    options.keep_factor = true;
    options.max_iterations = steps;
    EXPECT_TRUE(conformal_class.snap(f, options).converged) << factor;
  }
}

/// residuals that depend linearly on a surface of two vertices
struct Linear_residuals {
  Eigen::MatrixXd A = Eigen::MatrixXd::Random(12, 8);
  Eigen::VectorXd b = Eigen::VectorXd::Random(12);

  CGP::internal::Snap_state at(const Eigen::VectorXd& x) const
  {
    return {x.head(6).reshaped(3, 2), x.tail(2), A * x + b};
  }
};

Eigen::VectorXd unknowns(const CGP::internal::Snap_state& state)
{
  Eigen::VectorXd x(8);
  x << state.f.reshaped(), state.u;
  return x;
}

TEST(Snap_history, leaves_of_linear_residuals_what_no_combination_of_the_last_five_steps_removes)
{
  const Linear_residuals linear;
  CGP::internal::Snap_history history;
  auto state = linear.at(Eigen::VectorXd::Random(8));
  EXPECT_EQ(unknowns(history.extrapolated(state)), unknowns(state));
  Eigen::MatrixXd changes(12, 7);
  for (int k = 0; k < changes.cols(); ++k) {
    const auto next = linear.at(unknowns(state) + Eigen::VectorXd::Random(8));
    history.add(state, next);
    changes.col(k) = next.residuals - state.residuals;
    state = next;
    const auto best = history.extrapolated(state);
    EXPECT_LT((linear.at(unknowns(best)).residuals - best.residuals).norm(), 1e-9);
    EXPECT_LT(best.residuals.norm(), state.residuals.norm());
    for (int j = (std::max)(0, k - 4); j <= k; ++j)
      EXPECT_NEAR(best.residuals.dot(changes.col(j)), 0, 1e-9);
    if (k > 4) {
      EXPECT_GT(std::abs(best.residuals.dot(changes.col(k - 5))), 1e-6);
    }
  }
  history.forget();
  EXPECT_EQ(unknowns(history.extrapolated(state)), unknowns(state));
}

TEST(Conformal_class, needs_no_more_steps_than_the_tolerance_asks_for)
{
  const Mesh_view mesh = bumpy_sphere(3);
  CGP::internal::Snap_options options;
  options.tolerance = 1e-3;
  Points f = stretched(mesh, 1.1);
  const auto report = Conformal_class(mesh).snap(f, options);
  EXPECT_LE(report.residual, 1e-3);
  EXPECT_LE(change(mesh, f), 4e-3);
  options.max_iterations = 1;
  options.tolerance = 0;
  f = stretched(mesh, 1.1);
  EXPECT_FALSE(Conformal_class(mesh).snap(f, options).converged);
}

// A factor of a surface that is far away takes as long to be tried as one that serves.
TEST(Conformal_class, is_reached_without_the_last_factor_from_a_surface_unlike_the_last)
{
  const Mesh_view mesh = bumpy_sphere(3);
  Conformal_class conformal_class(mesh);
  CGP::internal::Snap_options options;
  Points first = perturbed(mesh, .01).positions(), f = stretched(mesh, 1.5), g = f;
  (void)conformal_class.snap(first, options);
  const auto fresh = conformal_class.snap(f, options);
  (void)conformal_class.snap(first = perturbed(mesh, .01).positions(), options);
  options.keep_factor = true;
  const auto again = conformal_class.snap(g, options);
  EXPECT_EQ(again.iterations, fresh.iterations);
  EXPECT_EQ(f, g);
}

TEST(Conformal_class, is_given_up_after_one_factorization_where_only_near_surfaces_are_wanted)
{
  const Mesh_view mesh = bumpy_sphere(3);
  CGP::internal::Snap_options options;
  options.only_near = true;
  const Mesh_view long_one(stretched(mesh, 6), mesh.corners());
  Points near_by = stretched(mesh, 1.05), far_away = perturbed(long_one, .2).positions();
  EXPECT_TRUE(Conformal_class(mesh).snap(near_by, options).converged);
  const auto report = Conformal_class(mesh).snap(far_away, options);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.factorizations, 1);
}

TEST(Conformal_class, is_reached_as_well_as_suffices_where_the_tolerance_cannot_be_had)
{
  const Mesh_view mesh = bumpy_sphere(3);
  CGP::internal::Snap_options options;
  options.tolerance = 0;
  options.sufficient = 1e-3;
  Points f = stretched(mesh, 1.1);
  const auto report = Conformal_class(mesh).snap(f, options);
  EXPECT_TRUE(report.converged);
  EXPECT_LT(report.residual, 1e-6);
  EXPECT_LE(report.iterations, 9);
}

// So far from the origin, coordinates are rounded by 1e-10, nearly 1e-9 of an edge.
TEST(Conformal_class, is_approached_by_few_factorizations_as_far_as_rounding_allows)
{
  const Mesh_view mesh = bumpy_sphere(3);
  Points f = stretched(mesh, 1.01);
  f.row(1).array() += 1e6;
  const auto report = Conformal_class(mesh).snap(f);
  EXPECT_FALSE(report.converged);
  EXPECT_LT(report.residual, 2e-9);
  EXPECT_LE(report.factorizations, 2);
}

TEST(Conformal_class, is_not_reached_from_a_surface_that_has_collapsed)
{
  const Mesh_view mesh = icosphere(1);
  Points f = Points::Zero(3, mesh.size_of_vertices());
  EXPECT_THROW((void)Conformal_class(mesh).snap(f), CGP::Solver_error);
}

/// the logarithm of the distance of two points by that of two others, minus a wanted one
CGP::internal::Global_equation ratio(const std::array<int, 4>& v, double wanted)
{
  const auto value = [v, wanted](const Points& f) {
    return std::log((f.col(v[1]) - f.col(v[0])).norm() / (f.col(v[3]) - f.col(v[2])).norm()) -
           wanted;
  };
  const auto gradient = [v](const Points& f) {
    Points g = Points::Zero(3, f.cols());
    const Eigen::Vector3d a = f.col(v[1]) - f.col(v[0]), b = f.col(v[3]) - f.col(v[2]);
    g.col(v[1]) += a / a.squaredNorm(), g.col(v[0]) -= a / a.squaredNorm();
    g.col(v[3]) -= b / b.squaredNorm(), g.col(v[2]) += b / b.squaredNorm();
    return g;
  };
  return {value, gradient};
}

TEST(Conformal_class, meets_an_equation_beside_it)
{
  for (const Mesh_view& mesh : surfaces()) {
    const int n = mesh.size_of_vertices();
    const std::array<int, 4> v{0, n / 2, n / 3, n - 1};
    const Points before = stretched(mesh, 1.02);
    const Points without = snapped(mesh, before);
    for (const double more : {0., .03}) {
      const auto equation = ratio(v, ratio(v, 0).residual(without) + more);
      Conformal_class same(mesh);
      same.keep(equation);
      Points f = before;
      EXPECT_TRUE(same.snap(f).converged);
      EXPECT_NEAR(equation.residual(f), 0, 1e-10);
      EXPECT_LT(change(mesh, f), 1e-9);
      const double moved = (f - without).cwiseAbs().maxCoeff();
      EXPECT_LT(moved, 2 * more * mesh.positions().cwiseAbs().maxCoeff() + 1e-3);
    }
  }
}

}  // namespace cgp_test::conformal_class_tests
