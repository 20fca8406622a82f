// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/forms/Hodge_decomposition.h>
#include <Conformal_geometry_processing/forms/tree_cotree.h>
#include <Conformal_geometry_processing/operators/calculus.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include "random_closed_forms.h"
#include "support/handlebodies.h"
#include "support/meshes.h"

#include <string>

namespace cgp_test::hodge_decomposition_tests {

namespace CGP = Conformal_geometry_processing;

double greatest(const Eigen::MatrixXd& A)
{
  return A.size() == 0 ? 0 : A.cwiseAbs().maxCoeff();
}

Eigen::MatrixXd random_forms(const Mesh_view& mesh, int count)
{
  return random_numbers(count * mesh.size_of_edges(), 5).reshaped(mesh.size_of_edges(), count);
}

std::string message_of_refusal(const Mesh_view& mesh)
{
  try {
    const CGP::Hodge_decomposition hodge(mesh, "my_function");
  } catch (const CGP::Precondition_error& error) {
    return error.what();
  }
  return "not refused";
}

TEST(Hodge_decomposition, splits_any_form_into_orthogonal_parts)
{
  for (const Mesh_view& mesh :
       {icosphere(2), perturbed(btorus(16), 0.05), smooth_handlebody(2, 1), holed_block(3)}) {
    const Eigen::MatrixXd forms = random_forms(mesh, 3);
    const CGP::Hodge_decomposition hodge(mesh);
    const CGP::internal::Hodge_parts parts = hodge.decompose(forms);
    EXPECT_LT(greatest(parts.exact + parts.coexact + parts.harmonic - forms), 1e-14);
    const auto product = [&](const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
      return greatest(a.transpose() * CGP::cotan_weights(mesh).asDiagonal() * b);
    };
    const double size = forms.squaredNorm();
    EXPECT_LT(product(parts.exact, parts.coexact), 1e-13 * size);
    EXPECT_LT(product(parts.exact, parts.harmonic), 1e-13 * size);
    EXPECT_LT(product(parts.coexact, parts.harmonic), 1e-13 * size);
  }
}

TEST(Hodge_decomposition, gives_parts_of_their_kinds)
{
  const Mesh_view mesh = smooth_handlebody(2, 1);
  const Eigen::VectorXd w = CGP::cotan_weights(mesh);
  const CGP::internal::Hodge_parts parts =
      CGP::Hodge_decomposition(mesh).decompose(random_forms(mesh, 2));
  const auto d0 = CGP::exterior_derivative_0(mesh);
  const auto d1 = CGP::exterior_derivative_1(mesh);
  EXPECT_LT(greatest(parts.exact - d0 * parts.potential), 1e-14);
  EXPECT_LT(parts.potential.colwise().mean().norm(), 1e-14);
  EXPECT_LT(greatest(d1 * parts.harmonic), 1e-13);
  EXPECT_LT(greatest(CGP::codifferential(mesh, w, parts.harmonic)), 1e-12);
  EXPECT_LT(greatest(CGP::codifferential(mesh, w, parts.coexact)), 1e-12);
  EXPECT_GT(greatest(parts.harmonic), 1e-3);
}

TEST(Hodge_decomposition, finds_the_function_of_its_differential)
{
  for (const Mesh_view& mesh : {icosphere(2), btorus(16), holed_block(2)}) {
    Eigen::VectorXd u = random_numbers(mesh.size_of_vertices(), 1);
    u.array() -= u.mean();
    const CGP::Hodge_decomposition hodge(mesh);
    const CGP::internal::Hodge_parts parts = hodge.decompose(CGP::exterior_derivative_0(mesh) * u);
    EXPECT_LT(greatest(parts.potential - u), 1e-12);
    EXPECT_LT(greatest(parts.coexact), 1e-12);
    EXPECT_LT(greatest(parts.harmonic), 1e-12);
  }
}

TEST(Hodge_decomposition, leaves_harmonic_and_coexact_forms_alone)
{
  const Mesh_view mesh = btorus(16);
  const CGP::Hodge_decomposition hodge(mesh);
  const Eigen::MatrixXd& harmonic = hodge.harmonic_basis().one_forms;
  EXPECT_LT(greatest(hodge.decompose(harmonic).harmonic - harmonic), 1e-13);
  // star^-1 d1^T b is co-exact
  const Eigen::VectorXd b = random_numbers(mesh.size_of_faces(), 1);
  const Eigen::VectorXd coexact =
      (CGP::exterior_derivative_1(mesh).transpose() * b).cwiseQuotient(CGP::cotan_weights(mesh));
  const CGP::internal::Hodge_parts parts = hodge.decompose(coexact);
  EXPECT_LT(greatest(parts.coexact - coexact), 1e-12 * greatest(coexact));
}

TEST(Hodge_decomposition, of_closed_forms_is_that_of_their_classes)
{
  const Mesh_view mesh = smooth_handlebody(2, 1);
  const CGP::Hodge_decomposition hodge(mesh);
  const Eigen::MatrixXd closed = CGP::closed_generators(mesh);
  EXPECT_LT(greatest(hodge.decompose(closed).coexact), 1e-12);
}

TEST(Hodge_decomposition, can_use_the_factor_of_a_reconstruction)
{
  Mesh_view mesh = btorus(16);
  CGP::Poisson_reconstruction reconstruction(mesh, CGP::vertex_graph(mesh));
  mesh.set_positions(perturbed(mesh, 0.02).positions());
  reconstruction.update_geometry();
  const CGP::Hodge_decomposition hodge(mesh, CGP::closed_generators(mesh), reconstruction.solver());
  const CGP::Hodge_decomposition own(mesh);
  EXPECT_EQ(hodge.weights(), CGP::cotan_weights(mesh));
  EXPECT_LT(greatest(hodge.harmonic_basis().one_forms - own.harmonic_basis().one_forms), 1e-13);
}

TEST(Hodge_decomposition, refuses_what_is_no_connected_surface)
{
  const auto refuses = [](const Mesh_view& mesh, const std::string& what) {
    const std::string message = message_of_refusal(mesh);
    return message.find("my_function: ") == 0 && message.find(what) != std::string::npos;
  };
  EXPECT_TRUE(refuses(disjoint_union(btorus(8), icosphere(1), {9, 0, 0}), "2 components"));
  EXPECT_TRUE(refuses(Mesh_view(), "no faces"));
  EXPECT_TRUE(refuses(
      mapped(btorus(8), [](const Eigen::Vector3d& p) { return Eigen::Vector3d(p.x(), 0, 0); }),
      "of area zero"));
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
    const Eigen::MatrixXd forms = random_closed_forms(mesh, 1);
    EXPECT_LT(greatest(CGP::exterior_derivative_1(mesh) * forms), 1e-12 * greatest(forms));
    EXPECT_GT(greatest(forms), 0.1);
  }
  EXPECT_EQ(random_closed_forms(icosphere(1), 1).cols(), 0);
}

