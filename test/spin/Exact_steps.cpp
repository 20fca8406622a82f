// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Exact_steps.h
#include <Conformal_geometry_processing/mesh/mean_edge_length.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/spin/spin_structure.h>
#include <Conformal_geometry_processing/spin/transformed_edges.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "support/dense.h"
#include "support/figure_eight_torus.h"
#include "support/handlebodies.h"
#include "support/meshes.h"

namespace cgp_test::exact_steps_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;
using Transformation = CGP::Spin_transformation;
using On = Curvature_potential::On;

// A test function that is independent of the surface.
double wave(const Eigen::Vector3d& x)
{
  return std::sin(3 * x[0] + 1) * std::cos(2 * x[1]) + 0.5 * std::sin(4 * x[2]);
}

Curvature_potential wave(const Mesh_view& mesh, double amplitude, On on = On::vertices)
{
  const bool on_vertices = on == On::vertices;
  Eigen::VectorXd rho(on_vertices ? mesh.size_of_vertices() : mesh.size_of_faces());
  for (int i = 0; i < rho.size(); ++i) {
    const auto v = on_vertices ? std::array<int, 3>{i, i, i} : mesh.corners(i);
    rho[i] =
        amplitude * wave((mesh.position(v[0]) + mesh.position(v[1]) + mesh.position(v[2])) / 3);
  }
  return {on, rho};
}

CGP::Spin_result transformed(const Mesh_view& mesh, const Curvature_potential& rho,
                             const CGP::Spin_transformation_options& options = {})
{
  return Transformation(mesh, options).transform(rho);
}

double distortion(const CGP::Spin_result& result)
{
  return result.report.conformality.quasi_conformal.mean - 1;
}

TEST(Exact_steps, of_a_sphere_are_a_single_one_to_the_bit)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const CGP::Spin_result expected = CGP::Spin_transformation(mesh).step(wave(mesh, 1));
  const CGP::Spin_result result = transformed(mesh, wave(mesh, 1));
  EXPECT_EQ(result.positions, expected.positions);
  EXPECT_EQ(result.lambda, expected.lambda);
  EXPECT_EQ(result.report.steps, 1);
  EXPECT_EQ(result.report.reached, 1);
  EXPECT_EQ(result.report.missing_share, 0);
}

TEST(Exact_steps, does_not_shear_a_torus_as_plain_spin_transformations_do)
{
  const Mesh_view mesh = torus(0.7, 0.3, 60, 30);
  for (const On on : {On::vertices, On::faces}) {
    CGP::Spin_transformation_options plain;
    plain.exactness.reset();
    const CGP::Spin_result result = transformed(mesh, wave(mesh, 1, on));
    EXPECT_TRUE(result.report);
    EXPECT_LT(distortion(result), 0.06);
    EXPECT_GT(distortion(transformed(mesh, wave(mesh, 1, on), plain)), 0.4);
    EXPECT_GT(result.report.missing_share, 0.3);
    EXPECT_LT(result.report.missing_share, 0.9);
    EXPECT_LE(result.report.period_defect, .25 * distortion(result));
  }
}

TEST(Exact_steps, shear_less_than_the_mesh_does_however_fine_it_is)
{
  std::vector<double> h, regular, irregular;
  for (const int n : {24, 48, 96}) {
    const Mesh_view mesh = torus(1, .4, 2 * n, n);
    h.push_back(CGP::mean_edge_length(mesh));
    regular.push_back(distortion(transformed(mesh, wave(mesh, .5))));
    const Mesh_view moved = irregular_torus(1, .4, 2 * n, n);
    irregular.push_back(distortion(transformed(moved, wave(moved, .5))));
  }
  EXPECT_NEAR(slope(h, regular), 1, .1);
  EXPECT_NEAR(slope(h, irregular), 1, .1);
  EXPECT_LT(regular.back(), .01);
}

TEST(Exact_steps, come_within_every_tolerance)
{
  const Mesh_view mesh = torus(1, 0.4, 40, 16);
  int steps = 0;
  for (const double tolerance : {0.05, 0.01, 0.002}) {
    CGP::Spin_transformation_options options;
    options.max_period_defect = tolerance;
    const CGP::Spin_result result = transformed(mesh, wave(mesh, 1.5), options);
    EXPECT_TRUE(result.report);
    EXPECT_GE(result.report.steps, steps);
    EXPECT_LE(result.report.period_defect, tolerance);
    EXPECT_EQ(result.report.reached, 1);
    steps = result.report.steps;
  }
  EXPECT_GT(steps, 2);
}

