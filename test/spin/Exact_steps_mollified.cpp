// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Exact_steps.h
#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <gtest/gtest.h>

#include <cmath>

#include "support/bounded_meshes.h"
#include "support/meshes.h"
#include "support/thin_faces.h"

namespace cgp_test::exact_steps_mollified_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;
using CGP::Spin_result;

const auto both = {Curvature_potential::On::vertices, Curvature_potential::On::faces};

/// a function of space, at the vertices or in the middle of the faces
Curvature_potential rho_of(const Mesh_view& mesh, Curvature_potential::On on, double strength)
{
  const bool on_faces = on == Curvature_potential::On::faces;
  Eigen::VectorXd rho(on_faces ? mesh.size_of_faces() : mesh.size_of_vertices());
  for (int i = 0; i < rho.size(); ++i) {
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    if (on_faces)
      for (const int v : mesh.corners(i)) p += mesh.position(v) / 3;
    else
      p = mesh.position(i);
    rho[i] = strength * (std::sin(2 * p.x() + 1) * std::cos(1.5 * p.y()) + p.z() / 2);
  }
  return {on, rho};
}

Spin_result robust(const Mesh_view& mesh, const Curvature_potential& rho,
                   CGP::Spin_transformation_options options = {})
{
  options.mollification = 1e-6;
  return CGP::Spin_transformation(mesh, options).transform(rho);
}

/// an annulus with bumps
Mesh_view bumpy_annulus(int m, int n)
{
  return mapped(annulus(.4, 1, m, n), [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p.x(), p.y(), .4 * std::sin(2 * p.x() + p.y()) + .3 * p.y() * p.y());
  });
}

double distance(const Spin_result& result, const Spin_result& expected)
{
  return CGP::align(Points(result.positions.leftCols(expected.positions.cols())),
                    expected.positions)
      .max;
}

TEST(Exact_steps_mollified, of_a_Delaunay_torus_is_the_moving_mesh)
{
  const Mesh_view mesh = torus(1, .5, 24, 12);
  for (const auto on : both) {
    const Curvature_potential rho = rho_of(mesh, on, .8);
    const Spin_result expected = CGP::Spin_transformation(mesh).transform(rho),
                      result = robust(mesh, rho);
    ASSERT_TRUE(expected.report.converged && result.report.converged);
    EXPECT_EQ(expected.report.steps, 1);  // after which it is no longer Delaunay
    EXPECT_GT(expected.report.missing_share, .5);
    EXPECT_NEAR(result.report.missing_share, expected.report.missing_share,
                1e-3);  // areas of the next step
    EXPECT_NEAR(result.report.period_defect, expected.report.period_defect, 1e-8);
    EXPECT_LT(distance(result, expected), 1e-8);
  }
}

TEST(Exact_steps_mollified, makes_of_a_spoilt_torus_the_same_shape)
{
  const Mesh_view clean = torus(1, .5, 56, 28), mesh = spoilt(clean);
  EXPECT_THROW(CGP::Spin_transformation{mesh}, CGP::Precondition_error);
  const auto on = Curvature_potential::On::vertices;
  const Spin_result expected = CGP::Spin_transformation(clean).transform(rho_of(clean, on, .3)),
                    result = robust(mesh, rho_of(mesh, on, .3));
  ASSERT_TRUE(expected.report.converged && result.report.converged);
  EXPECT_GT(result.report.mollification.flipped_edges, 1000);
  EXPECT_EQ(result.report.reached, 1);
  EXPECT_LT(result.report.period_defect, .02);
  EXPECT_NEAR(result.report.missing_share, expected.report.missing_share, .01);
  EXPECT_LT(distance(result, expected), 1e-3);
  EXPECT_LT(result.report.conformality.quasi_conformal.mean, 1.02);
  EXPECT_EQ(result.report.conformality.flipped_faces, 0);
}

TEST(Exact_steps_mollified, goes_on_from_the_surface_of_the_step_before)
{
  const Mesh_view clean = torus(1, .5, 48, 24), mesh = spoilt(clean);
  CGP::Spin_transformation_options options;
  options.max_period_defect = 1e-5;  // which needs steps, as the torus is isothermic
  for (const auto on : both) {
    const Spin_result expected =
                          CGP::Spin_transformation(clean, options).transform(rho_of(clean, on, 2)),
                      result = robust(mesh, rho_of(mesh, on, 2), options);
    ASSERT_TRUE(expected.report.converged && result.report.converged);
    EXPECT_GT(result.report.steps, 1);
    EXPECT_EQ(result.report.reached, 1);
    EXPECT_LE(result.report.period_defect, 1e-5);
    EXPECT_LT(distance(result, expected), .05);  // of a strong rho
  }
}

TEST(Exact_steps_mollified, leaves_handles_open_if_it_is_told_to)
{
  const Mesh_view mesh = spoilt(torus(1, .5, 24, 12));
  const Curvature_potential rho = rho_of(mesh, Curvature_potential::On::vertices, .8);
  CGP::Spin_transformation_options open;
  open.exactness.reset();
  const Spin_result sheared = robust(mesh, rho, open), closed = robust(mesh, rho);
  EXPECT_EQ(sheared.report.missing_share, 0);
  EXPECT_GT(closed.report.missing_share, .5);
  EXPECT_GT(sheared.report.closure_residual, 3 * closed.report.closure_residual);
}

TEST(Exact_steps_mollified, keeps_holes_closed)
{
  const Mesh_view clean = bumpy_annulus(60, 12), mesh = spoilt(clean);
  const auto on = Curvature_potential::On::vertices;
  const Spin_result expected = CGP::Spin_transformation(clean).transform(rho_of(clean, on, .4)),
                    result = robust(mesh, rho_of(mesh, on, .4));
  ASSERT_TRUE(expected.report.converged && result.report.converged);
  // The weight of a free boundary goes with the length of the edges, which are shorter here.
  EXPECT_LT(distance(result, expected), .01);
  EXPECT_LT(result.report.period_defect, .02);
  EXPECT_LT(result.report.closure_residual, .02);
  EXPECT_LT(result.report.conformality.quasi_conformal.mean, 1.02);
  EXPECT_EQ(result.report.conformality.flipped_faces, 0);
}

}  // namespace cgp_test::exact_steps_mollified_tests
