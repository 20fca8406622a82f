// Tests include/Conformal_geometry_processing/conformal_class/Edge_scales.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/conformal_class/Edge_scales.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.h"
#include "support/moebius.h"
#include "support/random.h"
#include "support/tori.h"

namespace cgp_test::edge_scales_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::internal::Edge_scales;

TEST(Edge_scales, of_an_inversion_are_known_in_closed_form)
{
  // |F(p) - F(q)| = |p - q| / (|p - c| |q - c|) up to a constant factor: u = -2 log |p - c|.
  const Eigen::Vector3d c(.3, .1, 2.5);
  for (const Mesh_view& mesh : {bumpy_sphere(2), torus(2, 1, 20, 10), disk(4)}) {
    const Edge_scales scales(mesh, CGP::vertex_graph(mesh));
    const Points f = inverted(mesh, c).positions();
    const Eigen::VectorXd u = scales.nearest_scales(f);
    for (int v = 1; v < mesh.size_of_vertices(); ++v)
      EXPECT_NEAR(u[v] - u[0],
                  2 * std::log((mesh.position(0) - c).norm() / (mesh.position(v) - c).norm()),
                  1e-11);
    EXPECT_LT(scales.residuals(f, u).lpNorm<Eigen::Infinity>(), 1e-12);
  }
}

TEST(Edge_scales, are_those_of_least_squares)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const Edge_scales scales(mesh, CGP::vertex_graph(mesh));
  const Points f = perturbed(mesh, .1).positions();
  const Eigen::VectorXd c = scales.residuals(f, scales.nearest_scales(f));
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(mesh.size_of_vertices());
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    for (const int v : mesh.ends(k)) gradient[v] += c[k];
  EXPECT_GT(c.norm(), .1);
  EXPECT_LT(gradient.norm(), 1e-12);
}

TEST(Edge_scales, are_as_exact_as_rounded_coordinates)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const Edge_scales scales(mesh, CGP::vertex_graph(mesh));
  const Eigen::VectorXd u = Eigen::VectorXd::Zero(mesh.size_of_vertices());
  for (const double distance : {1., 1e3, 1e6}) {
    const Eigen::Vector3d o = distance * Eigen::Vector3d(1, -2, 3);
    const Points away = mesh.positions().colwise() + o, back = away.colwise() - o;
    const double change = (scales.residuals(back, u)).lpNorm<Eigen::Infinity>();
    EXPECT_LT(change, scales.rounding(away));
    EXPECT_GT(change, .02 * scales.rounding(away));
  }
}

TEST(Edge_scales, of_a_surface_without_extent_do_not_exist)
{
  const Mesh_view mesh = icosphere(1);
  const Edge_scales scales(mesh, CGP::vertex_graph(mesh));
  EXPECT_THROW(scales.nearest_scales(Points::Zero(3, mesh.size_of_vertices())), CGP::Solver_error);
}

}  // namespace cgp_test::edge_scales_tests
