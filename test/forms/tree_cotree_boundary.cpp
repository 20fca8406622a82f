// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/forms/tree_cotree.h
#include <Conformal_geometry_processing/forms/tree_cotree.h>
#include <Conformal_geometry_processing/mesh/topology.h>

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <map>
#include <utility>
#include <vector>

#include "holed_surfaces.h"
#include "support/random.h"

namespace cgp_test::tree_cotree_boundary_tests {

namespace CGP = Conformal_geometry_processing;

/// the integrals of forms along closed paths of vertices: number of forms x number of paths
Eigen::MatrixXd periods(const Mesh_view& mesh, const Eigen::MatrixXd& forms,
                        const std::vector<std::vector<int>>& paths)
{
  std::map<std::pair<int, int>, int> edges;
  for (int k = 0; k < mesh.size_of_edges(); ++k) edges[{mesh.ends(k)[0], mesh.ends(k)[1]}] = k;
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(forms.cols(), Eigen::Index(paths.size()));
  for (std::size_t j = 0; j < paths.size(); ++j)
    for (std::size_t i = 0; i < paths[j].size(); ++i) {
      const int a = paths[j][i], b = paths[j][(i + 1) % paths[j].size()];
      const auto forward = edges.find({a, b});
      sum.col(Eigen::Index(j)) += forward != edges.end()
                                      ? forms.row(forward->second).transpose().eval()
                                      : (-forms.row(edges.at({b, a})).transpose()).eval();
    }
  return sum;
}

double greatest_sum_around_faces(const Mesh_view& mesh, const Eigen::MatrixXd& forms)
{
  double greatest = 0;
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(forms.cols());
    for (int h = 3 * f; h < 3 * f + 3; ++h)
      sum += (mesh.from(h) < mesh.to(h) ? 1 : -1) * forms.row(mesh.edge(h));
    greatest = std::max(greatest, sum.cwiseAbs().maxCoeff());
  }
  return greatest;
}

/// \param paths a basis of the first homology
void expect_dual_to(const Mesh_view& mesh, const std::vector<std::vector<int>>& paths)
{
  const Eigen::MatrixXd forms = CGP::closed_generators(mesh);
  ASSERT_EQ(forms.cols(), Eigen::Index(paths.size()));
  EXPECT_TRUE((forms.array() == forms.array().round()).all());
  EXPECT_EQ(greatest_sum_around_faces(mesh, forms), 0);
  EXPECT_NEAR(std::abs(periods(mesh, forms, paths).determinant()), 1, 1e-9);
}

/// all loops of the boundary but one: they bound the surface together
std::vector<std::vector<int>> boundary_but_one_loop(const Mesh_view& mesh)
{
  std::vector<std::vector<int>> loops = CGP::boundary_loops(mesh);
  loops.pop_back();
  return loops;
}

TEST(Closed_generators_with_boundary, of_a_disk_are_none)
{
  for (const Mesh_view& mesh : {disk(4), grid(5, 3), single_triangle(), cap_from_disk(disk(3), 2)})
    EXPECT_EQ(CGP::closed_generators(mesh).cols(), 0);
}

TEST(Closed_generators_with_boundary, of_an_annulus_wind_around_its_hole_once)
{
  for (const Mesh_view& mesh : {annulus(.4, 1, 24, 3), annulus(.4, 1, 4, 1), cylinder(1, 2, 12, 6)})
    expect_dual_to(mesh, boundary_but_one_loop(mesh));
}

TEST(Closed_generators_with_boundary, of_a_disk_with_holes_are_one_for_each)
{
  const Mesh_view mesh = disk_with_three_holes(6);
  ASSERT_EQ(CGP::topology(mesh).boundary_loops, 4);
  expect_dual_to(mesh, boundary_but_one_loop(mesh));
}

TEST(Closed_generators_with_boundary, of_a_torus_with_holes_wind_around_handle_and_holes)
{
  const int m = 12, n = 8;
  std::vector<int> along, around;  // away from the holes
  for (int i = 0; i < m; ++i) along.push_back(i * n);
  for (int j = 0; j < n; ++j) around.push_back(j);
  const Mesh_view one = without_faces(torus(2, 1, m, n), {2 * (5 * n + 4)});
  ASSERT_EQ(CGP::topology(one).boundary_loops, 1);
  expect_dual_to(one, {along, around});
  const Mesh_view two = without_faces(torus(2, 1, m, n), {2 * (3 * n + 3), 2 * (8 * n + 4)});
  ASSERT_EQ(CGP::topology(two).boundary_loops, 2);
  expect_dual_to(two, {along, around, CGP::boundary_loops(two)[0]});
}

TEST(Closed_generators_with_boundary, are_a_basis_in_any_numbering)
{
  const Mesh_view mesh = disk_with_three_holes(6);
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Mesh_view other = renumbered(mesh, random_permutation(mesh.size_of_vertices(), seed));
    expect_dual_to(other, boundary_but_one_loop(other));
  }
}

}  // namespace cgp_test::tree_cotree_boundary_tests
