// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Quaternionic_linear_algebra/direct/Default_solver_traits.h>

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

#include "spin/gauge_tools.h"
#include "support/meshes.h"
#include "support/with_solvers.h"

/// What every model of SparseHermitianSolverTraits leaves as it is: the result of a spin
/// transformation. Instantiate over traits.
namespace cgp_test {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;

template <class Solver_traits, class Eigensolver_traits = CGP::Lobpcg_eigensolver_traits>
CGP::Spin_result transformed(const Mesh_view& mesh, const CGP::Dirac_options& options = {})
{
  CGP::Spin_transformation transformation(mesh, with_solvers<Solver_traits>());
  transformation.dirac() = options;
  transformation.dirac().eigensolver = Eigensolver_traits();
  return transformation.transform(
      Curvature_potential::on_vertices(rho_of_section_3_on_vertices(mesh)));
}

/// of two results on a mesh of size about one
inline double difference(const CGP::Spin_result& a, const CGP::Spin_result& b)
{
  return std::max({std::abs(a.report.eigenvalue - b.report.eigenvalue),
                   (a.positions - b.positions).cwiseAbs().maxCoeff(),
                   difference_up_to_right_quaternion(a.lambda, b.lambda)});
}

template <class Solver_traits>
class Spin_solver : public testing::Test {
 protected:
  static void expect_agreement(const Mesh_view& mesh)
  {
    CGP::Dirac_options options;
    options.tolerance = 1e-12;
    const CGP::Spin_result expected = transformed<CGP::Default_solver_traits>(mesh, options);
    const CGP::Spin_result result = transformed<Solver_traits>(mesh, options);
    EXPECT_TRUE(expected.report.converged);
    EXPECT_TRUE(result.report.converged);
    // The transformation does something: this is not the comparison of two identities.
    EXPECT_GT((expected.positions - mesh.positions()).cwiseAbs().maxCoeff(), 0.05);
    EXPECT_LT(difference(expected, result), 1e-10);
  }
};

TYPED_TEST_SUITE_P(Spin_solver);

TYPED_TEST_P(Spin_solver, gives_ten_digits_of_the_default_on_a_noisy_bumpy_sphere)
{
  this->expect_agreement(radially_perturbed(bumpy_sphere(3), 0.01));
}

TYPED_TEST_P(Spin_solver, gives_ten_digits_of_the_default_on_an_irregular_scan)
{
  this->expect_agreement(scan(800));
}

REGISTER_TYPED_TEST_SUITE_P(Spin_solver, gives_ten_digits_of_the_default_on_a_noisy_bumpy_sphere,
                            gives_ten_digits_of_the_default_on_an_irregular_scan);

}  // namespace cgp_test
