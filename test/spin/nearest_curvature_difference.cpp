// Tests include/Conformal_geometry_processing/spin/nearest_curvature_difference.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/spin/curvature_difference.h>
#include <Conformal_geometry_processing/spin/nearest_curvature_difference.h>
#include <Conformal_geometry_processing/spin/turned_binormals.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/bounded_meshes.h"
#include "support/meshes.h"
#include "support/moebius.h"
#include "support/spheres.h"

namespace cgp_test::nearest_curvature_difference_tests {

namespace CGP = Conformal_geometry_processing;

/// how far the transformation by rho is from the positions, relative to the diagonal
double distance_by(const CGP::Curvature_potential& rho, const Mesh_view& mesh,
                   const Points& positions)
{
  CGP::Spin_transformation_options options;
  if (!CGP::topology(mesh).is_closed()) {
    const Points aligned = CGP::align(positions, mesh.positions()).apply(positions);
    options.boundary = CGP::Boundary_condition::binormals(
        CGP::turned_binormals(mesh, Mesh_view(aligned, mesh.corners()), mesh, 1));
    options.exactness.reset();
  }
  const CGP::Spin_result result = CGP::Spin_transformation(mesh, options).transform(rho);
  EXPECT_TRUE(result.report);
  return CGP::align(result.positions, positions).rms;
}

// Where the plain difference misses by the discretisation error. On nearly round spheres,
// differences of curvature hardly see inversions, of which a tenth of that is left.
TEST(Nearest_curvature_difference, arrives_within_the_tolerance_on_coarse_and_irregular_meshes)
{
  for (const Mesh_view& mesh : {bumpy_sphere(2), perturbed(bumpy_sphere(3), .03)}) {
    const Points other = inverted(mesh, Eigen::Vector3d(.4, .3, 3)).positions();
    const double plain = distance_by(CGP::curvature_difference(mesh, other), mesh, other);
    EXPECT_GT(plain, 2e-3);
    for (const double tolerance : {1e-3, 1e-4}) {
      const auto rho = CGP::nearest_curvature_difference(mesh, other, tolerance);
      EXPECT_LT(distance_by(rho, mesh, other), (std::max)(1.5 * tolerance, .1 * plain));
    }
  }
}

TEST(Nearest_curvature_difference, arrives_with_the_binormals_of_a_boundary)
{
  const Mesh_view mesh = jittered_disk(8, .2);
  const Points cap = cap_from_disk(mesh, 1.2).positions();
  const auto rho = CGP::nearest_curvature_difference(mesh, cap);
  EXPECT_LT(distance_by(rho, mesh, cap),
            .5 * distance_by(CGP::curvature_difference(mesh, cap), mesh, cap));
}

TEST(Nearest_curvature_difference, scales_as_a_curvature)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const Points other = inverted(mesh, Eigen::Vector3d(.4, .3, 3)).positions();
  const auto rho = CGP::nearest_curvature_difference(mesh, other, 1e-3),
             of_half = CGP::nearest_curvature_difference(scaled(mesh, .5), 3 * other, 1e-3);
  EXPECT_EQ(rho.on, of_half.on);
  EXPECT_LT((of_half.values - 2 * rho.values).norm(), 1e-6 * rho.values.norm());
}

TEST(Nearest_curvature_difference, is_the_plain_one_if_the_search_is_cancelled)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const Points other = inverted(mesh, Eigen::Vector3d(.4, .3, 3)).positions();
  const auto cancel = [](const CGP::Eigensolver_progress&) { return false; };
  EXPECT_EQ(CGP::nearest_curvature_difference(mesh, other, 1e-4, {}, cancel).values,
            CGP::curvature_difference(mesh, other).values);
}

TEST(Nearest_curvature_difference, refuses_what_does_not_fit)
{
  const Mesh_view mesh = icosphere(1);
  EXPECT_THROW((void)CGP::nearest_curvature_difference(mesh, Points(3, 2)),
               CGP::Precondition_error);
  EXPECT_THROW((void)CGP::nearest_curvature_difference(mesh, mesh.positions(), -1),
               CGP::Precondition_error);
}

}  // namespace cgp_test::nearest_curvature_difference_tests
