// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Poisson_reconstruction.h
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <gtest/gtest.h>

#include <limits>

#include "support/Counted_solver_traits.h"
#include "support/dense.h"
#include "support/meshes.h"

namespace cgp_test::poisson_reconstruction_tests {

namespace CGP = Conformal_geometry_processing;

Eigen::MatrixX3d differences(const Mesh_view& mesh, const Points& f)
{
  Eigen::MatrixX3d edges(mesh.size_of_edges(), 3);
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    edges.row(k) = (f.col(mesh.ends(k)[1]) - f.col(mesh.ends(k)[0])).transpose();
  return edges;
}

Points centred(Points f)
{
  const Eigen::Vector3d mean = f.rowwise().mean();
  f.colwise() -= mean;
  return f;
}

CGP::Poisson_reconstruction reconstruction_of(const Mesh_view& mesh)
{
  return {mesh, CGP::vertex_graph(mesh)};
}

double cotan_energy(const Mesh_view& mesh, const Points& f, const Eigen::MatrixX3d& edges)
{
  return CGP::cotan_weights(mesh).dot(
      (differences(mesh, f) - edges).rowwise().squaredNorm().matrix());
}

TEST(Poisson_reconstruction, finds_positions_from_their_edge_vectors_up_to_a_translation)
{
  for (const Mesh_view& mesh : {radially_perturbed(icosphere(2), 0.3), torus(2, 1, 12, 9)}) {
    const CGP::Poisson_reconstruction reconstruction = reconstruction_of(mesh);
    const Points wanted = perturbed(mesh, 0.5, 3).positions();
    const Points f = reconstruction.positions(differences(mesh, wanted));
    EXPECT_LT((f - centred(wanted)).norm(), 1e-11 * wanted.norm());
    EXPECT_LT(f.rowwise().sum().norm(), 1e-11);
    EXPECT_LT(reconstruction.residual(f, differences(mesh, wanted)), 1e-12);
  }
}

TEST(Poisson_reconstruction, of_edges_spun_by_one_quaternion_is_the_spun_surface)
{
  const Mesh_view mesh = radially_perturbed(icosphere(2), 0.1);
  const Quaternion<double> q{0.5, -1, 2, 0.25};
  const auto lambda = Quaternion_vector<double>::Constant(mesh.size_of_vertices(), q);
  const Points f = reconstruction_of(mesh).positions(CGP::transformed_edges(mesh, lambda));
  const Mesh_view expected =
      mapped(mesh, [&](const Eigen::Vector3d& p) { return CGP::spin(q, p); });
  EXPECT_LT((f - centred(expected.positions())).norm(), 1e-12 * f.norm());
}

TEST(Poisson_reconstruction, is_translation_free_and_linear_in_the_edges)
{
  const Mesh_view mesh = icosphere(1);
  const CGP::Poisson_reconstruction reconstruction = reconstruction_of(mesh);
  const Eigen::MatrixX3d a = Eigen::MatrixX3d(
      random_numbers(3 * mesh.size_of_edges(), 1).reshaped(mesh.size_of_edges(), 3));
  const Eigen::MatrixX3d b = Eigen::MatrixX3d(
      random_numbers(3 * mesh.size_of_edges(), 2).reshaped(mesh.size_of_edges(), 3));
  const Points together = reconstruction.positions(2 * a + b);
  const Points apart = 2 * reconstruction.positions(a) + reconstruction.positions(b);
  EXPECT_LT((together - apart).norm(), 1e-12 * apart.norm());
}

TEST(Poisson_reconstruction, minimises_the_cotan_weighted_squares)
{
  const Mesh_view mesh = radially_perturbed(icosphere(1), 0.2);
  const CGP::Poisson_reconstruction reconstruction = reconstruction_of(mesh);
  const Eigen::MatrixX3d edges =
      random_numbers(3 * mesh.size_of_edges(), 7).reshaped(mesh.size_of_edges(), 3);
  const Points f = reconstruction.positions(edges);
  const double least = cotan_energy(mesh, f, edges);
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Points step = perturbed(mesh, 1e-3, seed).positions() - mesh.positions();
    EXPECT_GT(cotan_energy(mesh, f + step, edges), least);
    EXPECT_GT(cotan_energy(mesh, f - step, edges), least);
  }
}

