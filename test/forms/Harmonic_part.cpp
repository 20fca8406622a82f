// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests forms/Hodge_decomposition.h
#include <Conformal_geometry_processing/forms/Hodge_decomposition.h>
#include <Conformal_geometry_processing/forms/tree_cotree.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Quaternionic_linear_algebra/direct/Grounded_solver.h>

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include "forms/holed_surfaces.h"
#include "support/handlebodies.h"
#include "support/meshes.h"
#include "support/random.h"

namespace cgp_test::harmonic_part_tests {

namespace CGP = Conformal_geometry_processing;

double greatest(const Eigen::MatrixXd& A)
{
  return A.size() == 0 ? 0 : A.cwiseAbs().maxCoeff();
}

Eigen::MatrixXd random_columns(Eigen::Index rows, Eigen::Index count)
{
  return random_numbers(static_cast<int>(rows * count), 5).reshaped(rows, count);
}

TEST(Harmonic_part, has_the_products_and_sums_of_the_forms_of_the_basis)
{
  for (const Mesh_view& mesh :
       {icosphere(1), perturbed(btorus(16), 0.05), smooth_handlebody(3, 1), holed_block(5),
        torus_with_hole(16, 10), disk_with_three_holes(6)}) {
    const CGP::Hodge_decomposition hodge(mesh);
    const CGP::internal::Harmonic_part& part = hodge.harmonic_part();
    const Eigen::MatrixXd& forms = hodge.harmonic_basis().one_forms;
    ASSERT_EQ(part.size(), forms.cols());
    const Eigen::MatrixXd alpha = random_columns(mesh.size_of_edges(), 3),
                          products =
                              forms.transpose() * CGP::cotan_weights(mesh).asDiagonal() * alpha,
                          c = random_columns(part.size(), 2);
    EXPECT_LT(greatest(part.coefficients(alpha) - products), 1e-12 * (1 + greatest(products)));
    EXPECT_LT(greatest(part.combinations(c) - forms * c), 1e-12);
    EXPECT_LT(greatest(part.coefficients(part.combinations(c)) - c), 1e-12);
    EXPECT_LT(greatest(part.one_forms() - forms), 1e-12);
  }
}

TEST(Harmonic_part, of_a_surface_nearby_leads_to_the_same_forms_by_half_the_solves)
{
  for (const Mesh_view& mesh :
       {perturbed(btorus(16), 0.05), smooth_handlebody(3, 1), torus_with_hole(16, 10)}) {
    const Mesh_view moved = perturbed(mesh, .05);
    const auto graph = CGP::vertex_graph(moved);
    CGP::internal::Grounded_solver laplacian(graph);
    laplacian.factorize(CGP::cotan_laplacian(moved, graph));
    const CGP::Hodge_decomposition before(mesh), directly(moved);
    const CGP::Hodge_decomposition from_start(moved, CGP::closed_generators(moved), laplacian,
                                              &before.harmonic_part());
    const Eigen::VectorXd w = CGP::cotan_weights(moved);
    const Eigen::MatrixXd& forms = from_start.harmonic_basis().one_forms;
    const Eigen::MatrixXd turned = directly.harmonic_part().coefficients(forms);
    EXPECT_LT(greatest(directly.harmonic_part().combinations(turned) - forms), 1e-10);
    EXPECT_LT(greatest(from_start.harmonic_part().one_forms() - forms), 1e-11);
    EXPECT_LT(greatest(CGP::codifferential(moved, w, forms)), 1e-10);
  }
}

}  // namespace cgp_test::harmonic_part_tests
