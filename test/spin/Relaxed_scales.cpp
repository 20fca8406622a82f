// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Relaxed_scales.h
#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/spin/Relaxed_scales.h>
#include <Conformal_geometry_processing/spin/Relaxed_surface.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

#include "spin/relaxed_surfaces.h"

namespace cgp_test::relaxed_scales_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;
using CGP::internal::Dirac_system;
using CGP::internal::Relaxed_scales;
using CGP::internal::Scale_control;
using End = Relaxed_scales::End;

TEST(Relaxed_scales, keeps_to_the_bound)
{
  const Mesh_view mesh = ellipsoid(3);
  Dirac_system system(mesh);
  const Scale_control control{1.5, {}, {}};
  Relaxed_scales scales(system, waves_on(mesh, 3), control);
  EXPECT_EQ(scales.run(), End::within_bound);
  EXPECT_LE(scales.excess(), 1);
  EXPECT_GE(scales.excess(), .99);
  EXPECT_LE(scales.spins().costs().factorizations, 5);
  EXPECT_LE(scales.spins().costs().solves, 100);
}

// Of rho as much is kept as in steps that are solved further.
TEST(Relaxed_scales, leaves_what_is_negligible)
{
  for (const Mesh_view& mesh : {ellipsoid(3), perturbed(ellipsoid(3), .05)})
    for (const double bound : {1.3, 2.}) {
      Dirac_system system(mesh);
      const Scale_control control{bound, {}, {}};
      const auto kept = [&](double negligible) {
        CGP::internal::Relaxed_scales_options options;
        options.spins.negligible = negligible;
        Relaxed_scales scales(system, waves_on(mesh, 3), control, {}, options);
        EXPECT_EQ(scales.run(), End::within_bound);
        return scales.scales().kept_norm;
      };
      const double all = kept(0);
      EXPECT_NEAR(kept(CGP::internal::Relaxed_surface::negligible(system, control)), all,
                  .007 * all);
    }
}

// A guess of the weight that is a third as large, from the first part of rho alone, costs 68 steps
// and 413 solves.
TEST(Relaxed_scales, guesses_the_weight_well)
{
  const Mesh_view mesh = ellipsoid(3);
  Dirac_system system(mesh);
  int steps = 0, solves = 0;
  for (const double bound : {1.5, 2.})
    for (const double amplitude : {1., 2., 3., 4., 6.}) {
      const Scale_control control{bound, {}, {}};
      Relaxed_scales scales(system, waves_on(mesh, amplitude), control);
      scales.run();
      EXPECT_LE(scales.excess(), 1) << bound << ' ' << amplitude;
      steps += scales.steps();
      solves += scales.spins().costs().solves;
    }
  EXPECT_LE(steps, 62);
  EXPECT_LE(solves, 340);
}

// From between any two of its steps.
TEST(Relaxed_scales, are_resumed_by_another_object)
{
  const Mesh_view mesh = perturbed(ellipsoid(2), .05);
  Dirac_system system(mesh);
  const Scale_control control{1.5, {}, {}};
  const Eigen::VectorXd rho = waves_on(mesh, 3);
  std::vector<Relaxed_scales::Position> positions;
  const Relaxed_scales* search = nullptr;
  CGP::internal::Relaxed_scales_options options;
  options.between_steps = [&] { positions.push_back(search->position()); };
  Relaxed_scales all(system, rho, control, {}, options);
  search = &all;
  const End end = all.run();
  EXPECT_GE(positions.size(), 3);
  for (const Relaxed_scales::Position& position : positions) {
    Dirac_system anew(mesh);
    Relaxed_scales rest(anew, rho, control);
    EXPECT_EQ(rest.resume(position, 1, CGP::internal::Always_go_further()), end);
    const auto difference = components(rest.spins().lambda()) - components(all.spins().lambda());
    EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-9) << position.steps;
    EXPECT_NEAR(rest.weight(), all.weight(), 1e-8 * all.weight());
  }
}

// For what is changed after the steps; the larger of two rooms counts.
TEST(Relaxed_scales, leaves_room_below_the_bound)
{
  const Mesh_view mesh = perturbed(ellipsoid(2), .05);
  Dirac_system system(mesh);
  const Scale_control control{1.5, {}, {}};
  Relaxed_scales scales(system, waves_on(mesh, 3), control);
  EXPECT_EQ(scales.run(), End::within_bound);
  scales.leave_room(.1);
  scales.leave_room(.05);
  EXPECT_EQ(scales.go_on(), End::within_bound);
  EXPECT_LE(scales.excess(), .9);
  EXPECT_GE(scales.excess(), .89);
}

