// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Delaunay_view.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <gtest/gtest.h>

#include "quaternionic_linear_algebra/threads/threads.h"
#include "support/meshes.h"

#include <utility>
#include <vector>

namespace cgp_test::vertex_graph_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::internal::Index_range;

/// 4412 vertices, large enough for several ranges, first in an order that keeps neighbours
/// together, then in one without any
class Sheet_loops : public testing::TestWithParam<bool> {
 protected:
  static Mesh_view make_mesh()
  {
    const Mesh_view mesh = geodesic_sphere(21);
    return GetParam() ? renumbered(mesh, random_permutation(mesh.size_of_vertices(), 3)) : mesh;
  }

  const Mesh_view mesh = make_mesh();
};
INSTANTIATE_TEST_SUITE_P(Of_a_random_order, Sheet_loops, testing::Bool());

TEST_P(Sheet_loops, visit_the_corners_of_each_vertex_once_in_their_order)
{
  std::vector<std::vector<int>> expected(static_cast<std::size_t>(mesh.size_of_vertices()));
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    for (const int v : mesh.corners(f)) expected[static_cast<std::size_t>(v)].push_back(f);
  const CGP::internal::Thread_team team;
  for (const int threads : {1, 2, 3}) {
    const Threads setting(threads);
    std::vector<std::vector<int>> met(expected.size());
    CGP::internal::for_each_owned_range(mesh.size_of_vertices(), [&](const Index_range& own) {
      CGP::internal::for_each_sheet_at(own, mesh, [&](const CGP::Sheet& sheet) {
        for (const int v : sheet.corners)
          if (own.contains(v)) met[static_cast<std::size_t>(v)].push_back(sheet.face);
      });
    });
    EXPECT_EQ(met, expected);
  }
}

TEST(Index_range, contains_its_first_and_not_its_last)
{
  const Index_range range{3, 5};
  for (int i = 0; i < 8; ++i) EXPECT_EQ(range.contains(i), i == 3 || i == 4);
  CGP::Sheet sheet;
  sheet.corners = {2, 5, 0};
  EXPECT_FALSE(range.touches(sheet));
  for (int& v : sheet.corners) {
    const int before = std::exchange(v, 4);
    EXPECT_TRUE(range.touches(sheet));
    v = before;
  }
}

Eigen::MatrixXd numbers_of(const CGP::Block<CGP::Quaternion<double>>& columns)
{
  return CGP::components(CGP::Quaternion_vector<double>(columns.reshaped()));
}

/// everything that loops over sheets
std::vector<Eigen::MatrixXd> all_sums(const CGP::Surface_ref& surface,
                                      const CGP::Curvature_potential& rho)
{
  const CGP::Quaternion_vector<double> lambda =
      CGP::random_quaternions(surface.size_of_vertices(), 1, 5).col(0);
  const auto z = CGP::random_quaternions(surface.size_of_vertices(), 2, 6);
  const Eigen::MatrixXd d = Eigen::MatrixXd::Constant(rho.values.size(), 2, .5);
  const auto X = CGP::dirac_energy(surface, rho), K = CGP::dirac_form(surface, rho);
  const Eigen::Vector3d numbers(CGP::dirac_quotient(surface, rho, lambda),
                                CGP::potential_quotient(surface, rho, lambda),
                                CGP::dirac_misfit(surface, rho, lambda));
  return {numbers_of(X * lambda),
          numbers_of(K * lambda),
          numbers_of(CGP::apply_dirac_form(surface, rho, lambda)),
          numbers_of(CGP::internal::energy_change(surface, rho, lambda, d)),
          CGP::internal::energy_gradient(surface, rho, lambda, z),
          CGP::internal::form_gradient(surface, rho.on, lambda),
          numbers};
}

void expect_the_same_bits(const CGP::Surface_ref& surface, const CGP::Curvature_potential& rho)
{
  const auto one = all_sums(surface, rho);
  const CGP::internal::Thread_team team;
  for (const int threads : {2, 3}) {
    const Threads setting(threads);
    const auto sums = all_sums(surface, rho);
    for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(sums[i], one[i]) << i;
  }
}

TEST_P(Sheet_loops, give_operators_the_same_bits_for_any_number_of_threads)
{
  const auto at_vertices = CGP::Curvature_potential::on_vertices(mesh.positions().row(0));
  expect_the_same_bits(mesh, at_vertices);
  const Eigen::VectorXd at_faces = Eigen::VectorXd::LinSpaced(mesh.size_of_faces(), -1, 1);
  expect_the_same_bits(mesh, CGP::Curvature_potential::on_faces(at_faces));
  expect_the_same_bits(CGP::Delaunay_view(mesh), at_vertices);
}

TEST(Vertex_graph, of_two_triangles_has_columns_of_a_diagonal_and_the_larger_neighbours)
{
  const auto pattern = CGP::vertex_graph(unit_square());
  EXPECT_EQ(pattern->offsets, (std::vector<int>{0, 4, 6, 8, 9}));
  EXPECT_EQ(pattern->indices, (std::vector<int>{0, 1, 2, 3, 1, 2, 2, 3, 3}));
}

TEST(Vertex_graph, knows_the_position_of_every_edge_and_vertex)
{
  for (const Mesh_view& mesh : {icosphere(2), disk(4), double_torus(),
                                renumbered(icosphere(1), random_permutation(42, 7))}) {
    const auto pattern = CGP::vertex_graph(mesh);
    EXPECT_EQ(pattern->size(), mesh.size_of_vertices());
    EXPECT_EQ(pattern->size_of_entries(), mesh.size_of_vertices() + mesh.size_of_edges());
    for (int v = 0; v < mesh.size_of_vertices(); ++v)
      EXPECT_EQ(CGP::diagonal_position(*pattern, v), pattern->find(v, v));
    for (int k = 0; k < mesh.size_of_edges(); ++k) {
      const int low = mesh.ends(k)[0], high = mesh.ends(k)[1], place = k + low + 1;
      EXPECT_EQ(pattern->find(high, low), place);
      for (const int edge : {k, k - 1, k + 1, -1, pattern->size_of_entries()})  // others mislead
        EXPECT_EQ(CGP::internal::entry_position(*pattern, high, low, edge), place);
    }
  }
}

TEST(Vertex_graph, keeps_the_diagonal_of_a_vertex_without_faces)
{
  const Mesh_view mesh(Points::Zero(3, 4), {{0, 1, 3}});
  const auto pattern = CGP::vertex_graph(mesh);
  EXPECT_EQ(pattern->offsets, (std::vector<int>{0, 3, 5, 6, 7}));
  EXPECT_EQ(pattern->indices, (std::vector<int>{0, 1, 3, 1, 3, 2, 3}));
}

TEST(Vertex_graph, of_nothing_is_empty)
{
  EXPECT_EQ(CGP::vertex_graph(Mesh_view())->size(), 0);
}

}  // namespace cgp_test::vertex_graph_tests
