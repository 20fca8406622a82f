// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests spin/Relaxed_positions.h
// Tests include/Conformal_geometry_processing/spin/Nearest_spin_transformation.h
#include <Conformal_geometry_processing/spin/Nearest_spin_transformation.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/Double_solver_traits.h"
#include "support/bends.h"
#include "support/bounded_meshes.h"
#include "support/meshes.h"
#include "support/moebius.h"
#include "support/with_solvers.h"

namespace cgp_test::nearest_spin_transformation_search_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Nearest_spin_result;

CGP::Nearest_spin_options curvature_kept()
{
  CGP::Nearest_spin_options options;
  options.keep_curvature = true;
  return options;
}

CGP::Nearest_spin_options within(double tolerance)
{
  CGP::Nearest_spin_options options;
  options.distance_tolerance = tolerance;
  return options;
}

template <class SolverTraits = CGP::Default_solver_traits>
Nearest_spin_result nearest(const Mesh_view& mesh, const Points& target,
                            CGP::Nearest_spin_options options = within(0))
{
  options.surface = with_solvers<SolverTraits>(options.surface);
  return CGP::Nearest_spin_transformation(mesh, target, "test", options).transform();
}

Points moved_by_a_similarity(const Points& p)
{
  const Eigen::AngleAxisd turn(1.1, Eigen::Vector3d(2, -1, 2).normalized());
  return ((1.7 * turn.toRotationMatrix()) * p).colwise() + Eigen::Vector3d(1, 2, 3);
}

Points transformed(const Mesh_view& mesh, double amplitude)
{
  Eigen::VectorXd rho(mesh.size_of_vertices());
  for (int v = 0; v < rho.size(); ++v)
    rho[v] = amplitude * (std::sin(3 * mesh.position(v).y()) + .5 * mesh.position(v).x());
  const CGP::Spin_result r =
      CGP::Spin_transformation(mesh).transform(CGP::Curvature_potential::on_vertices(rho));
  EXPECT_TRUE(r.report);
  return moved_by_a_similarity(r.positions);
}

// Coarse and irregular: the curvature of the target alone misses it by the discretisation error.
TEST(Nearest_spin_transformation_search, comes_near_to_transformations_of_the_mesh)
{
  for (const Mesh_view& mesh : {perturbed(icosphere(2), .05), perturbed(bumpy_sphere(2), .02)}) {
    const Points target = transformed(mesh, 1);
    const Nearest_spin_result kept = nearest(mesh, target, curvature_kept()),
                              found = nearest(mesh, target);
    EXPECT_TRUE(found.report);
    EXPECT_LT(found.distance, .2 * kept.distance);
    EXPECT_LT(found.distance, 1e-3 * found.source_distance);
  }
}

TEST(Nearest_spin_transformation_search, comes_near_to_transformations_of_a_torus)
{
  const Mesh_view mesh = btorus(16);
  const Nearest_spin_result found = nearest(mesh, transformed(mesh, .3));
  EXPECT_TRUE(found.report);
  EXPECT_LT(found.distance, .02 * found.source_distance);
}

TEST(Nearest_spin_transformation_search, stays_the_nearer_to_conformal_the_less_shear_it_may_have)
{
  const Mesh_view mesh = beam(8);
  const Points target = twisted_beam(mesh, pi / 2).positions();
  std::vector<double> errors, distances;
  for (const double shear : {.05, .02, .008}) {
    CGP::Nearest_spin_options options = within(0);
    options.shear = shear;
    const Nearest_spin_result r = nearest(mesh, target, options);
    EXPECT_TRUE(r.report) << shear;
    EXPECT_LE(r.report.closure_residual, shear);
    errors.push_back(r.report.conformality.quasi_conformal.mean - 1);
    distances.push_back(r.distance);
  }
  EXPECT_TRUE(std::is_sorted(errors.rbegin(), errors.rend()));
  EXPECT_TRUE(std::is_sorted(distances.begin(), distances.end()));
  EXPECT_LT(errors.back(), .5 * errors.front());
  EXPECT_GT(distances.back(), distances.front());
}