TEST(Relaxed_scales, end_where_their_iterations_are_spent_with_what_they_have)
{
  const Mesh_view mesh = perturbed(ellipsoid(2), .05);
  Dirac_system system(mesh);
  const Scale_control control{1.5, {}, {}};
  CGP::internal::Relaxed_scales_options few;
  few.max_iterations = 8;
  Relaxed_scales scales(system, waves_on(mesh, 3), control, {}, few);
  EXPECT_EQ(scales.run(), End::too_many_steps);
  const CGP::internal::Dirac_solution first = scales.solution();
  EXPECT_TRUE(first.is_unfinished);
  EXPECT_TRUE(first.converged);
  EXPECT_LE(first.iterations, few.max_iterations + few.spins.max_iterations);
  scales.reset_costs();
  EXPECT_EQ(scales.stiffen(3), End::too_many_steps);
  EXPECT_EQ(scales.solution().iterations, 0);
  EXPECT_NEAR(system.overlap(scales.solution().lambda, first.lambda), 1, 1e-14);
  for (int edit = 0; scales.is_spent(); ++edit, scales.renew_budget(), scales.go_on())
    ASSERT_LT(edit, 20);
  EXPECT_FALSE(scales.solution().is_unfinished);
  EXPECT_LE(scales.excess(), 1);
}

// Where the bound is slack it has no effect, and as rho grows, lengths reach it without a jump.
TEST(Relaxed_scales, comes_up_to_the_bound_without_a_jump)
{
  const Mesh_view mesh = ellipsoid(3);
  const Scale_control control{1.5, {}, {}}, none;
  double last = 0;
  for (const double amplitude : {.2, .4, .6, .8, 1., 1.2, 1.4}) {
    Dirac_system system(mesh);
    Relaxed_scales bounded(system, waves_on(mesh, amplitude), control);
    bounded.run();
    EXPECT_GE(bounded.excess(), last - .015) << amplitude;
    EXPECT_LE(bounded.excess(), 1) << amplitude;
    last = bounded.excess();
    if (amplitude > .4) continue;
    Relaxed_scales free(system, waves_on(mesh, amplitude), none);
    EXPECT_EQ(free.run(), End::settled);
    EXPECT_NEAR(system.overlap(free.spins().lambda(), bounded.spins().lambda()), 1, 1e-5);
  }
  EXPECT_GT(last, .98);
}

/// a ball with a horn
Mesh_view horn()
{
  return mapped(icosphere(4), [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p.x(), p.y() + 2 * std::pow((std::max)(p.y(), 0.), 8), p.z());
  });
}

/// what a bump of rho at the tip does to lengths
struct Tip {
  double size;  // the factor there
  CGP::Spin_report::Scales scales;
};

/// \param sharpness in 1/length^2
Tip bump_at_tip(const Mesh_view& mesh, double amplitude, double sharpness = 10)
{
  int tip = 0;
  mesh.positions().row(1).maxCoeff(&tip);
  const Eigen::Vector3d p = mesh.position(tip);
  const auto rho = potential_on_vertices(mesh, [&](const Eigen::Vector3d& q) {
    return amplitude * std::exp(-sharpness * (q - p).squaredNorm());
  });
  Dirac_system system(mesh);
  const Scale_control control{2., {}, {}};
  Relaxed_scales scales(system, rho.values, control);
  scales.run();
  return {squared_norm(scales.spins().lambda()[tip]), scales.scales()};
}

// Also where a horn cannot take the shape of rho.
TEST(Relaxed_scales, lets_a_tip_grow_with_rho_and_shrink_against_it)
{
  const Mesh_view mesh = horn();
  double last = 1;
  for (const double amplitude : {.25, .5, 1., 2., 3.}) {
    const double size = bump_at_tip(mesh, amplitude).size;
    EXPECT_GT(size, last) << amplitude;
    last = size;
  }
  EXPECT_LT(bump_at_tip(mesh, -1).size, 1);
}

// Of less than 1 % of the area, which the bound itself does not see.
TEST(Relaxed_scales, bounds_tips_too)
{
  const Mesh_view mesh = horn();
  double last = 1;
  for (const double amplitude : {1., 3., 6., 12.}) {
    const Tip tip = bump_at_tip(mesh, amplitude, 60);
    EXPECT_LE(tip.scales.excess(), 1) << amplitude;
    EXPECT_LE(tip.scales.tip_high, 3) << amplitude;
    EXPECT_LT(tip.scales.high, 1.9) << amplitude;
    EXPECT_GT(tip.scales.tip_high, last) << amplitude;
    last = tip.scales.tip_high - .03;
  }
  EXPECT_GT(last, 2.9);
}

