// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/forms/loops_of_faces.h
#include <Conformal_geometry_processing/forms/loops_of_faces.h>
#include <Conformal_geometry_processing/forms/tree_cotree.h>

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "support/handlebodies.h"
#include "support/spheres.h"
#include "support/tori.h"

namespace cgp_test::loops_of_faces_tests {

namespace CGP = Conformal_geometry_processing;

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

}  // namespace cgp_test::loops_of_faces_tests
