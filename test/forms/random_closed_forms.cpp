// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/forms/random_closed_forms.h
#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/forms/Hodge_decomposition.h>
#include <Conformal_geometry_processing/forms/random_closed_forms.h>
#include <Conformal_geometry_processing/forms/tree_cotree.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/exterior_derivative.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <gtest/gtest.h>

#include <string>

#include "support/handlebodies.h"
#include "support/meshes.h"

namespace cgp_test::random_closed_forms_tests {

namespace CGP = Conformal_geometry_processing;

double greatest(const Eigen::MatrixXd& A)
{
  return A.size() == 0 ? 0 : A.cwiseAbs().maxCoeff();
}

Eigen::MatrixXd harmonic_forms(const Mesh_view& mesh, const Eigen::MatrixXd& generators)
{
  CGP::internal::Grounded_solver laplacian(CGP::vertex_graph(mesh));
  laplacian.factorize(CGP::cotan_laplacian(mesh));
  return CGP::Hodge_decomposition(mesh, generators, laplacian).harmonic_basis().one_forms;
}

TEST(Random_closed_forms, are_closed)
{
  for (const Mesh_view& mesh : {btorus(16), perturbed(btorus(16), 0.05), smooth_handlebody(2, 1)}) {
    const Eigen::MatrixXd forms = CGP::random_closed_forms(mesh, 1);
    EXPECT_LT(greatest(CGP::exterior_derivative_1(mesh) * forms), 1e-12 * greatest(forms));
    EXPECT_GT(greatest(forms), 0.1);
  }
  EXPECT_EQ(CGP::random_closed_forms(icosphere(1), 1).cols(), 0);
}

TEST(Random_closed_forms, lead_to_the_same_harmonic_forms_as_trees)
{
  for (const Mesh_view& mesh : {perturbed(btorus(16), 0.05), smooth_handlebody(2, 1)})
    for (const unsigned seed : {0u, 1u}) {
      const Eigen::MatrixXd a = harmonic_forms(mesh, CGP::closed_generators(mesh));
      const Eigen::MatrixXd b = harmonic_forms(mesh, CGP::random_closed_forms(mesh, seed));
      const Eigen::VectorXd w = CGP::cotan_weights(mesh);
      const Eigen::MatrixXd rotation = a.transpose() * w.asDiagonal() * b;
      EXPECT_LT(greatest(b - a * rotation), 1e-11);
      EXPECT_LT(
          greatest(rotation.transpose() * rotation - Eigen::MatrixXd::Identity(a.cols(), a.cols())),
          1e-11);
    }
}

TEST(Random_closed_forms, are_the_same_for_the_same_seed)
{
  const Mesh_view mesh = btorus(8);
  EXPECT_EQ(CGP::random_closed_forms(mesh, 3), CGP::random_closed_forms(mesh, 3));
  EXPECT_NE(CGP::random_closed_forms(mesh, 3), CGP::random_closed_forms(mesh, 4));
}

TEST(Random_closed_forms, refuse_right_angles)
{
  const Mesh_view mesh = holed_block(1);
  int first = 0;  // the first diagonal of a square
  while (std::abs(CGP::cotan_weights(mesh)[first]) > 0.1) ++first;
  const std::string edge =
      "edge " + std::to_string(mesh.ends(first)[0]) + "-" + std::to_string(mesh.ends(first)[1]);
  try {
    (void)CGP::random_closed_forms(mesh, 1, "my_function");
    ADD_FAILURE() << "not refused";
  } catch (const CGP::Precondition_error& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find("my_function: 32 edges of cotan weight zero, the first is " + edge), 0u)
        << message;
  }
}

}  // namespace cgp_test::random_closed_forms_tests
