// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Period_residual.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <gtest/gtest.h>

#include "spin/moebius_images.h"
#include "support/handlebodies.h"
#include "support/meshes.h"

#include <cmath>
#include <vector>

namespace cgp_test::period_residual_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;
using CGP::internal::Closed_spins;
using On = Curvature_potential::On;
using Transformation = CGP::Spin_transformation;

const std::vector<Circle> holes{{{.2, .1}, .3}, {{-.45, -.3}, .2}};

std::vector<Mesh_view> surfaces_with_loops()
{
  return {btorus(24), irregular_torus(1, .4, 36, 18), smooth_handlebody(2, 2),
          cylinder(1, 1, 24, 6)};
}

/// the exact part of a wave in space
Eigen::VectorXd exact_wave(Transformation& transformation, double amplitude)
{
  const Points& x = transformation.positions();
  Eigen::VectorXd rho(x.cols());
  for (int v = 0; v < rho.size(); ++v)
    rho[v] = amplitude *
             (std::sin(3 * x(0, v) + 1) * std::cos(2 * x(1, v)) + .5 * std::sin(4 * x(2, v)));
  return transformation.exactness(On::vertices).basis().project_out(rho);
}

TEST(Period_residual, has_one_column_for_each_loop)
{
  for (const Mesh_view& mesh : surfaces_with_loops()) {
    Transformation transformation(mesh);
    const auto& exactness = transformation.exactness(On::vertices);
    CGP::internal::Period_residual periods(transformation.system().surface(), exactness);
    periods.set_spins(random_quaternions(mesh.size_of_vertices(), 3));
    const CGP::internal::Spin_columns c = periods.columns();
    EXPECT_EQ(c.columns.cols(), exactness.forms->size());
    const auto gradients = CGP::combination(c.columns, c.factors);
    ASSERT_EQ(gradients.cols(), periods.values().size());
    for (Eigen::Index k = 0; k < gradients.cols(); ++k) {
      const Quaternion_vector<double> g =
          periods.gradient(Eigen::VectorXd::Unit(gradients.cols(), k));
      const Quaternion_vector<double> difference = gradients.col(k) - g;
      EXPECT_LT(CGP::components(difference).norm(), 1e-12 * CGP::components(g).norm()) << k;
    }
  }
}

/// a step by an exact wave, closed up to a limit
CGP::Spin_result wave(const Mesh_view& mesh, double amplitude, double limit)
{
  CGP::Spin_transformation_options options;
  options.max_period_defect = limit;
  Transformation transformation(mesh, options);
  return transformation.closed_step(exact_wave(transformation, amplitude));
}

/// a step whose spins are closed, with its rho, in the frame
struct Closing {
  Transformation transformation;
  CGP::Spin_result open;
  Eigen::VectorXd rho;

  Closing(const Mesh_view& mesh, double amplitude) : transformation(mesh)
  {
    const Eigen::VectorXd wanted = exact_wave(transformation, amplitude);
    transformation.dirac().tolerance = 1e-11;
    open = transformation.trial_step({On::vertices, wanted});
    rho = transformation.domain().unit() * (wanted.array() + open.report.eigenvalue).matrix();
  }

  Closed_spins closed(double limit, const Quaternion<double>& factor = {1, 0, 0, 0})
  {
    Quaternion_vector<double> lambda = open.lambda;
    for (auto& q : lambda) q = q * factor;
    return CGP::internal::closed_spins(transformation.system(),
                                       transformation.exactness(On::vertices), rho, lambda, limit);
  }

  double norm(const Eigen::VectorXd& d) const
  {
    return std::sqrt(transformation.system().areas().dot(d.cwiseAbs2()));
  }
};

TEST(Closed_spins, are_those_of_the_step_where_the_limit_holds)
{
  Transformation transformation(btorus(16));
  const Eigen::VectorXd rho = exact_wave(transformation, .2);
  const CGP::Spin_result step = wave(btorus(16), .2, 1);
  EXPECT_EQ(step.positions, transformation.step({On::vertices, rho}).positions);
  EXPECT_GT(step.report.period_defect, 0);
}