// The curvature alone misses them by O(h^2).
TEST(Nearest_spin_transformation_search, of_moebius_images_is_much_nearer_than_the_curvature)
{
  for (int level : {2, 3}) {
    const Mesh_view mesh = bumpy_sphere(level);
    const Points target = inverted(mesh, Eigen::Vector3d(0.4, 0.3, 2.5)).positions();
    const Nearest_spin_result found = nearest(mesh, target);
    EXPECT_TRUE(found.report);
    EXPECT_LT(found.distance, nearest(mesh, target, curvature_kept()).distance / 2);
  }
}

TEST(Nearest_spin_transformation_search, returns_the_mesh_if_the_target_is_similar_to_it)
{
  for (const Mesh_view& mesh : {perturbed(icosphere(2), .05), btorus(12), beam(2)}) {
    const Points target = moved_by_a_similarity(mesh.positions());
    const Nearest_spin_result found = nearest(mesh, target);
    EXPECT_TRUE(found.report);
    EXPECT_LT((found.positions - target).cwiseAbs().maxCoeff(), 1e-7);
    EXPECT_LT(found.report.conformality.quasi_conformal.max, 1 + 1e-6);
  }
}

TEST(Nearest_spin_transformation_search,
     comes_nearer_to_bends_and_twists_than_the_mesh_and_the_curvature)
{
  const Mesh_view mesh = beam(3);
  for (const Mesh_view& target : {bent_beam(mesh, pi / 3, .5), twisted_beam(mesh, pi / 3)}) {
    const Nearest_spin_result kept = nearest(mesh, target.positions(), curvature_kept()),
                              found = nearest(mesh, target.positions());
    EXPECT_TRUE(found.report);
    EXPECT_EQ(found.report.conformality.flipped_faces, 0);
    EXPECT_LT(found.distance, kept.distance);
    EXPECT_LT(found.distance, found.source_distance / 2);
  }
}

// A sphere cannot be turned in itself: no conformal surface is near to it.
TEST(Nearest_spin_transformation_search, is_never_farther_than_the_mesh)
{
  const Mesh_view mesh = icosphere(2);
  const Mesh_view target = mapped(mesh, [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return Eigen::AngleAxisd(p.z(), Eigen::Vector3d::UnitZ()) * p;
  });
  const Nearest_spin_result found = nearest(mesh, target.positions());
  EXPECT_TRUE(found.report);
  EXPECT_LE(found.distance, found.source_distance);
}

/// bent by 60 degrees from end to end
Points bent(const Mesh_view& mesh)
{
  return mapped(mesh,
                [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
                  const double turn = pi / 6 * p.x(), radius = 6 / pi;
                  return {(radius - p.z()) * std::sin(turn), p.y(),
                          radius - (radius - p.z()) * std::cos(turn)};
                })
      .positions();
}

TEST(Nearest_spin_transformation_search, ends_where_the_rest_is_within_the_tolerance)
{
  const Mesh_view mesh = perturbed(bumpy_sphere(3), .02);
  const Points target = transformed(mesh, 1);
  double before = 1;
  int solves = 0;
  for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
    const Nearest_spin_result found = nearest(mesh, target, within(tolerance));
    EXPECT_TRUE(found.report);
    EXPECT_LE(found.distance, tolerance);
    EXPECT_LE(found.normal_distance, 100 * tolerance);
    EXPECT_LE(found.distance, before);
    EXPECT_GE(found.report.solves, solves);
    before = found.distance;
    solves = found.report.solves;
  }
  EXPECT_GT(solves, 3 * nearest(mesh, target, within(1e-2)).report.solves);
}

// The sphere between bent ends is far from conformal to it: surfaces come nearer by shear, and
// normals with positions, because spins need not solve the Dirac equation.
TEST(Nearest_spin_transformation_search, is_conformal_unless_only_positions_count)
{
  const Mesh_view mesh = icosphere(3);
  const Points target = bent(mesh);
  CGP::Nearest_spin_options options;
  const Nearest_spin_result smooth = nearest(mesh, target, options);
  options.normal_weight = 0;
  const Nearest_spin_result sheared = nearest(mesh, target, options);
  EXPECT_TRUE(smooth.report);
  EXPECT_TRUE(sheared.report);
  EXPECT_LT(smooth.distance, smooth.source_distance);
  EXPECT_LT(sheared.distance, smooth.distance);
  EXPECT_LT(smooth.normal_distance, smooth.source_normal_distance);
  EXPECT_LT(smooth.report.conformality.quasi_conformal.mean,
            sheared.report.conformality.quasi_conformal.mean);
}

