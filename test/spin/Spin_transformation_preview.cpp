// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "support/Counted_solver_traits.h"
#include "support/meshes.h"
#include "support/with_solvers.h"

namespace cgp_test::spin_preview_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;

/// a soft brush on a surface of size about 1
Curvature_potential bump(const Mesh_view& mesh, double amplitude, double x = 1)
{
  Eigen::VectorXd rho(mesh.size_of_vertices());
  for (int v = 0; v < rho.size(); ++v) {
    const Eigen::Vector3d d = mesh.position(v) - Eigen::Vector3d(x, 0, .2);
    rho[v] = amplitude * std::exp(-d.squaredNorm() / .2);
  }
  return Curvature_potential::on_vertices(rho);
}

CGP::Spin_transformation_options bounded(CGP::Spin_transformation_options options = {})
{
  options.scales.bound = 2;
  return options;
}

/// the distance of the surfaces relative to that between the first and the mesh
double relative_error(const Mesh_view& mesh, const CGP::Points& exact, const CGP::Points& found)
{
  return (found - exact).norm() / (exact - mesh.positions()).norm();
}

/// surfaces with and without a boundary, fine and coarse
std::vector<Mesh_view> surfaces()
{
  return {perturbed(icosphere(2), .05), icosphere(4), jittered_disk(8, .2), jittered_disk(16, .2),
          btorus(16)};
}

TEST(Spin_preview, of_no_change_is_the_surface)
{
  for (const Mesh_view& mesh : surfaces()) {
    CGP::Spin_transformation transformation(mesh, bounded());
    const CGP::Spin_result r = transformation.preview(bump(mesh, 0), true);
    EXPECT_TRUE(r.report.converged);
    EXPECT_LT((r.positions - mesh.positions()).cwiseAbs().maxCoeff(), 1e-6);
  }
}

TEST(Spin_preview, is_near_the_transformation)
{
  for (const Mesh_view& mesh : surfaces()) {
    CGP::Spin_transformation transformation(mesh, bounded());
    const CGP::Spin_result wanted = transformation.transform(bump(mesh, 1.5));
    const CGP::Spin_result r = transformation.preview(bump(mesh, 1.5), false);
    EXPECT_LE(r.report.factorizations, 3);
    EXPECT_LT(relative_error(mesh, wanted.positions, r.positions), .03)
        << mesh.size_of_vertices() << " vertices";
    EXPECT_LT(r.report.scales.excess(), 1.01);
  }
}

// Beyond the bound as well.
TEST(Spin_preview, follows_a_brush)
{
  for (const Mesh_view& mesh : surfaces()) {
    CGP::Spin_transformation transformation(mesh, bounded());
    for (int i = 1; i <= 10; ++i) {
      const CGP::Spin_report r = transformation.preview(bump(mesh, .3 * i), true).report;
      EXPECT_TRUE(r.converged) << i;
      EXPECT_LT(r.scales.excess(), 1.05);
    }
    const CGP::Spin_result r = transformation.preview(bump(mesh, 3), true),
                           wanted = transformation.transform(bump(mesh, 3));
    EXPECT_LT(relative_error(mesh, wanted.positions, r.positions), .05)
        << mesh.size_of_vertices() << " vertices";
  }
}

TEST(Spin_preview, starts_again)
{
  const Mesh_view mesh = perturbed(icosphere(2), .05);
  CGP::Spin_transformation transformation(mesh, bounded());
  const CGP::Spin_result first = transformation.preview(bump(mesh, 1), false);
  (void)transformation.preview(bump(mesh, 4, -1), true);
  EXPECT_EQ(transformation.preview(bump(mesh, 1), false).positions, first.positions);
  transformation.set_positions(2 * mesh.positions());
  Curvature_potential rho = bump(mesh, 1);
  rho.values /= 2;
  EXPECT_LT((transformation.preview(rho, true).positions - 2 * first.positions).norm(), 1e-6);
}

TEST(Spin_preview, is_the_transformation_where_that_is_an_eigenvector)
{
  const Mesh_view mesh = perturbed(icosphere(2), .05);
  CGP::Spin_transformation transformation(mesh);
  EXPECT_EQ(transformation.preview(bump(mesh, 1), true).positions,
            transformation.transform(bump(mesh, 1)).positions);
}

TEST(Spin_preview, refuses_infinite_values)
{
  const Mesh_view disk = jittered_disk(6, .2);
  CGP::Spin_transformation transformation(disk, bounded());
  Curvature_potential rho = bump(disk, 1);
  rho.values[3] = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)transformation.preview(rho, true), CGP::Precondition_error);
}

TEST(Spin_preview, tells_all_its_costs)
{
  for (const Mesh_view& mesh : {icosphere(3), jittered_disk(8, .2), btorus(16)}) {
    CGP::Spin_transformation transformation(mesh, bounded(with_solvers<Counted_solver_traits>()));
    for (const double amplitude : {.2, .4}) {
      Counted_solver_traits::reset();
      const CGP::Spin_report report = transformation.preview(bump(mesh, amplitude), true).report;
      EXPECT_GT(report.solves, 0);
      EXPECT_EQ(report.solves, Counted_solver_traits::quaternionic.solves);
      EXPECT_EQ(report.factorizations, Counted_solver_traits::quaternionic.factorizations);
    }
  }
}

}  // namespace cgp_test::spin_preview_tests
