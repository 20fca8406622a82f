// Tests include/Conformal_geometry_processing/flow/Conformal_willmore_flow.h
// Tests include/Conformal_geometry_processing/flow/Flow_options.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>
#include <Conformal_geometry_processing/measure/energies.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <utility>
#include <vector>

#include "flow_tools.h"
#include "support/bounded_meshes.h"
#include "support/random.h"
#include "support/spheres.h"
#include "support/tori.h"

namespace cgp_test::conformal_willmore_flow_volume_tests {

/// Flows with a prescribed reduced volume: shapes of vesicles.

double volume_of(const Mesh_view& mesh)
{
  return CGP::enclosure(mesh).reduced_volume;
}

/// a spheroid of a given volume about the five-fold axis of an icosphere: longer than 1, or flatter
Mesh_view spheroid(int level, double volume, double most)
{
  const Mesh_view sphere = icosphere(level);
  const Eigen::Vector3d axis = sphere.position(0).normalized();
  const auto along_axis = [&](double k) {
    return mapped(sphere, [&](const Eigen::Vector3d& p) {
      return Eigen::Vector3d(p + (k - 1) * p.dot(axis) * axis);
    });
  };
  double round = 1, other = most;
  for (int i = 0; i < 50; ++i) {
    const double middle = std::sqrt(round * other);
    (volume_of(along_axis(middle)) > volume ? round : other) = middle;
  }
  return along_axis(other);
}

struct End {
  CGP::Flow_report report;
  Mesh_view mesh;
};

End flown(const Mesh_view& mesh, double volume, int steps = 60)
{
  CGP::Flow_options options;
  options.reduced_volume = volume;
  options.max_steps = steps;
  CGP::Conformal_willmore_flow flow(mesh, options);
  CGP::Flow_report report = flow.run();
  return {std::move(report), Mesh_view(flow.positions(), mesh.corners())};
}

/// the law of every flow that does not have to change its volume
void expect_descent(const End& end, double volume)
{
  EXPECT_TRUE(end.report) << end.report.message;
  EXPECT_NEAR(volume_of(end.mesh), volume, 1e-9);
  EXPECT_NEAR(end.report.enclosure.area, end.report.initial_enclosure.area,
              .01 * end.report.enclosure.area);
  EXPECT_GT(end.report.steps.size(), 2u);
  for (const CGP::Flow_step_report& step : end.report.steps)
    EXPECT_LT(step.energy, step.energy_before);
}

// By the shape equations of axisymmetric vesicles, see `benchmark/page/vesicle_shapes.py`.
TEST(Conformal_willmore_flow_volume, ends_at_the_prolate_and_the_oblate_vesicle)
{
  const double volume = .8;
  for (const auto& [most, energy] :
       std::vector<std::pair<double, double>>{{5., 1.387440}, {.1, 1.452539}}) {
    std::vector<double> h, error;
    for (const int level : {2, 3}) {
      const Mesh_view mesh = spheroid(level, volume, most);
      const End end = flown(mesh, volume);
      expect_descent(end, volume);
      EXPECT_TRUE(end.report.converged());
      h.push_back(mean_edge_length(mesh));
      error.push_back(std::abs(end.report.energy_of_faces / (4 * pi * energy) - 1));
    }
    EXPECT_LT(error.back(), .015);
    EXPECT_GT(slope(h, error), 1.4);
  }
}

TEST(Conformal_willmore_flow_volume, keeps_that_of_coarse_and_irregular_surfaces)
{
  for (const Mesh_view& mesh : {perturbed(bumpy_sphere(2), .05), perturbed(bumpy_sphere(3), .02),
                                stretched(bumpy_sphere(2), 1.5)}) {
    const double volume = volume_of(mesh);
    expect_descent(flown(mesh, volume), volume);
  }
}

TEST(Conformal_willmore_flow_volume, keeps_that_of_a_torus)
{
  const Mesh_view mesh = irregular_torus(2, 1, 30, 15);
  const double volume = volume_of(mesh);
  const End end = flown(mesh, volume, 20);
  EXPECT_NEAR(volume_of(end.mesh), volume, 1e-9);
  EXPECT_LT(end.report.energy, end.report.initial_energy);
  EXPECT_TRUE(end.report.keeps_conformal_type());
}

TEST(Conformal_willmore_flow_volume, is_led_to_another_one)
{
  const Mesh_view mesh = spheroid(3, .92, 5);
  const End less = flown(mesh, .8), more = flown(mesh, .97);
  for (const auto& [end, volume] : {std::pair{&less, .8}, std::pair{&more, .97}}) {
    EXPECT_TRUE(end->report) << end->report.message;
    EXPECT_NEAR(volume_of(end->mesh), volume, 1e-9);
  }
  EXPECT_NEAR(less.report.energy_of_faces / (4 * pi), 1.3874, .03);
  EXPECT_LT(more.report.energy, less.report.energy);
}

TEST(Conformal_willmore_flow_volume, commutes_with_motions_and_scalings)
{
  const Mesh_view mesh = perturbed(spheroid(2, .85, 5), .03);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(.7, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  const Mesh_view moved(3e7 * (turn * mesh.positions()), mesh.corners());
  const double volume = volume_of(mesh);
  const Points expected = 3e7 * (turn * flown(mesh, volume, 5).mesh.positions());
  const Points found = flown(moved, volume, 5).mesh.positions();
  EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), 1e-6 * expected.cwiseAbs().maxCoeff());
}

TEST(Conformal_willmore_flow_volume, refuses_what_no_surface_has)
{
  for (const double volume : {0., -.5, 1.001, std::nan("")})
    EXPECT_THROW((void)flown(bumpy_sphere(1), volume), CGP::Precondition_error);
  EXPECT_THROW((void)flown(disk(3), .5), CGP::Precondition_error);
  CGP::Flow_options options;
  options.reduced_volume = .5;
  options.surface.exact_conformal_class = false;
  EXPECT_THROW(CGP::Conformal_willmore_flow(bumpy_sphere(1), options), CGP::Precondition_error);
  options.surface.exact_conformal_class = true;
  options.balance = CGP::Flow_options::Balance::initial;
  EXPECT_THROW(CGP::Conformal_willmore_flow(bumpy_sphere(1), options), CGP::Precondition_error);
}

// The volume of a round sphere is the largest: to first order nothing changes it.
TEST(Conformal_willmore_flow_volume, tells_where_it_is_not_reached)
{
  const Mesh_view mesh = icosphere(2);
  const End end = flown(mesh, .5, 3);
  EXPECT_FALSE(end.report);
  EXPECT_NEAR(end.report.missing_volume, std::log(.5 / volume_of(end.mesh)), 1e-12);
  EXPECT_FALSE(end.report.has_volume());
}

}  // namespace cgp_test::conformal_willmore_flow_volume_tests
