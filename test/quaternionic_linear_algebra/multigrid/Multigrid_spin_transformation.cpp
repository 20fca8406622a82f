// Tests include/Quaternionic_linear_algebra/multigrid/Multigrid_solver.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Quaternionic_linear_algebra/multigrid/Multigrid_solver.h>

#include <gtest/gtest.h>

#include "support/dense.h"
#include "support/meshes.h"
#include "support/with_solvers.h"

namespace cgp_test::multigrid_spin_transformation_tests {

// Compiled alone: support/dense.h and hermitian_matrices.h each have a dense().

namespace CGP = Conformal_geometry_processing;

template <class Solver_traits>
CGP::Spin_result transformed(const Mesh_view& mesh, double tolerance)
{
  CGP::Spin_transformation transformation(mesh, with_solvers<Solver_traits>());
  transformation.dirac().tolerance = tolerance;
  const auto rho = rho_of_section_3_on_vertices(mesh);
  return transformation.transform(CGP::Curvature_potential::on_vertices(rho));
}

double difference(const CGP::Spin_result& a, const CGP::Spin_result& b)
{
  return std::max((a.positions - b.positions).cwiseAbs().maxCoeff(),
                  greatest_difference(a.lambda, b.lambda));
}

TEST(Multigrid_spin_transformation, is_that_of_the_direct_solver_within_five_tolerances)
{
  const Mesh_view mesh = bumpy_sphere(4);
  const CGP::Spin_result expected = transformed<CGP::Supernodal_solver_traits>(mesh, 1e-11);
  ASSERT_TRUE(expected.report);
  for (const double tolerance : {1e-5, 1e-8}) {
    const CGP::Spin_result result = transformed<CGP::Multigrid_solver_traits>(mesh, tolerance);
    EXPECT_TRUE(result.report);
    EXPECT_LT(difference(result, expected), 5 * tolerance);
  }
}

TEST(Multigrid_spin_transformation, gives_the_same_bits_twice)
{
  const Mesh_view mesh = bumpy_sphere(3);
  const CGP::Spin_result a = transformed<CGP::Multigrid_solver_traits>(mesh, 1e-6);
  const CGP::Spin_result b = transformed<CGP::Multigrid_solver_traits>(mesh, 1e-6);
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.lambda, b.lambda);
}

}  // namespace cgp_test::multigrid_spin_transformation_tests
