// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Target_mismatch.h
#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Target_mismatch.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/meshes.h"

namespace cgp_test::target_mismatch_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::internal::Target_mismatch;

Target_mismatch mismatch_of(const Mesh_view& mesh, const Points& target, double normal_weight = 1,
                            double tolerance = 0)
{
  return {mesh, target, CGP::vertex_areas(mesh), normal_weight, tolerance};
}

Points stretched(Points p)
{
  p.row(2) *= 1.3;
  return p;
}

/// two squares of area 4 with the angle between them, 6 points
Points folded(double angle)
{
  const double c = std::cos(angle / 2), s = std::sin(angle / 2);
  Points p(3, 6);
  p.row(0) << -c, 0, c, -c, 0, c;
  p.row(1) << 0, 0, 0, 1, 1, 1;
  p.row(2) << s, 0, s, s, 0, s;
  return 2 * p;
}

Mesh_view::Corners folded_corners()
{
  return {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
}

Points similar(const Points& p, double size)
{
  const Eigen::AngleAxisd turn(.8, Eigen::Vector3d(1, 2, -2).normalized());
  return ((size * turn.toRotationMatrix()) * p).colwise() + size * Eigen::Vector3d(3, -1, 2);
}

TEST(Target_mismatch, of_the_target_is_zero_wherever_and_however_large_it_is)
{
  const Mesh_view mesh = perturbed(bumpy_sphere(2), .05);
  const Points target = stretched(mesh.positions());
  const Target_mismatch mismatch = mismatch_of(mesh, target);
  for (const double size : {1e-60, 1., 1e60}) {
    const Target_mismatch::Value here = mismatch(similar(target, size));
    EXPECT_LT(here.alignment.rms, 1e-12);
    EXPECT_LT(here.normals, 1e-12);
  }
}

TEST(Target_mismatch, of_a_surface_does_not_depend_on_the_size_of_the_target)
{
  const Mesh_view mesh = perturbed(bumpy_sphere(2), .05);
  const Points target = stretched(mesh.positions());
  const Target_mismatch::Value wanted = mismatch_of(mesh, target).source();
  for (const double size : {1e-150, 1e-80, 1e80, 1e150}) {
    const Target_mismatch::Value value = mismatch_of(mesh, size * target).source();
    EXPECT_NEAR(value.alignment.rms, wanted.alignment.rms, 1e-12) << size;
    EXPECT_NEAR(value.normals, wanted.normals, 1e-12) << size;
  }
}

TEST(Target_mismatch, of_the_mesh_is_one_and_the_weight)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const Points target = stretched(mesh.positions());
  for (const double weight : {0., 1., 3.}) {
    const Target_mismatch mismatch = mismatch_of(mesh, target, weight);
    const Target_mismatch::Value source = mismatch.source();
    EXPECT_NEAR(mismatch.sum(source.alignment.rms, source.normals), 1 + weight, 1e-12);
  }
}

// Waves of a hundredth of the radius, of ever smaller lengths: positions hardly tell them apart.
TEST(Target_mismatch, tells_wrinkles_from_waves_by_the_normals)
{
  const Mesh_view mesh = icosphere(4);
  const Target_mismatch mismatch = mismatch_of(mesh, stretched(mesh.positions()));
  const auto waved = [&](int waves) {
    return mismatch(mapped(mesh, [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
                      return (1 + .01 * std::sin(waves * p.z())) * p;
                    }).positions());
  };
  const Target_mismatch::Value few = waved(4), many = waved(16);
  EXPECT_NEAR(many.alignment.rms, few.alignment.rms, .1 * few.alignment.rms);
  EXPECT_GT(many.normals, 1.1 * few.normals);
}

// Either half is turned by half of the angle.
TEST(Target_mismatch, is_the_root_mean_square_chord_of_the_normals)
{
  const Mesh_view mesh(folded(0), folded_corners());
  const Target_mismatch mismatch = mismatch_of(mesh, folded(.6));
  EXPECT_NEAR(mismatch.source().normals, 2 * std::sin(.15), 1e-12);
}

TEST(Target_mismatch, of_flat_surfaces_is_finite)
{
  const Mesh_view mesh(folded(0), folded_corners());
  const Target_mismatch mismatch = mismatch_of(mesh, mesh.positions());
  EXPECT_EQ(mismatch.sum(mismatch.source().alignment.rms, mismatch.source().normals), 0);
}

// A displacement by e of details of 1 % of the diagonal turns normals by 100 e.
TEST(Target_mismatch, is_reached_within_the_tolerance_of_positions_and_normals)
{
  const Mesh_view mesh = bumpy_sphere(1);
  const Points target = stretched(mesh.positions());
  const double e = 1e-3;
  const Target_mismatch both = mismatch_of(mesh, target, 1, e),
                        positions_alone = mismatch_of(mesh, target, 0, e);
  EXPECT_TRUE(both.is_reached(.9 * e, 90 * e));
  EXPECT_FALSE(both.is_reached(1.1 * e, 0));
  EXPECT_FALSE(both.is_reached(0, 110 * e));
  EXPECT_TRUE(positions_alone.is_reached(.9 * e, 2));
  EXPECT_FALSE(positions_alone.is_reached(1.1 * e, 0));
}

TEST(Target_mismatch, refuses_weights_and_tolerances_below_zero)
{
  const Mesh_view mesh = icosphere(1);
  for (const double bad : {-1., std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(mismatch_of(mesh, mesh.positions(), bad), CGP::Precondition_error);
    EXPECT_THROW(mismatch_of(mesh, mesh.positions(), 1, bad), CGP::Precondition_error);
  }
}

}  // namespace cgp_test::target_mismatch_tests