TEST(Random_closed_forms, lead_to_the_same_harmonic_forms_as_trees)
{
  for (const Mesh_view& mesh : {perturbed(btorus(16), 0.05), smooth_handlebody(2, 1)})
    for (const unsigned seed : {0u, 1u}) {
      const Eigen::MatrixXd a = harmonic_forms(mesh, CGP::closed_generators(mesh));
      const Eigen::MatrixXd b = harmonic_forms(mesh, random_closed_forms(mesh, seed));
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
  EXPECT_EQ(random_closed_forms(mesh, 3), random_closed_forms(mesh, 3));
  EXPECT_NE(random_closed_forms(mesh, 3), random_closed_forms(mesh, 4));
}

TEST(Random_closed_forms, refuse_right_angles)
{
  const Mesh_view mesh = holed_block(1);
  int first = 0;  // the first diagonal of a square
  while (std::abs(CGP::cotan_weights(mesh)[first]) > 0.1) ++first;
  const std::string edge =
      "edge " + std::to_string(mesh.ends(first)[0]) + "-" + std::to_string(mesh.ends(first)[1]);
  try {
    (void)random_closed_forms(mesh, 1);
    ADD_FAILURE() << "not refused";
  } catch (const CGP::Precondition_error& error) {
    const std::string message = error.what();
    EXPECT_EQ(
        message.find("random_closed_forms: 32 edges of cotan weight zero, the first is " + edge),
        0u)
        << message;
  }
}

}  // namespace cgp_test::hodge_decomposition_tests
