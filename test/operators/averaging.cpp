// Tests include/Conformal_geometry_processing/operators/averaging.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/averaging.h>

#include <gtest/gtest.h>

#include "support/dense.h"
#include "support/meshes.h"

namespace cgp_test::averaging_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Averaging, takes_the_mean_of_the_corners)
{
  const Mesh_view mesh = disk(3);
  const Quaternion_vector<double> lambda = random_quaternions(mesh.size_of_vertices(), 2);
  const Quaternion_vector<double> B_lambda = CGP::averaging(mesh) * lambda;
  ASSERT_EQ(B_lambda.size(), mesh.size_of_faces());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto& v = mesh.corners(f);
    EXPECT_LT(norm(B_lambda[f] - (lambda[v[0]] + lambda[v[1]] + lambda[v[2]]) / 3.), 1e-15);
  }
}

TEST(Averaging, keeps_constants)
{
  const Mesh_view mesh = icosphere(1);
  const Quaternion<double> q{1, -2, 3, .5};
  const Quaternion_vector<double> lambda = Quaternion_vector<double>::Constant(42, q);
  const Quaternion_vector<double> wanted = Quaternion_vector<double>::Constant(80, q);
  EXPECT_LT(greatest_difference(CGP::averaging(mesh) * lambda, wanted), 1e-15);
}

TEST(Averaging, takes_positions_to_centroids)
{
  const Mesh_view mesh = tetrahedron();  // the centroid of a face is minus a third of its opposite
  const Quaternion_vector<double> centroids =
      CGP::averaging(mesh) * imaginary_columns(mesh.positions());
  const Points wanted = -points({{-1, -1, 1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, 1}}) / 3;
  EXPECT_LT(greatest_difference(centroids, imaginary_columns(wanted)), 1e-15);
}

}  // namespace cgp_test::averaging_tests