// Distances count against rho by their weight: it must not tell the size of the target. The sphere
// is far from conformal to its bend, and the beam near to it. What is left, for a turned target, is
// whether a solver takes one iteration more, which is less frequent with factors in double
// precision; with the wrong weight, the differences are .3 to 20 %. The tolerance is relative to
// the bounding box, which turns with the target: it must not be between what is reached here and
// there.
TEST(Nearest_spin_transformation_search, does_not_depend_on_the_place_and_size_of_the_target)
{
  const Mesh_view beam_mesh = perturbed(beam(2), .02), sphere = icosphere(3);
  const auto expect_same = [](const Mesh_view& mesh, const Points& target, double tolerance) {
    const Nearest_spin_result here = nearest<Double_solver_traits>(mesh, target, within(tolerance));
    EXPECT_TRUE(here.report);
    for (const double size : {.2, 1., 2.5}) {
      const Nearest_spin_result there = nearest<Double_solver_traits>(
          mesh, size * moved_by_a_similarity(target), within(tolerance));
      const double share = here.distance / here.source_distance, angle = here.normal_distance;
      EXPECT_NEAR(there.distance / there.source_distance, share, 1e-3 * share) << size;
      EXPECT_NEAR(there.normal_distance, angle, 1e-3 * angle) << size;
    }
  };
  expect_same(beam_mesh, bent_beam(beam_mesh, pi / 3, .5).positions(), 0);
  expect_same(sphere, bent(sphere), 0);
}

TEST(Nearest_spin_transformation_search, refuses_a_negative_weight_of_normals)
{
  const Mesh_view mesh = icosphere(1);
  CGP::Nearest_spin_options options;
  for (const double weight : {-1., std::nan("")}) {
    options.normal_weight = weight;
    EXPECT_THROW(nearest(mesh, mesh.positions(), options), CGP::Precondition_error);
  }
}

// Also where the first steps of the search lead away from the surface with the curvature wanted.
TEST(Nearest_spin_transformation_search, comes_nearer_steadily_with_the_bound)
{
  const Mesh_view mesh = icosphere(2);
  Points target = mesh.positions();
  for (auto p : target.colwise()) p *= 1 + .25 * std::sin(3 * p.x() + 1) * std::cos(2 * p.y());
  double last = .015;
  for (const double bound : {1.06, 1.1, 1.125, 1.133, 1.15}) {
    CGP::Nearest_spin_options options;
    options.surface.scales.bound = bound;
    const Nearest_spin_result found = nearest(mesh, target, options);
    EXPECT_TRUE(found.report);
    EXPECT_LT(found.distance, last) << bound;
    EXPECT_GT(found.distance, last / 1.5) << bound;
    last = found.distance;
  }
}

TEST(Nearest_spin_transformation_search, keeps_lengths_within_a_bound)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const Points target = inverted(mesh, Eigen::Vector3d(0.4, 0.3, 1.8)).positions();
  CGP::Nearest_spin_options options;
  options.surface.scales.bound = 1.5;
  const Nearest_spin_result free = nearest(mesh, target), bounded = nearest(mesh, target, options);
  EXPECT_TRUE(bounded.report);
  EXPECT_LE(bounded.report.scales.excess(), 1);
  EXPECT_GT(bounded.distance, 2 * free.distance);
  EXPECT_LT(bounded.distance, bounded.source_distance);
}

TEST(Nearest_spin_transformation_search,
     with_boundary_comes_nearer_with_the_directions_of_the_target)
{
  const Mesh_view mesh = jittered_disk(8, .2);
  const Points cap = cap_from_disk(mesh, 1.2).positions();
  const Nearest_spin_result found = nearest(mesh, cap);
  EXPECT_TRUE(found.report);
  EXPECT_TRUE(found.direction.has_value());
  EXPECT_LE(found.distance, nearest(mesh, cap, curvature_kept()).distance);
  EXPECT_LT(found.distance, .1 * found.source_distance);
}

}  // namespace cgp_test::nearest_spin_transformation_search_tests