/// where the bounded transformation takes the vertices
Points transformed(const Mesh_view& mesh, const Eigen::VectorXd& rho)
{
  CGP::Spin_transformation_options options;
  options.scales.bound = 1.5;
  CGP::Spin_transformation transformation(mesh, options);
  return transformation.transform(Curvature_potential::on_vertices(rho)).positions;
}

// On an irregular mesh, with the bound active.
TEST(Relaxed_scales, do_not_see_constants_rotations_and_hardly_one_percent)
{
  const Mesh_view mesh = perturbed(ellipsoid(2), .05);
  const Eigen::VectorXd rho = waves_on(mesh, 3), higher = rho.array() + 2;
  const Points expected = transformed(mesh, rho);
  const auto distance = [&](const Points& f) { return CGP::align(f, expected).rms; };
  EXPECT_LT(distance(transformed(mesh, higher)), 1e-8);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  EXPECT_LT(distance(transformed({Points(turn * mesh.positions()), mesh.corners()}, rho)), 1e-8);
  EXPECT_LT(distance(transformed(mesh, 1.01 * rho)), .01);
}

TEST(Relaxed_scales, is_cancelled_between_steps)
{
  const Mesh_view mesh = ellipsoid(2);
  Dirac_system system(mesh);
  const Scale_control control{1.5, {}, {}};
  Relaxed_scales scales(system, waves_on(mesh, 3), control);
  int asked = 0;
  EXPECT_EQ(scales.run([&](const CGP::Eigensolver_progress&) { return ++asked < 2; }),
            End::cancelled);
  EXPECT_EQ(asked, 2);
  EXPECT_TRUE(scales.solution().cancelled);
}

/// the report of a transformation that may distort by so much
CGP::Spin_report within(double quasi_conformal)
{
  const Mesh_view mesh = ellipsoid(2);
  CGP::Spin_transformation_options options;
  options.scales.bound = 2;
  CGP::Spin_transformation transformation(mesh, options);
  transformation.limits().map.quasi_conformal = quasi_conformal;
  return transformation.transform(Curvature_potential::on_vertices(waves_on(mesh, 3))).report;
}

// Where the mesh is too coarse for all of rho, and where that is in vain, all of it.
TEST(Relaxed_scales, asks_for_less_where_the_map_would_not_be_conformal)
{
  const CGP::Spin_report all = within(2), less = within(1.05), vain = within(1.0001);
  EXPECT_GT(all.conformality.quasi_conformal.mean, 1.05);
  EXPECT_LE(less.conformality.quasi_conformal.mean, 1.05);
  EXPECT_LE(less.conformality.quasi_conformal_of_new_area, 1.05);
  EXPECT_LT(less.scales.kept_norm, all.scales.kept_norm);
  EXPECT_GT(vain.scales.kept_norm, less.scales.kept_norm);
  EXPECT_EQ(vain.fault(), CGP::Spin_report::Fault::map);
}

// Not by a large part at once where a limit begins to matter.
TEST(Relaxed_scales, asks_for_less_steadily)
{
  const CGP::Spin_report all = within(2);
  const double distortion = (std::max)(all.conformality.quasi_conformal.mean,
                                       all.conformality.quasi_conformal_of_new_area) -
                            1;
  const double most = .15;
  double last = all.scales.kept_norm;
  for (const double share : {1., .95, .9, .85, .8, .75, .7, .65, .6}) {
    const double kept = within(1 + share * distortion).scales.kept_norm;
    EXPECT_NEAR(kept, last, most * all.scales.kept_norm) << share;
    last = kept;
  }
}

/// the mean quasi-conformal error of the result, less 1
double mean_distortion(int level)
{
  const Mesh_view mesh = mapped(icosphere(level), [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p.x(), 2 * p.y(), p.z());
  });
  CGP::Spin_transformation_options options;
  options.scales.bound = 1.5;
  CGP::Spin_transformation transformation(mesh, options);
  const auto result = transformation.transform(Curvature_potential::on_vertices(waves_on(mesh, 2)));
  EXPECT_GT(result.report.scales.excess(), .98);
  return result.report.conformality.quasi_conformal.mean - 1;
}

// The bound is active, and what it asks for goes into rho', not into shear.
TEST(Relaxed_scales, leaves_a_distortion_that_falls_with_the_edge_length)
{
  double last = mean_distortion(2);
  for (const int level : {3, 4, 5}) {
    const double next = mean_distortion(level);
    EXPECT_GT(std::log2(last / next), .9) << level;
    last = next;
  }
}

}  // namespace cgp_test::relaxed_scales_tests
