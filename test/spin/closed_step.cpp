// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/closed_step.h
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/spin/closed_step.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/bounded_meshes.h"
#include "support/handlebodies.h"
#include "support/meshes.h"

namespace cgp_test::closed_step_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;
using CGP::internal::Closed_step;
using On = Curvature_potential::On;
using Transformation = CGP::Spin_transformation;

/// the exact part of a wave in space
Curvature_potential exact_wave(Transformation& transformation, double amplitude,
                               On on = On::vertices)
{
  const Mesh_view mesh(transformation.positions(), transformation.domain().mesh().corners());
  Eigen::VectorXd rho(on == On::vertices ? mesh.size_of_vertices() : mesh.size_of_faces());
  for (int i = 0; i < rho.size(); ++i) {
    const Eigen::Vector3d x = mesh.position(on == On::vertices ? i : mesh.corners(i)[0]);
    rho[i] = amplitude * (std::sin(3 * x[0] + 1) * std::cos(2 * x[1]) + .5 * std::sin(4 * x[2]));
  }
  return {on, transformation.exactness(on).basis().project_out(rho)};
}

Closed_step closed(Transformation& transformation, const Curvature_potential& rho, double limit)
{
  return CGP::internal::closed_step(transformation, rho, {limit, 1e-8}, 1, {},
                                    CGP::internal::Always_go_further());
}

/// the defects of steps of several sizes, with as many changes of rho as the limit wants
std::vector<double> defects(const Mesh_view& mesh, const std::vector<double>& amplitudes,
                            double limit, On on = On::vertices)
{
  std::vector<double> list;
  for (const double amplitude : amplitudes) {
    Transformation transformation(mesh);
    const Curvature_potential rho = exact_wave(transformation, amplitude, on);
    list.push_back(closed(transformation, rho, limit).result.report.period_defect);
  }
  return list;
}

TEST(closed_step, is_the_plain_one_where_the_limit_holds)
{
  Transformation transformation(btorus(16));
  const Curvature_potential rho = exact_wave(transformation, .2);
  const Closed_step step = closed(transformation, rho, 1);
  const CGP::Spin_result expected = transformation.step(rho);
  EXPECT_EQ(step.result.positions, expected.positions);
  EXPECT_EQ(step.rho.values, rho.values);
  EXPECT_GT(step.result.report.period_defect, 0);
}

TEST(closed_step, of_a_sphere_has_nothing_to_close)
{
  Transformation transformation(bumpy_sphere(2));
  const Curvature_potential rho = exact_wave(transformation, 1);
  const Closed_step step = closed(transformation, rho, 1e-12);
  EXPECT_EQ(step.result.positions, transformation.step(rho).positions);
  EXPECT_EQ(step.result.report.period_defect, 0);
}

TEST(closed_step, closes_up_to_any_limit)
{
  for (const Mesh_view& mesh :
       {btorus(24), irregular_torus(1, .4, 36, 18), smooth_handlebody(2, 2), cylinder(1, 1, 24, 6)})
    for (const On on : {On::vertices, On::faces}) {
      EXPECT_GT(defects(mesh, {.25}, 1, on)[0], 1e-4);
      EXPECT_LE(defects(mesh, {.25}, 1e-6, on)[0], 1e-6);
    }
}

TEST(closed_step, leaves_defects_of_second_order_and_each_change_takes_one_order_more)
{
  const std::vector<double> amplitudes = {.2, .1, .05};
  const Mesh_view mesh = smooth_handlebody(2, 2);
  const std::vector<double> plain = defects(mesh, amplitudes, 1);
  EXPECT_NEAR(slope(amplitudes, plain), 2, .1);
  std::vector<double> changed;
  for (std::size_t i = 0; i < plain.size(); ++i)  // a limit that one change attains
    changed.push_back(defects(mesh, {amplitudes[i]}, plain[i] / 2)[0]);
  EXPECT_NEAR(slope(amplitudes, changed), 3, .2);
}

TEST(closed_step, changes_rho_by_what_is_of_second_order)
{
  const std::vector<double> amplitudes = {.2, .1, .05};
  const Mesh_view mesh = irregular_torus(1, .6, 24, 18);
  const Eigen::VectorXd areas = CGP::vertex_areas(mesh);
  std::vector<double> changes;
  for (const double amplitude : amplitudes) {
    Transformation transformation(mesh);
    const Curvature_potential rho = exact_wave(transformation, amplitude);
    const Eigen::VectorXd change = closed(transformation, rho, 1e-7).rho.values - rho.values;
    changes.push_back(std::sqrt(areas.dot(change.cwiseAbs2())));
  }
  EXPECT_NEAR(slope(amplitudes, changes), 2, .2);
}

// Symmetric surfaces are isothermic: one of the six functions vanishes in the limit, so that one of
// the periods does not obey.
TEST(closed_step, gives_up_where_no_rho_moves_the_periods_and_keeps_the_best)
{
  Transformation transformation(torus(1, .4, 48, 24));
  const Curvature_potential rho = exact_wave(transformation, .25);
  const double before = closed(transformation, rho, 1).result.report.period_defect;
  const Closed_step step = closed(transformation, rho, 1e-9);
  EXPECT_LT(step.result.report.period_defect, before / 10);
  EXPECT_GT(step.result.report.period_defect, 1e-9);
  EXPECT_TRUE(step.result.report.converged);
}

TEST(closed_step, can_be_cancelled_while_it_closes)
{
  Transformation transformation(btorus(12));
  const Curvature_potential rho = exact_wave(transformation, .5);
  int calls = 0, more = 0;
  const auto count = [&](const CGP::Eigensolver_progress&) { return ++calls > 0; };
  (void)CGP::internal::closed_step(transformation, rho, {1, 0}, 1, {}, count);
  const auto stop = [&](const CGP::Eigensolver_progress&) { return ++more <= calls + 1; };
  EXPECT_TRUE(CGP::internal::closed_step(transformation, rho, {1e-7, 0}, 1, {}, stop)
                  .result.report.cancelled);
}

}  // namespace cgp_test::closed_step_tests