TEST(Exact_steps, applies_all_of_a_rho_that_lets_the_surface_close)
{
  // Twice around the tube: orthogonal to all that moves the ends of its loops, by symmetry.
  const Mesh_view mesh = torus(1, 0.4, 48, 24);
  Eigen::VectorXd rho(mesh.size_of_vertices());
  for (int i = 0; i < rho.size(); ++i)
    rho[i] = 0.1 * std::cos(4 * std::atan2(mesh.position(i)[1], mesh.position(i)[0]));
  const CGP::Spin_result result = transformed(mesh, Curvature_potential::on_vertices(rho));
  EXPECT_EQ(result.report.steps, 1);
  EXPECT_LT(result.report.missing_share, 1e-6);
  EXPECT_GT((result.positions - mesh.positions()).cwiseAbs().maxCoeff(), 0.01);
}

TEST(Exact_steps, comes_to_the_same_surface_in_one_step_and_in_several)
{
  const Mesh_view mesh = torus(1, 0.4, 48, 24);
  CGP::Spin_transformation_options one, several;
  one.max_period_defect = 1;
  several.max_period_defect = 5e-5;
  const Curvature_potential rho = wave(mesh, .3);
  const CGP::Spin_result a = transformed(mesh, rho, one), b = transformed(mesh, rho, several);
  ASSERT_EQ(a.report.steps, 1);
  ASSERT_GT(b.report.steps, 2);
  EXPECT_LT((a.positions - b.positions).norm(), .1 * (a.positions - mesh.positions()).norm());
}

TEST(Exact_steps, measures_the_missing_share_in_the_mean_square_without_the_mean)
{
  const Mesh_view mesh = torus(1, 0.4, 40, 16);
  const Eigen::VectorXd A = CGP::vertex_areas(mesh), w = wave(mesh, .02).values;
  const auto norm = [&](const Eigen::VectorXd& rho) {
    return std::sqrt(A.dot((rho.array() - A.dot(rho) / A.sum()).square().matrix()));
  };
  const auto missing = [&](const Eigen::VectorXd& rho) {
    const CGP::Spin_result result = transformed(mesh, Curvature_potential::on_vertices(rho));
    EXPECT_EQ(result.report.steps, 1);
    // The two parts are orthogonal up to what closing removes of second order.
    EXPECT_NEAR(std::hypot(result.report.realised_share, result.report.missing_share), 1, 1e-2);
    return result.report.missing_share * norm(rho);
  };
  const Eigen::VectorXd closable = Eigen::VectorXd::NullaryExpr(w.size(), [&](Eigen::Index i) {
    return .05 * std::cos(4 * std::atan2(mesh.position(int(i))[1], mesh.position(int(i))[0]));
  });
  const double of_wave = missing(w);
  EXPECT_GT(of_wave, .1 * norm(w));
  EXPECT_NEAR(missing(w + closable), of_wave, 1e-3 * of_wave);
  EXPECT_NEAR(missing(w.array() + .03), of_wave, .1 * of_wave);
  const auto constant = Curvature_potential::on_vertices(Eigen::VectorXd::Constant(w.size(), .7));
  EXPECT_EQ(transformed(mesh, constant).report.missing_share, 0);
  EXPECT_EQ(transformed(mesh, constant).report.realised_share, 1);
}

TEST(Exact_steps, tells_the_spins_of_the_whole_way)
{
  const Mesh_view mesh = torus(1, 0.4, 60, 24);
  CGP::Spin_transformation_options options;
  options.max_period_defect = 0.005;
  const CGP::Spin_result result = transformed(mesh, wave(mesh, 1), options);
  ASSERT_GT(result.report.steps, 1);
  const Mesh_view after(result.positions, mesh.corners());
  const Eigen::MatrixX3d edges = CGP::transformed_edges(mesh, result.lambda);
  double error = 0, total = 0;
  for (int k = 0; k < mesh.size_of_edges(); ++k) {
    const Eigen::Vector3d e = after.position(mesh.ends(k)[1]) - after.position(mesh.ends(k)[0]);
    error += (edges.row(k).transpose() - e).squaredNorm();
    total += e.squaredNorm();
  }
  EXPECT_LT(std::sqrt(error / total), 0.03);
  EXPECT_NEAR(
      result.report.closure_residual,
      CGP::internal::closure_residual(mesh, CGP::cotan_weights(mesh), result.positions, edges),
      1e-10);
  double least = HUGE_VAL, greatest = 0;
  for (const Quaternion<double>& q : result.lambda) {
    least = std::min(least, norm(q));
    greatest = std::max(greatest, norm(q));
  }
  EXPECT_NEAR(result.report.min_spin_ratio, least / greatest, 1e-12);
  EXPECT_NEAR(area(after), area(mesh), 1e-10 * area(mesh));
  EXPECT_EQ(result.report.conformality.flipped_faces, 0);
}

