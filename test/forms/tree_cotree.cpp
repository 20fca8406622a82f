// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/forms/tree_cotree.h>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "support/handlebodies.h"
#include "support/meshes.h"
#include "support/spheres.h"
#include "support/tori.h"

#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace cgp_test::tree_cotree_tests {

namespace CGP = Conformal_geometry_processing;

/// the values of a form along the three halfedges of face f
Eigen::Vector3d around(const Mesh_view& mesh, const Eigen::VectorXd& form, int f)
{
  Eigen::Vector3d values;
  for (int c = 0; c < 3; ++c) {
    const int h = 3 * f + c;
    values[c] = (mesh.from(h) < mesh.to(h) ? 1 : -1) * form[mesh.edge(h)];
  }
  return values;
}

/// the integrals of the products eta_i ^ eta_j over the surface: how often their loops intersect
Eigen::MatrixXd intersections(const Mesh_view& mesh, const Eigen::MatrixXd& forms)
{
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(forms.cols(), forms.cols());
  Eigen::MatrixX3d a(forms.cols(), 3);
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    for (Eigen::Index i = 0; i < forms.cols(); ++i)
      a.row(i) = around(mesh, forms.col(i), f).transpose();
    sum += (a.col(0) * a.col(1).transpose() - a.col(1) * a.col(0).transpose()) / 2;
  }
  return sum;
}

void expect_basis_of_integer_cohomology(const Mesh_view& mesh, int genus)
{
  const Eigen::MatrixXd forms = CGP::closed_generators(mesh);
  ASSERT_EQ(forms.rows(), mesh.size_of_edges());
  ASSERT_EQ(forms.cols(), 2 * genus);
  EXPECT_TRUE((forms.array() == forms.array().round()).all());
  for (Eigen::Index i = 0; i < forms.cols(); ++i)
    for (int f = 0; f < mesh.size_of_faces(); ++f)
      ASSERT_EQ(around(mesh, forms.col(i), f).sum(), 0) << "form " << i << ", face " << f;
  // The intersection form of a surface is unimodular, so its determinant on classes with integer
  // coefficients is the squared index of the lattice that they span.
  EXPECT_NEAR(intersections(mesh, forms).determinant(), 1, 1e-9);
}

TEST(Closed_generators, of_a_sphere_are_none)
{
  expect_basis_of_integer_cohomology(tetrahedron(), 0);
  expect_basis_of_integer_cohomology(icosphere(2), 0);
}

TEST(Closed_generators, are_a_basis_of_the_integer_cohomology)
{
  expect_basis_of_integer_cohomology(torus(2, 1, 3, 3), 1);
  expect_basis_of_integer_cohomology(btorus(16), 1);
  for (const int genus : {1, 2, 3, 31})
    expect_basis_of_integer_cohomology(holed_block(genus), genus);
}

TEST(Closed_generators, are_a_basis_in_any_numbering)
{
  const Mesh_view mesh = holed_block(3);
  for (std::uint64_t seed = 0; seed < 5; ++seed)
    expect_basis_of_integer_cohomology(
        renumbered(mesh, random_permutation(mesh.size_of_vertices(), seed)), 3);
}

TEST(Closed_generators, of_a_grid_run_along_short_loops)
{
  const Eigen::MatrixXd forms = CGP::closed_generators(torus(2, 1, 30, 20));
  EXPECT_LE(forms.cwiseAbs().maxCoeff(), 1);
  EXPECT_LE(forms.cwiseAbs().colwise().sum().maxCoeff(), 2 * (30 + 20));
}

TEST(Closed_generators, depend_on_the_connectivity_alone)
{
  const Mesh_view mesh = torus(2, 1, 9, 7);
  EXPECT_EQ(CGP::closed_generators(mesh), CGP::closed_generators(perturbed(mesh, 5)));
}

std::vector<std::pair<Mesh_view, std::size_t>> surfaces()
{
  return {{icosphere(1), 0}, {torus(2, 1, 9, 7), 1}, {holed_block(2), 2}, {holed_block(3), 3}};
}

TEST(Loops_of_faces, are_twice_as_many_as_handles_and_meet_no_face_twice)
{
  for (const auto& [mesh, genus] : surfaces()) {
    const std::vector<CGP::internal::Face_loop> loops = CGP::loops_of_faces(mesh);
    EXPECT_EQ(loops.size(), 2 * genus);
    for (const CGP::internal::Face_loop& loop : loops) {
      std::set<int> faces;
      for (std::size_t k = 0; k < loop.size(); ++k) {
        EXPECT_EQ(Mesh_view::face(mesh.twin(loop[k])),
                  Mesh_view::face(loop[(k + 1) % loop.size()]));
        EXPECT_TRUE(faces.insert(Mesh_view::face(loop[k])).second);
      }
    }
  }
}

TEST(Loops_of_faces, cross_what_the_closed_forms_count)
{
  for (const auto& [mesh, genus] : surfaces()) {
    const Eigen::MatrixXd forms = CGP::closed_generators(mesh);
    const std::vector<CGP::internal::Face_loop> loops = CGP::loops_of_faces(mesh);
    for (std::size_t i = 0; i < loops.size(); ++i) {
      Eigen::VectorXd form = Eigen::VectorXd::Zero(mesh.size_of_edges());
      for (const int h : loops[i]) form[mesh.edge(h)] += mesh.from(h) < mesh.to(h) ? 1 : -1;
      EXPECT_EQ(form, forms.col(static_cast<Eigen::Index>(i)));
    }
  }
}

TEST(Crossings_modulo_2, are_those_of_a_basis)
{
  for (const auto& [mesh, genus] : surfaces()) {
    if (genus == 0) continue;
    const Eigen::MatrixXi M = CGP::crossings_modulo_2(mesh, CGP::loops_of_faces(mesh));
    EXPECT_EQ(M, M.transpose());
    EXPECT_EQ(M.diagonal().cwiseAbs().maxCoeff(), 0);
    const double determinant = M.cast<double>().determinant();
    EXPECT_EQ(std::remainder(determinant + 1, 2), 0) << determinant;
  }
}

}  // namespace cgp_test::tree_cotree_tests
