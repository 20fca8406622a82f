// Tests include/Conformal_geometry_processing/flow/Conformal_willmore_flow.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>
#include <Conformal_geometry_processing/forms/conformal_modulus.h>
#include <Conformal_geometry_processing/mesh/Intrinsic_triangulation.h>
#include <Conformal_geometry_processing/surfaces/tori.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "flow_tools.h"
#include "support/handlebodies.h"
#include "support/moebius.h"
#include "support/random.h"
#include "support/skewed_tori.h"
#include "support/tori.h"

namespace cgp_test::flow_on_class_tests {

/// Laws of the flow on the exact discrete conformal class, its default on closed surfaces.

using Flow = CGP::Conformal_willmore_flow;
using Stop = CGP::Flow_step_report::Stop;

CGP::Flow_options steps(int count)
{
  CGP::Flow_options options;
  options.max_steps = count;
  options.energy_tolerance = 0;
  return options;
}

/// closed surfaces of genus 0 and 1, irregular, noisy, and with slivers
std::vector<Mesh_view> surfaces()
{
  return {bumpy_sphere(3), perturbed(icosphere(3), .03), stretched(bumpy_sphere(3), 4),
          perturbed(irregular_torus(2, 1, 32, 16), .02), stretched(torus(2, 1, 40, 20), 1.5)};
}

TEST(Flow_on_class, keeps_length_cross_ratios_in_every_step_and_exactly_in_the_end)
{
  for (const Mesh_view& mesh : surfaces()) {
    Flow flow(mesh, steps(4));
    const CGP::Flow_report report = flow.run();
    EXPECT_EQ(report.steps.size(), 4U);
    for (const CGP::Flow_step_report& step : report.steps) {
      EXPECT_LE(step.length_cross_ratio, 1e-5);
      EXPECT_LT(step.energy, step.energy_before);
    }
    EXPECT_LT(report.conformality.length_cross_ratio.max, 1e-10);
    EXPECT_TRUE(report) << to_string(report.stop) << ' ' << report.message;
  }
}

// Steps that end in a band around the class gain energy by going to its edge, and then none.
TEST(Flow_on_class, settles_on_coarse_tori_at_an_energy_of_the_class_itself)
{
  for (const Mesh_view& mesh : {btorus(12), twisted_torus(24), hopf_torus(24)}) {
    Flow flow(mesh);
    const CGP::Flow_report report = flow.run();
    EXPECT_EQ(report.stop, Stop::energy_settled) << to_string(report.stop) << report.message;
    EXPECT_NEAR(report.steps.back().energy / report.energy, 1, 1e-5);
    EXPECT_TRUE(report);
  }
}

// By reflection symmetry the class is rectangular, and its smoothest surface, for b <= sqrt 3, a
// round torus. A mesh has less energy by O(h^2).
TEST(Flow_on_class, comes_to_the_smoothest_torus_of_a_rectangular_class)
{
  for (const double b : {1.1, std::sqrt(3.)}) {
    std::vector<double> h, errors;
    for (const int n : {16, 24, 32}) {
      const auto bumpy = [&](double R) {
        return tube_torus(R, 3 * n / 2, n, [](double u, double v) {
          return 1 + .1 * std::cos(6 * pi * u) * std::cos(2 * pi * v) + .07 * std::cos(6 * pi * v);
        });
      };
      Flow flow(CGP::torus_of_class(bumpy, b, 1.43, 3));
      const CGP::Flow_report report = flow.run();
      EXPECT_EQ(report.stop, Stop::energy_settled) << b << ' ' << n;
      h.push_back(1. / n);
      errors.push_back(1 - report.energy / (pi * pi * (b + 1 / b)));
    }
    EXPECT_GT(slope(h, errors), 1.7) << b;
    EXPECT_LT(errors.back(), .006) << b;
  }
}

TEST(Flow_on_class, has_the_connectivity_of_the_delaunay_triangulation)
{
  const Mesh_view mesh = stretched(bumpy_sphere(3), 4);
  Flow flow(mesh, steps(2));
  EXPECT_NE(flow.mesh().corners(), mesh.corners());
  EXPECT_EQ(flow.mesh().corners(), CGP::internal::simple_delaunay(mesh).corners());
  EXPECT_EQ(flow.initial_mesh().positions(), mesh.positions());
  const CGP::Flow_report report = flow.run();
  EXPECT_NE(report.conformality.quasi_conformal.max,
            report.conformality_of_faces.quasi_conformal.max);
}

/// a surface of revolution with a neck, of 962 points whose rings are joined with a twist: the more
/// the thinner the faces, and the farther from Delaunay
Mesh_view twisted_dumbbell(double neck, int twist)
{
  const int rings = 40, around = 24, all = rings * around;
  const auto at = [&](int ring, int j) { return ring * around + j % around; };
  Points p(3, all + 2);
  CGP::Mesh_view::Corners faces;
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < around; ++j) {
      const double u = .06 + (pi - .12) * i / (rings - 1), c = std::cos(u), t = 2 * pi * j / around;
      const double r = std::sin(u) * (neck + 1.3 * (1 - neck) * c * c);
      p.col(at(i, j)) << r * std::cos(t), r * std::sin(t), -1.6 * c;
      if (i + 1 == rings) continue;
      faces.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1 + twist)});
      faces.push_back({at(i, j), at(i + 1, j + 1 + twist), at(i + 1, j + twist)});
    }
  for (int j = 0; j < around; ++j) {
    faces.push_back({all, at(0, j + 1), at(0, j)});
    faces.push_back({all + 1, at(rings - 1, j), at(rings - 1, j + 1)});
  }
  p.col(all) << 0, 0, p(2, 0) - .02;
  p.col(all + 1) << 0, 0, p(2, all - 1) + .02;
  return {std::move(p), std::move(faces)};
}

