// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Poisson_reconstruction.h
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>

#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.h"

namespace cgp_test::closure_residual_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::internal::closure_residual;

Eigen::MatrixX3d edges_of(const Mesh_view& mesh)
{
  Eigen::MatrixX3d edges(mesh.size_of_edges(), 3);
  for (int k = 0; k < edges.rows(); ++k)
    edges.row(k) = mesh.position(mesh.ends(k)[1]) - mesh.position(mesh.ends(k)[0]);
  return edges;
}

TEST(closure_residual, vanishes_for_the_edges_of_the_positions_and_measures_a_factor)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const Eigen::VectorXd w = CGP::cotan_weights(mesh);
  const Eigen::MatrixX3d edges = edges_of(mesh);
  EXPECT_EQ(closure_residual(mesh, w, mesh.positions(), edges), 0);
  EXPECT_NEAR(closure_residual(mesh, w, 1.25 * mesh.positions(), edges), .25, 1e-14);
}

TEST(closure_residual, is_a_norm_also_if_weights_are_negative)
{
  const Mesh_view mesh = tetrahedron();
  Eigen::MatrixX3d edges = edges_of(mesh);
  Eigen::VectorXd w = Eigen::VectorXd::Ones(6);
  w[2] = -1;
  const double total = edges.squaredNorm();
  edges.row(2) *= 2;
  const double one = edges.row(2).squaredNorm() / 4;
  EXPECT_NEAR(closure_residual(mesh, w, mesh.positions(), edges),
              std::sqrt(one / (total + 3 * one)), 1e-14);
}

}  // namespace cgp_test::closure_residual_tests
