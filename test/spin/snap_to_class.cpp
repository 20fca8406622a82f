// Tests spin/Spin_report.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/random.h"
#include "support/tori.h"

#include <cmath>

namespace cgp_test::snap_to_class_tests {

namespace CGP = Conformal_geometry_processing;

CGP::Curvature_potential waves(const Mesh_view& mesh, double amplitude)
{
  return CGP::Curvature_potential::on_vertices(
      amplitude * (3 * mesh.positions().row(1)).array().sin().matrix().transpose());
}

CGP::Spin_result transformed(const Mesh_view& mesh, double amplitude,
                             CGP::Spin_transformation_options options = {})
{
  options.exact_conformal_class = true;
  return CGP::Spin_transformation(mesh, options).transform(waves(mesh, amplitude));
}

double change(const Mesh_view& mesh, const CGP::Spin_result& result)
{
  return CGP::length_cross_ratio_change(mesh, result.positions).max;
}

TEST(Move_to_class, keeps_length_cross_ratios_on_spheres_tori_disks_and_rings)
{
  for (const Mesh_view& mesh : {bumpy_sphere(3), irregular_torus(2, 1, 24, 12), disk(8)}) {
    const CGP::Spin_result off = CGP::Spin_transformation(mesh).transform(waves(mesh, .8));
    const CGP::Spin_result on = transformed(mesh, .8);
    ASSERT_TRUE(on.report);
    ASSERT_TRUE(on.report.exact_class.has_value());
    EXPECT_GT(change(mesh, off), 1e-3);
    EXPECT_LT(change(mesh, on), 1e-10);
    EXPECT_NEAR(on.report.exact_class->initial_length_cross_ratio.max, change(mesh, off), 1e-6);
    EXPECT_LT(on.report.exact_class->length_cross_ratio.max, 1e-10);
    EXPECT_LT(on.report.conformality.length_cross_ratio.max, 1e-10);
    EXPECT_LT(on.report.exact_class->displacement, .03);
    EXPECT_FALSE(off.report.exact_class.has_value());
  }
}

// Their geometric mean at the ends of an edge is the factor of its length, area and all.
TEST(Move_to_class, leaves_spins_that_scale_edges_exactly)
{
  const Mesh_view mesh = bumpy_sphere(3);
  const CGP::Spin_result result = transformed(mesh, .8);
  const Mesh_view moved(result.positions, mesh.corners());
  for (int k = 0; k < mesh.size_of_edges(); ++k) {
    const auto [i, j] = mesh.ends(k);
    const double before = (mesh.position(j) - mesh.position(i)).norm();
    const double after = (moved.position(j) - moved.position(i)).norm();
    EXPECT_NEAR(norm(result.lambda[i]) * norm(result.lambda[j]) * before / after, 1, 1e-9);
  }
}

// The discretisation error is all that there is to take back.
TEST(Move_to_class, moves_by_less_on_finer_meshes)
{
  double coarse = 1;
  for (const int level : {2, 3, 4}) {
    const CGP::Spin_result result = transformed(bumpy_sphere(level), .5);
    EXPECT_LT(result.report.exact_class->displacement, .5 * coarse);
    coarse = result.report.exact_class->displacement;
  }
}

// As the tangents of the disk are those of a plane curve, any rho can be had.
TEST(Move_to_class, leaves_directions_at_the_boundary_as_the_transformation_has_them)
{
  const Mesh_view mesh = disk(10);
  for (const auto& condition :
       {CGP::Boundary_condition::tangents(), CGP::Boundary_condition::binormals()}) {
    CGP::Spin_transformation_options options;
    options.boundary = condition;
    const auto off = CGP::Spin_transformation(mesh, options).transform(waves(mesh, .8));
    const CGP::Spin_result on = transformed(mesh, .8, options);
    EXPECT_TRUE(on.report);
    EXPECT_LT(change(mesh, on), 1e-10);
    EXPECT_GT(change(mesh, off), 1e-4);
    EXPECT_NEAR(on.report.direction_error.mean, off.report.direction_error.mean, 1e-3);
  }
}

TEST(Move_to_class, keeps_a_bound_on_scales)
{
  const Mesh_view mesh = bumpy_sphere(3);
  for (const double bound : {1.2, 1.35, 1.5}) {
    CGP::Spin_transformation_options options;
    options.scales.bound = bound;
    const CGP::Spin_result result = transformed(mesh, 1.5, options);
    EXPECT_TRUE(result.report) << to_string(result.report.fault());
    EXPECT_LE(result.report.scales.excess(), 1);
    EXPECT_EQ(result.report.scales.bound, bound);
    EXPECT_LT(result.report.scales.kept_norm, 1);
    EXPECT_LT(change(mesh, result), 1e-10);
  }
}

// A rho that is within the bound only off the class.
TEST(Move_to_class, keeps_a_bound_that_the_way_to_the_class_would_exceed)
{
  const Mesh_view mesh = bumpy_sphere(2);
  int exceeded = 0;
  for (const double amplitude : {.4, .6, .8, 1.}) {
    CGP::Spin_transformation_options options;
    options.scales.bound = 100;
    const auto free = CGP::Spin_transformation(mesh, options).transform(waves(mesh, amplitude));
    options.scales.bound = std::pow(100, free.report.scales.excess() * (1 + 1e-9));
    const CGP::Spin_result result = transformed(mesh, amplitude, options);
    EXPECT_TRUE(result.report) << to_string(result.report.fault());
    EXPECT_LE(result.report.scales.excess(), 1);
    EXPECT_LT(change(mesh, result), 1e-10);
    exceeded += result.report.scales.weight > 0;
  }
  EXPECT_GT(exceeded, 0);
}

TEST(Move_to_class, of_the_intrinsic_triangulation_with_mollification)
{
  CGP::Spin_transformation_options options;
  options.mollification = 1e-6;
  const CGP::Spin_result result = transformed(perturbed(icosphere(2), .3), .5, options);
  EXPECT_TRUE(result.report);
  EXPECT_LT(result.report.exact_class->length_cross_ratio.max, 1e-10);
  EXPECT_GT(result.report.conformality.length_cross_ratio.max, 1e-10);
}

TEST(Move_to_class, rejects_prescribed_positions_and_edges_without_length)
{
  Mesh_view mesh = disk(4);
  CGP::Spin_transformation_options options;
  options.exact_conformal_class = true;
  options.boundary.kind = CGP::Boundary_condition::Kind::positions;
  options.boundary.targets = mesh.positions();
  EXPECT_THROW((CGP::Spin_transformation(mesh, options)), CGP::Precondition_error);
  options.boundary = {};
  options.mollification = 1e-6;
  Points p = mesh.positions();
  p.col(1) = p.col(0);
  EXPECT_THROW((CGP::Spin_transformation({p, mesh.corners()}, options)), CGP::Precondition_error);
}

TEST(Move_to_class, faults_where_it_is_not_reached)
{
  CGP::Spin_report report = transformed(bumpy_sphere(2), .5).report;
  ASSERT_TRUE(report);
  report.exact_class->converged = false;
  EXPECT_EQ(report.fault(), CGP::Spin_report::Fault::exact_class);
}

}  // namespace cgp_test::snap_to_class_tests