/// a vertex, a face of it, and the least angle of that face
void expect_place_on(const Mesh_view& mesh, const CGP::Flow_step_report::Place& place)
{
  ASSERT_GE(place.vertex, 0);
  ASSERT_GE(place.face, 0);
  double least = pi;
  bool is_corner = false;
  for (int c = 0; c < 3; ++c) {
    least = std::min(least, CGP::corner_angle(mesh.sheet(place.face), c));
    is_corner = is_corner || mesh.corners(place.face)[at(c)] == place.vertex;
  }
  EXPECT_TRUE(is_corner);
  EXPECT_DOUBLE_EQ(place.angle, least);
}

/// that no step leads above the least energy before on the faces of the input, up to 1 % for the
/// error of such faces, and as much for what settling on them takes away or not
void expect_falling(const CGP::Flow_report& report)
{
  double least = report.initial_energy_of_faces;
  for (const CGP::Flow_step_report& step : report.steps) {
    EXPECT_LE(step.energy_of_faces, 1.02 * least);
    least = std::min(least, step.energy_of_faces);
  }
  EXPECT_LE(report.energy_of_faces, 1.02 * least);
}

// What a user gets are the faces of the input, however good the map is on others.
TEST(Flow_on_class, is_judged_on_the_faces_of_the_input)
{
  int stopped = 0;
  for (const double neck : {.2, .3, .6})
    for (const int twist : {0, 1, 2, 4}) {
      const Mesh_view mesh = twisted_dumbbell(neck, twist);
      Flow flow(mesh);
      const CGP::Flow_report report = flow.run();
      const Mesh_view after(flow.positions(), mesh.corners());
      const CGP::Conformality map = CGP::conformality(
          mesh, after.positions(), CGP::neighbourhood_normals(mesh, after.positions()));
      EXPECT_EQ(map.fault({}), CGP::Conformality::Fault::none) << neck << ' ' << twist;
      EXPECT_DOUBLE_EQ(map.quasi_conformal.mean, report.conformality_of_faces.quasi_conformal.mean);
      EXPECT_EQ(map.flipped_faces, report.conformality_of_faces.flipped_faces);
      expect_falling(report);
      EXPECT_NEAR(report.energy_of_faces, CGP::willmore_energy(after), 1e-9);
      EXPECT_FALSE(report.steps.empty());
      if (report.message.find("the faces of the input") == std::string::npos) continue;
      ++stopped;
      EXPECT_EQ(report.stop, Stop::limits_reached);
      EXPECT_FALSE(report);
      expect_place_on(mesh, report.place);
    }
  EXPECT_GT(stopped, 0);
}