TEST(Poisson_reconstruction, can_take_the_ordering_of_another_solver)
{
  const Mesh_view mesh = icosphere(2);
  const auto pattern = CGP::vertex_graph(mesh);
  CGP::internal::Ordering backwards(at(mesh.size_of_vertices()));
  for (int i = 0; i < mesh.size_of_vertices(); ++i)
    backwards[at(i)] = mesh.size_of_vertices() - 1 - i;
  CGP::internal::Solver_ref<double> solver;
  ASSERT_EQ(solver.analyze(*pattern, backwards), CGP::Solver_status::success);
  const CGP::Poisson_reconstruction other(mesh, pattern, solver);
  EXPECT_NE(other.solver().ordering(), reconstruction_of(mesh).solver().ordering());
  const Eigen::MatrixX3d edges =
      random_numbers(3 * mesh.size_of_edges(), 7).reshaped(mesh.size_of_edges(), 3);
  const Points expected = reconstruction_of(mesh).positions(edges);
  EXPECT_LT((other.positions(edges) - expected).norm(), 1e-12 * expected.norm());
  EXPECT_GT(other.statistics().factor_entries, 0);
}

TEST(Poisson_reconstruction, follows_a_mesh_that_moves_without_another_analysis)
{
  Mesh_view mesh = icosphere(2);
  CGP::Poisson_reconstruction reconstruction(mesh, CGP::vertex_graph(mesh),
                                             Counted_solver_traits());
  const int analyses = Counted_solver_traits::analyses();
  const Eigen::MatrixX3d edges =
      random_numbers(3 * mesh.size_of_edges(), 7).reshaped(mesh.size_of_edges(), 3);
  for (const double amplitude : {0.1, 0.3}) {
    mesh.set_positions(radially_perturbed(mesh, amplitude).positions());
    reconstruction.update_geometry();
    const Points expected = reconstruction_of(mesh).positions(edges);
    EXPECT_LT((reconstruction.positions(edges) - expected).norm(), 1e-13 * expected.norm());
    EXPECT_EQ(reconstruction.residual(expected, edges),
              reconstruction_of(mesh).residual(expected, edges));
  }
  EXPECT_EQ(Counted_solver_traits::analyses(), analyses);
}

TEST(Poisson_reconstruction, residual_is_relative_to_the_edges)
{
  const Mesh_view mesh = icosphere(1);
  const CGP::Poisson_reconstruction reconstruction = reconstruction_of(mesh);
  const Eigen::MatrixX3d edges = differences(mesh, mesh.positions());
  EXPECT_NEAR(reconstruction.residual(1.25 * mesh.positions(), edges), 0.25, 1e-14);
  EXPECT_NEAR(reconstruction.residual(1.25e9 * mesh.positions(), 1e9 * edges), 0.25, 1e-14);
}

TEST(Poisson_reconstruction, refuses_weights_that_are_not_finite)
{
  Points p = icosahedron().positions();
  p(0, 0) = std::numeric_limits<double>::quiet_NaN();
  const Mesh_view mesh(p, icosahedron().corners());
  EXPECT_THROW(reconstruction_of(mesh), CGP::Solver_error);

  Mesh_view moving = icosahedron();
  CGP::Poisson_reconstruction reconstruction(moving, CGP::vertex_graph(moving));
  moving.set_positions(p);
  EXPECT_THROW(reconstruction.update_geometry(), CGP::Solver_error);
}

}  // namespace cgp_test::poisson_reconstruction_tests
