// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/spin/Spin_preview.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "support/meshes.h"

namespace cgp_test::spin_preview_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;
using Preview = CGP::internal::Spin_preview;

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
    CGP::Spin_transformation exact(mesh);
    const CGP::Spin_result r = Preview(exact).transform(bump(mesh, 0));
    EXPECT_TRUE(r.report.converged);
    EXPECT_LT((r.positions - mesh.positions()).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(Spin_preview, is_near_the_transformation_after_ten_solves_on_any_mesh)
{
  for (const Mesh_view& mesh : surfaces()) {
    CGP::Spin_transformation exact(mesh);
    const CGP::Spin_result wanted = exact.transform(bump(mesh, 1.5));
    (void)exact.exactness(Curvature_potential::On::vertices);  // once for all strokes
    (void)exact.take_unreported();
    const CGP::Spin_result r = Preview(exact).transform(bump(mesh, 1.5));
    EXPECT_LE(r.report.solves, 10);
    EXPECT_LT(r.report.residual, 5e-3);
    const bool has_loops = wanted.report.missing_share > 0;
    EXPECT_LT(relative_error(mesh, wanted.positions, r.positions), has_loops ? .2 : .02)
        << mesh.size_of_vertices() << " vertices";
  }
}

TEST(Spin_preview, follows_a_brush)
{
  const Mesh_view mesh = perturbed(icosphere(3), .03);
  CGP::Spin_transformation exact(mesh);
  Preview preview(exact);
  int solves = 0;
  for (int i = 1; i <= 10; ++i) {
    const CGP::Spin_result r = preview.transform(bump(mesh, .3 * i));
    EXPECT_TRUE(r.report.converged) << i;
    solves += r.report.solves;
  }
  const Curvature_potential last = bump(mesh, 3);
  const CGP::Spin_result wanted = exact.transform(last), r = preview.transform(last);
  EXPECT_LT(relative_error(mesh, wanted.positions, r.positions), 1e-2);
  EXPECT_NEAR(r.report.eigenvalue, wanted.report.eigenvalue, 1e-3);
  EXPECT_LT(solves, 80);
}

TEST(Spin_preview, does_not_depend_on_the_unit_of_length)
{
  const Mesh_view mesh = perturbed(icosphere(2), .05);
  const double unit = 8;  // rounds alike, in either precision
  const Mesh_view large(CGP::Points(unit * mesh.positions()), mesh.corners());
  CGP::Spin_transformation a(mesh), b(large);
  Curvature_potential rho = bump(mesh, 2);
  const CGP::Spin_result small = Preview(a).transform(rho);
  rho.values /= unit;
  const CGP::Spin_result big = Preview(b).transform(rho);
  EXPECT_LT((big.positions - unit * small.positions).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_NEAR(unit * big.report.eigenvalue, small.report.eigenvalue, 1e-9);
}

TEST(Spin_preview, keeps_handles_closed_to_first_order)
{
  const Mesh_view mesh = btorus(16);
  CGP::Spin_transformation exact(mesh);
  Preview preview(exact);
  double last = 0;
  for (const double amplitude : {.2, .1}) {
    preview.restart();
    const double now = preview.transform(bump(mesh, amplitude)).report.closure_residual;
    if (last > 0) {
      EXPECT_LT(now, .35 * last + 1e-3);
    }
    last = now;
  }
}

TEST(Spin_preview, starts_again)
{
  const Mesh_view mesh = perturbed(icosphere(2), .05);
  CGP::Spin_transformation exact(mesh);
  Preview preview(exact);
  const CGP::Spin_result first = preview.transform(bump(mesh, 1));
  (void)preview.transform(bump(mesh, 4, -1));
  preview.restart();
  const CGP::Spin_result again = preview.transform(bump(mesh, 1));
  EXPECT_EQ(first.positions, again.positions);
}

TEST(Spin_preview, refuses_what_it_does_not_know)
{
  const Mesh_view disk = jittered_disk(6, .2);
  CGP::Spin_transformation_options options;
  options.boundary = CGP::Boundary_condition::tangents();
  CGP::Spin_transformation turned(disk, options), free(disk);
  EXPECT_THROW(Preview{turned}, CGP::Precondition_error);
  Preview preview(free);
  Curvature_potential rho = bump(disk, 1);
  rho.values[3] = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)preview.transform(rho), CGP::Precondition_error);
}

}  // namespace cgp_test::spin_preview_tests