// The triangulation of the flow has less energy in every step.
TEST(Flow_on_class, ends_before_the_energy_rises_on_the_faces_of_the_input)
{
  CGP::Flow_options options;
  options.max_steps = 20;
  Flow flow(stretched(twisted_torus(24), 3), options);
  const CGP::Flow_report report = flow.run();
  expect_falling(report);
  EXPECT_LT(report.energy_of_faces, .9 * report.initial_energy_of_faces);
}

TEST(Flow_on_class, makes_an_ellipsoid_a_round_sphere)
{
  Flow flow(stretched(icosphere(4), 2));
  const CGP::Flow_report report = flow.run();
  EXPECT_TRUE(report) << to_string(report.stop) << ' ' << report.message;
  EXPECT_LT(report.energy, 1.005 * CGP::willmore_energy(icosphere(4)));
  EXPECT_LT(radius_deviation(flow.mesh()), .01);
  EXPECT_LT(report.conformality.quasi_conformal.mean, 1.03);
}

TEST(Flow_on_class, keeps_the_conformal_type_where_the_plain_flow_drifts)
{
  const Mesh_view mesh = stretched(irregular_torus(2, 1, 32, 16), 2);
  CGP::Flow_options options = steps(8);
  Flow exact(mesh, options);
  options.surface.exact_conformal_class = false;
  Flow plain(mesh, options);
  const double on_class = exact.run().conformal_type_change,
               off_class = plain.run().conformal_type_change;
  EXPECT_LT(on_class, .02);
  EXPECT_GT(off_class, 2 * on_class);
}

TEST(Flow_on_class, takes_noise_away_that_the_plain_flow_leaves)
{
  const Mesh_view mesh = radially_perturbed(icosphere(4), .01);
  CGP::Flow_options options = steps(3);
  Flow faired(mesh, options);
  options.fairing = false;
  Flow unfaired(mesh, options);
  (void)faired.run();
  (void)unfaired.run();
  EXPECT_LT(faired.energy() - 4 * pi, .5 * (unfaired.energy() - 4 * pi));
}

TEST(Flow_on_class, leaves_nothing_to_be_smoothed_where_it_settles)
{
  for (const Mesh_view& mesh : surfaces()) {
    CGP::Flow_options options;
    Flow flow(mesh, options);
    ASSERT_EQ(flow.run().stop, Stop::energy_settled);
    CGP::internal::Class_keeper keeper(CGP::internal::simple_delaunay(mesh));
    double energy = flow.energy();
    const auto smoother = keeper.smoothed(flow.mesh(), [&](const CGP::Points& f) {
      energy = CGP::willmore_energy(Mesh_view(f, flow.mesh().corners()));
      return energy < flow.energy();
    });
    EXPECT_TRUE(!smoother || energy > (1 - options.energy_tolerance) * flow.energy());
  }
}

TEST(Flow_on_class, lowers_the_energy_of_surfaces_of_higher_genus)
{
  for (const int genus : {2, 3}) {
    const Mesh_view mesh = smooth_handlebody(genus, 1);
    Flow flow(mesh, steps(5));
    const CGP::Flow_report report = flow.run();
    EXPECT_LT(report.energy, .9 * report.initial_energy);
    EXPECT_LT(report.conformality.length_cross_ratio.max, 1e-10);
    EXPECT_EQ(report.conformality.fault({}), CGP::Conformality::Fault::none);
  }
}

TEST(Flow_on_class, stops_at_the_last_step_within_its_limits)
{
  const Mesh_view mesh = stretched(irregular_torus(2, 1, 32, 16), 2);
  CGP::Flow_options options = steps(20);
  options.surface.limits.map.quasi_conformal = 1.01;
  for (const bool is_exact : {true, false}) {
    options.surface.exact_conformal_class = is_exact;
    Flow flow(mesh, options);
    const CGP::Flow_report report = flow.run();
    EXPECT_EQ(report.stop, Stop::limits_reached);
    EXPECT_FALSE(report.is_complete());
    EXPECT_FALSE(report);
    const double Q = (std::max)(report.conformality.quasi_conformal.mean,
                                report.conformality_of_faces.quasi_conformal.mean);
    EXPECT_LE(Q, 1.01);
    EXPECT_GT(Q, 1.009);  // by steps that become smaller
    EXPECT_NE(report.message.find("quasi-conformal error"), std::string::npos) << report.message;
  }
}