TEST(Exact_steps, keeps_the_spin_structure_embedded_or_not)
{
  for (const int arf : {0, 1}) {
    const Mesh_view mesh = turned_torus(64, 32, arf == 1, arf);
    const CGP::internal::Spin_structure before = CGP::spin_structure(mesh);
    EXPECT_EQ(before.arf_invariant(), arf);
    const CGP::Spin_result result = transformed(mesh, wave(mesh, .3));
    EXPECT_TRUE(result.report) << arf;
    EXPECT_GT((result.positions - mesh.positions()).cwiseAbs().maxCoeff(), .05) << arf;
    EXPECT_EQ(CGP::spin_structure({result.positions, mesh.corners()}), before) << arf;
  }
}

TEST(Exact_steps, keeps_genus_two_and_three_closed)
{
  for (const int genus : {2, 3}) {
    const Mesh_view mesh = smooth_handlebody(genus, 2);
    const CGP::Spin_result result = transformed(mesh, wave(mesh, 0.5));
    EXPECT_TRUE(result.report) << genus;
    EXPECT_LT(distortion(result), 0.12) << genus;
    EXPECT_LE(result.report.period_defect, 0.02) << genus;
  }
}

TEST(Exact_steps, says_how_far_it_has_come)
{
  const Mesh_view mesh = torus(1, 0.4, 48, 24);
  CGP::Spin_transformation_options options;
  options.max_period_defect = 1e-9;  // isothermic: no rho is that exact
  options.min_step = 0.3;
  const CGP::Spin_result none = transformed(mesh, wave(mesh, 1), options);
  EXPECT_FALSE(none.report);
  EXPECT_EQ(none.report.reached, 0);
  EXPECT_EQ(none.report.steps, 0);
  options.max_period_defect = 5e-3;
  options.min_step = 0.15;
  const CGP::Spin_result some = transformed(mesh, wave(mesh, 8), options);
  EXPECT_LT(some.report.reached, 1);
}

TEST(Exact_steps, are_none_of_them_below_the_minimum)
{
  const Mesh_view mesh = torus(1, 0.4, 24, 12);
  CGP::Spin_transformation_options options;
  options.max_period_defect = 2e-3;
  for (const double least : {.02, .1, .15}) {
    options.min_step = least;
    const CGP::Spin_result result = transformed(mesh, wave(mesh, 2), options);
    const double all_but_the_last = (result.report.steps - 1) * least;
    EXPECT_LE(all_but_the_last, result.report.reached * (1 + 1e-12)) << least;
    EXPECT_GT(result.report.steps, 1) << least;
  }
}

TEST(Exact_steps, can_be_cancelled_in_a_later_step)
{
  const Mesh_view mesh = torus(1, 0.4, 20, 10);
  CGP::Spin_transformation_options options;
  options.max_period_defect = 1e-3;
  int calls = 0;
  const CGP::Spin_result result =
      Transformation(mesh, options)
          .transform(wave(mesh, 1), {},
                     [&](const CGP::Eigensolver_progress&) { return ++calls < 12; });
  EXPECT_TRUE(result.report.cancelled);
  EXPECT_FALSE(result.report);
}

TEST(Exact_steps, gives_the_same_bits_twice)
{
  const Mesh_view mesh = torus(1, 0.4, 20, 10);
  const CGP::Spin_result a = transformed(mesh, wave(mesh, 1)), b = transformed(mesh, wave(mesh, 1));
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.lambda, b.lambda);
}

TEST(Exact_steps, refuses_rho_that_does_not_fit)
{
  const Mesh_view mesh = torus(1, 0.4, 10, 6);
  Curvature_potential rho = wave(mesh, 1);
  rho.values[7] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)transformed(mesh, rho), CGP::Precondition_error);
  rho.values = Eigen::VectorXd::Zero(5);
  EXPECT_THROW((void)transformed(mesh, rho), CGP::Precondition_error);
  EXPECT_THROW(Transformation(Mesh_view{}), CGP::Precondition_error);
}

TEST(Exact_steps, does_with_fewer_digits_where_there_are_slivers)
{
  const Mesh_view regular = torus(1, 0.4, 24, 12);
  Points p = regular.positions();
  p.col(1) = p.col(0) + 1e-7 * (p.col(1) - p.col(0));
  const Mesh_view mesh(p, regular.corners());
  const CGP::Spin_result result = transformed(mesh, wave(mesh, 0.5));
  EXPECT_TRUE(result.report);
  EXPECT_LE(result.report.period_defect, 0.02);
}

}  // namespace cgp_test::exact_steps_tests
