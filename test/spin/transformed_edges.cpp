// Tests include/Conformal_geometry_processing/spin/Poisson_reconstruction.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Delaunay_view.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>

#include <gtest/gtest.h>

#include <array>
#include <map>

#include "support/dense.h"
#include "support/meshes.h"

namespace cgp_test::transformed_edges_tests {

namespace CGP = Conformal_geometry_processing;
using Q = Quaternion<double>;

/// the vectors along the edges i -> j, i < j
Eigen::MatrixX3d edges(const Mesh_view& mesh)
{
  Eigen::MatrixX3d e(mesh.size_of_edges(), 3);
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    e.row(k) = mesh.position(mesh.ends(k)[1]) - mesh.position(mesh.ends(k)[0]);
  return e;
}

TEST(Transformed_edges, are_the_edges_themselves_for_lambda_one)
{
  const Mesh_view mesh = perturbed(icosphere(1), .2);
  const Quaternion_vector<double> one = Quaternion_vector<double>::Constant(42, Q{1, 0, 0, 0});
  EXPECT_LT((CGP::transformed_edges(mesh, one) - edges(mesh)).norm(), 1e-14);
}

TEST(Transformed_edges, turn_by_plus_theta_and_grow_by_the_square_of_a_constant_lambda)
{
  // lambda = 2 (cos(theta/2) - u sin(theta/2)) with u = z and theta = 90 degrees: x goes to 4 y.
  const Mesh_view mesh = single_triangle();
  const Q lambda = 2. * Q{std::sqrt(.5), 0, 0, -std::sqrt(.5)};
  const Eigen::MatrixX3d e =
      CGP::transformed_edges(mesh, Quaternion_vector<double>::Constant(3, lambda));
  Eigen::Matrix3d wanted;
  wanted << 0, 8, 0, -4, 0, 0, -4, -8, 0;  // of (2, 0), (0, 1), (-2, 1)
  EXPECT_LT((e - wanted).norm(), 1e-14);
}

TEST(Transformed_edges, are_the_integral_of_the_spun_edge)
{
  // Simpson's rule is exact for the quadratic conjugate(lambda) e lambda.
  const Mesh_view mesh = perturbed(disk(3), .1);
  const Quaternion_vector<double> lambda = random_quaternions(37, 3);
  const Eigen::MatrixX3d e = edges(mesh), result = CGP::transformed_edges(mesh, lambda);
  for (int k = 0; k < mesh.size_of_edges(); ++k) {
    const Q a = lambda[mesh.ends(k)[0]], b = lambda[mesh.ends(k)[1]], m = (a + b) / 2.;
    const Q v{0, e(k, 0), e(k, 1), e(k, 2)};
    const Q wanted =
        (conjugate(a) * v * a + 4. * (conjugate(m) * v * m) + conjugate(b) * v * b) / 6.;
    EXPECT_NEAR(wanted.w, 0, 1e-15);
    EXPECT_LT((result.row(k).transpose() - CGP::imaginary_part(wanted)).norm(), 1e-14);
  }
}

TEST(Transformed_edges, are_the_same_on_both_views_of_a_Delaunay_mesh)
{
  const Mesh_view mesh = icosphere(2);
  const CGP::Delaunay_view view(mesh);
  const Quaternion_vector<double> lambda = random_quaternions(mesh.size_of_vertices(), 3);
  const Eigen::MatrixX3d a = CGP::transformed_edges(mesh, lambda),
                         b = CGP::transformed_edges(view, lambda);
  ASSERT_EQ(a.rows(), b.rows());
  std::map<std::array<int, 2>, int> number;  // of the edges of the view
  for (int k = 0; k < view.size_of_edges(); ++k) number[view.ends(k)] = k;
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    EXPECT_LT((a.row(k) - b.row(number.at(mesh.ends(k)))).norm(), 1e-12);
}

TEST(Transformed_edges, turn_with_a_right_factor)
{
  const Mesh_view mesh = perturbed(icosphere(1), .2);
  Quaternion_vector<double> lambda = random_quaternions(42, 3);
  const Eigen::MatrixX3d before = CGP::transformed_edges(mesh, lambda);
  const Q q{.5, -1, 2, .3};
  for (Q& l : lambda) l = l * q;
  const Eigen::MatrixX3d after = CGP::transformed_edges(mesh, lambda);
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    EXPECT_LT((after.row(k).transpose() - CGP::spin(q, before.row(k).transpose())).norm(), 1e-13);
}

TEST(Transformed_edges, of_the_normal_turn_the_sphere_inside_out)
{
  // lambda = N on the unit sphere: conjugate(N) df N = -df, up to O(h^2) on an edge.
  const Mesh_view mesh = icosphere(3);
  const auto e = CGP::transformed_edges(mesh, imaginary_columns(mesh.positions()));
  EXPECT_LT((e + edges(mesh)).rowwise().norm().maxCoeff() / mean_edge_length(mesh), 1e-2);
}

TEST(Transformed_edges, of_an_exact_spinor_almost_close_around_faces)
{
  // lambda = 1 / (1 - c f) spins the sphere to its inversion; the sum around a face is O(h^3).
  std::vector<double> h, gap;
  for (int level : {2, 3, 4}) {
    const Mesh_view mesh = icosphere(level);
    Quaternion_vector<double> lambda(mesh.size_of_vertices());
    for (int v = 0; v < lambda.size(); ++v)
      lambda[v] =
          CGP::inverse(Q{1, 0, 0, 0} - Q{0, .3, .2, -.25} * CGP::imaginary(mesh.position(v)));
    const auto e = CGP::transformed_edges(mesh, lambda);
    double greatest = 0;
    for (int f = 0; f < mesh.size_of_faces(); ++f) {
      Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
      for (int k = 3 * f; k < 3 * f + 3; ++k)
        sum += (mesh.from(k) < mesh.to(k) ? 1 : -1) * e.row(mesh.edge(k));
      greatest = std::max(greatest, sum.norm());
    }
    h.push_back(mean_edge_length(mesh));
    gap.push_back(greatest);
  }
  EXPECT_GT(slope(h, gap), 2.7);
}

}  // namespace cgp_test::transformed_edges_tests