TEST(Closed_spins, have_nothing_to_close_on_spheres_and_disks)
{
  for (const Mesh_view& mesh : {bumpy_sphere(2), disk(6)}) {
    Transformation transformation(mesh);
    const Curvature_potential rho{On::vertices, exact_wave(transformation, .5)};
    const CGP::Spin_result step = wave(mesh, .5, 1e-12);
    EXPECT_EQ(step.positions, transformation.step(rho).positions);
    EXPECT_EQ(step.report.period_defect, 0);
  }
}

TEST(Closed_spins, close_up_to_any_limit_without_a_factorization)
{
  for (const Mesh_view& mesh : surfaces_with_loops()) {
    const CGP::Spin_report open = wave(mesh, .25, 1).report, closed = wave(mesh, .25, 1e-6).report;
    EXPECT_GT(open.period_defect, 1e-4);
    EXPECT_LE(closed.period_defect, 1e-6);
    EXPECT_EQ(closed.factorizations, open.factorizations);
    EXPECT_LT(closed.closure_residual, open.closure_residual);
  }
}

TEST(Closed_spins, leave_defects_of_second_order_and_the_first_change_takes_nearly_all_of_them)
{
  const std::vector<double> amplitudes = {.4, .2, .1};
  std::vector<double> open;
  for (const double amplitude : amplitudes) {
    Closing closing(smooth_handlebody(2, 2), amplitude);
    open.push_back(closing.closed(1).period_defect);
    EXPECT_LT(closing.closed(open.back() / 2).period_defect, .1 * amplitude * open.back());
  }
  EXPECT_NEAR(slope(amplitudes, open), 2, .1);
}

TEST(Closed_spins, change_rho_by_what_is_of_second_order)
{
  const std::vector<double> amplitudes = {.2, .1, .05};
  std::vector<double> changes;
  for (const double amplitude : amplitudes) {
    Closing closing(irregular_torus(1, .6, 24, 18), amplitude);
    changes.push_back(closing.norm(closing.closed(1e-8).rho - closing.rho));
  }
  EXPECT_NEAR(slope(amplitudes, changes), 2, .2);
}

TEST(Closed_spins, are_near_the_eigenvector_of_the_rho_that_they_tell)
{
  const std::vector<double> amplitudes = {.4, .2, .1};
  std::vector<double> errors;
  for (const double amplitude : amplitudes) {
    Closing closing(btorus(16), amplitude);
    Transformation& t = closing.transformation;
    const Closed_spins closed = closing.closed(1e-8);
    const CGP::Spin_result of_rho = t.trial_step({On::vertices, closed.rho / t.domain().unit()});
    errors.push_back(std::sqrt(1 - std::pow(t.system().overlap(closed.lambda, of_rho.lambda), 2)));
  }
  EXPECT_LT(errors[0], 1e-3);
  EXPECT_GT(slope(amplitudes, errors), 2.9);
}

TEST(Closed_spins, do_not_depend_on_the_gauge)
{
  Closing closing(btorus(16), .3);
  const Quaternion<double> factor{1, -.5, .25, 2};
  const Closed_spins closed = closing.closed(1e-7), turned = closing.closed(1e-7, factor);
  EXPECT_NEAR(closing.transformation.system().overlap(closed.lambda, turned.lambda), 1, 1e-10);
  EXPECT_LT(closing.norm(closed.rho - turned.rho), 1e-4 * closing.norm(closed.rho - closing.rho));
  EXPECT_EQ(closed.solves, turned.solves);
}