TEST(Flow_on_class, stops_within_its_limits_without_smaller_steps)
{
  CGP::Flow_options options = steps(20);
  options.surface.limits.map.quasi_conformal = 1.01;
  options.backtracking = false;
  for (const bool is_exact : {true, false}) {
    options.surface.exact_conformal_class = is_exact;
    Flow flow(stretched(irregular_torus(2, 1, 32, 16), 2), options);
    const CGP::Flow_report report = flow.run();
    EXPECT_EQ(report.stop, Stop::limits_reached) << report.message;
    EXPECT_EQ(report.conformality.fault(options.surface.limits.map),
              CGP::Conformality::Fault::none);
    EXPECT_NE(report.message.find("quasi-conformal error"), std::string::npos) << report.message;
  }
}

TEST(Flow_on_class, is_transformed_up_to_the_limits_where_smoothing_has_ended)
{
  for (const Mesh_view& mesh :
       {stretched(irregular_torus(2, 1, 32, 16), 2), stretched(bumpy_sphere(3), 4)}) {
    CGP::Flow_options options;
    Flow free(mesh, options);
    const double energy = free.run().energy;
    options.max_spin_distortion = 1 + 1e-6;
    Flow narrow(mesh, options);
    const CGP::Flow_report report = narrow.run();
    EXPECT_TRUE(report) << to_string(report.stop) << report.message;
    EXPECT_NEAR(report.energy / energy, 1, .02);
    const auto is_transformed = [](const auto& step) { return step.time_step > 0; };
    EXPECT_TRUE(std::any_of(report.steps.begin(), report.steps.end(), is_transformed));
  }
}

// The last surface is moved to its class to rounding; not where that is beyond a limit.
TEST(Flow_on_class, is_within_its_limits_in_the_end)
{
  for (const Mesh_view& mesh : surfaces()) {
    CGP::Flow_options options = steps(1);
    Flow free(mesh, options);
    const CGP::Flow_report report = free.run();
    const double before = report.steps.back().quasi_conformal.mean,
                 after = report.conformality.quasi_conformal.mean;
    options.surface.limits.map.quasi_conformal = (before + after) / 2;
    Flow limited(mesh, options);
    EXPECT_EQ(limited.run().conformality.fault(options.surface.limits.map),
              CGP::Conformality::Fault::none);
  }
}

// A tube closes to a sphere with ends that are smaller by a factor exponential in its length.
TEST(Flow_on_class, tells_that_limbs_are_too_small_for_the_precision)
{
  CGP::Flow_options options = steps(30);
  options.surface.limits.map = {100, 1, 1};
  for (const double length : {30, 40, 41, 42}) {
    Flow flow(CGP::internal::simple_delaunay(stretched(icosphere(4), length)), options);
    const CGP::Flow_report report = flow.run();
    EXPECT_EQ(report.stop, Stop::scale_range) << length << ' ' << report.message;
    EXPECT_FALSE(report.is_complete());
    const auto& scale = report.conformality.scale;
    EXPECT_GT(std::log(scale.max_scale / scale.min_scale), 10);
    EXPECT_EQ(report.conformality.fault(options.surface.limits.map),
              CGP::Conformality::Fault::none);
  }
}

TEST(Flow_on_class, keeps_area_and_centroid_at_any_scale)
{
  const Mesh_view mesh = scaled(perturbed(irregular_torus(2, 1, 24, 12), .02), 1e3);
  Flow flow(mesh, steps(3));
  (void)flow.run();
  EXPECT_NEAR(area(flow.mesh()), area(flow.initial_mesh()), 1e-9 * area(flow.initial_mesh()));
  EXPECT_LT((centroid(flow.mesh()) - centroid(flow.initial_mesh())).norm(), 1e-6);
}

}  // namespace cgp_test::flow_on_class_tests
