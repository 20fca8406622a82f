// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/forms/Harmonic_part.h>
#include <Conformal_geometry_processing/forms/Hodge_decomposition.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include "forms/holed_surfaces.h"
#include "support/handlebodies.h"
#include "support/meshes.h"

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

}  // namespace cgp_test::harmonic_part_tests