TEST(Closed_spins, turn_directions_as_prescribed)
{
  for (const Eigen::Vector3d& tnb : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 0, 1)}) {
    const Moebius_image moebius(.12, 3, holes);
    CGP::Spin_transformation_options options;
    options.boundary = moebius.directions(tnb);
    options.max_period_defect = 1e-5;
    Transformation t(moebius.source, options);
    (void)t.exactness(On::vertices);
    (void)t.take_unreported();
    const CGP::Spin_result open = t.trial_step(moebius.rho()),
                           closed = t.closed_step(moebius.rho().values);
    const double before = t.exactness(On::vertices)
                              .period_defect(CGP::transformed_edges(moebius.source, open.lambda));
    EXPECT_GT(before, 1e-3);
    EXPECT_LE(closed.report.period_defect, 1e-5);
    EXPECT_LT(closed.report.direction_error.mean, 2 * open.report.direction_error.mean);
    EXPECT_EQ(closed.report.factorizations, open.report.factorizations);
  }
}

// Symmetric surfaces are isothermic: one of the six functions vanishes in the limit, so that one of
// the periods does not obey.
TEST(Closed_spins, are_the_best_where_no_rho_moves_the_periods)
{
  const Mesh_view mesh = torus(1, .4, 48, 24);
  const double open = wave(mesh, .25, 1).report.period_defect;
  const CGP::Spin_report report = wave(mesh, .25, 1e-9).report;
  EXPECT_LT(report.period_defect, open / 10);
  EXPECT_GT(report.period_defect, 1e-9);
  EXPECT_TRUE(report.converged);
}

TEST(Closed_spins, come_with_a_report_of_the_changed_equation)
{
  const Mesh_view mesh = btorus(16);
  const CGP::Spin_report open = wave(mesh, .3, 1).report, closed = wave(mesh, .3, 1e-6).report;
  EXPECT_NE(closed.dirac_residual, open.dirac_residual);
  EXPECT_NEAR(closed.dirac_residual, open.dirac_residual, .05 * open.dirac_residual);
  EXPECT_NEAR(closed.eigenvalue, open.eigenvalue, .05);
  EXPECT_TRUE(closed);
}

TEST(Closed_spins, are_not_looked_for_after_a_step_that_was_cancelled)
{
  Transformation transformation(btorus(12));
  const Eigen::VectorXd rho = exact_wave(transformation, .5);
  const auto stop = [](const CGP::Eigensolver_progress&) { return false; };
  const CGP::Spin_result step = transformation.closed_step(rho, stop);
  EXPECT_TRUE(step.report.cancelled);
  EXPECT_EQ(step.report.period_defect, 0);
}

CGP::Quaternion_vector<double> around_one(int n, double size, int seed)
{
  CGP::Quaternion_vector<double> lambda = random_quaternions(n, seed);
  for (auto& q : lambda) q = size * q + CGP::Quaternion<double>{1, 0, 0, 0};
  return lambda;
}

TEST(Period_residual, has_its_derivative_and_its_transpose)
{
  const Mesh_view mesh = btorus(12);
  CGP::Spin_transformation transformation(mesh);
  CGP::internal::Period_residual periods(transformation.system().surface(),
                                         *transformation.closing());
  periods.set_weight(3);
  const int n = mesh.size_of_vertices();
  const auto lambda = around_one(n, .1, 1), d = random_quaternions(n, 2);
  const auto values_at = [&](double h) {
    auto there = lambda;
    CGP::components(there) += h * CGP::components(d);
    periods.set_spins(there);
    return periods.values();
  };
  const double h = 1e-5;
  const Eigen::VectorXd slope = (values_at(h) - values_at(-h)) / (2 * h), now = values_at(0);
  const Eigen::VectorXd change = periods.change(d);
  // The length of the edges counts as constant.
  const Eigen::VectorXd turned = slope - now * (now.dot(slope - change) / now.squaredNorm());
  EXPECT_LT((turned - change).norm(), 1e-5 * change.norm());
  const Eigen::VectorXd y = random_numbers(static_cast<int>(change.size()), 3);
  EXPECT_NEAR(y.dot(change), inner_product(periods.gradient(y), d).w,
              1e-11 * y.norm() * change.norm());
}

}  // namespace cgp_test::period_residual_tests
