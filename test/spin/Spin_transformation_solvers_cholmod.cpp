// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Spin_transformation.h
#include <Conformal_geometry_processing/linear_algebra/Cholmod_hermitian_solver_traits.h>
#include <Conformal_geometry_processing/linear_algebra/Eigen_hermitian_solver_traits.h>
#include <Conformal_geometry_processing/linear_algebra/inverse_power_method.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <gtest/gtest.h>

#include "support/dense.h"
#include "support/meshes.h"

namespace {

using namespace cgp_test;
namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;

template <class Solver_traits, class Eigensolver_traits = CGP::Lobpcg_eigensolver_traits>
CGP::Spin_result transformed(const Mesh_view& mesh, const CGP::Dirac_options& options = {})
{
  CGP::Spin_transformation<Solver_traits, Eigensolver_traits> transformation(mesh);
  return transformation.transform(
      Curvature_potential::on_vertices(rho_of_section_3_on_vertices(mesh)), options);
}

double difference(const CGP::Spin_result& a, const CGP::Spin_result& b)
{
  EXPECT_NEAR(a.report.eigenvalue, b.report.eigenvalue, 1e-9);
  return std::max((a.positions - b.positions).cwiseAbs().maxCoeff(),
                  greatest_difference(a.lambda, b.lambda));
}

const Mesh_view sphere = icosphere(3);

}  // namespace

TEST(Spin_transformation, is_the_same_with_every_linear_solver)
{
  const CGP::Spin_result a = transformed<CGP::Supernodal_solver_traits>(sphere);
  const CGP::Spin_result b = transformed<CGP::Cholmod_hermitian_solver_traits>(sphere);
  const CGP::Spin_result c = transformed<CGP::Eigen_hermitian_solver_traits>(sphere);
  EXPECT_TRUE(a.report && b.report && c.report);
  EXPECT_LT(difference(a, b), 1e-7);
  EXPECT_LT(difference(a, c), 1e-7);
}

TEST(Spin_transformation, is_the_same_to_ten_digits_with_factors_of_double_and_of_single_precision)
{
  CGP::Dirac_options options;
  options.tolerance = 1e-12;
  const CGP::Spin_result a = transformed<CGP::Supernodal_solver_traits>(sphere, options);
  const CGP::Spin_result b = transformed<CGP::Mixed_supernodal_solver_traits>(sphere, options);
  const CGP::Spin_result c = transformed<CGP::Cholmod_hermitian_solver_traits>(sphere, options);
  EXPECT_TRUE(a.report && b.report && c.report);
  EXPECT_LT(difference(a, b), 1e-10);
  EXPECT_LT(difference(a, c), 1e-10);
}

TEST(Spin_transformation, is_the_same_with_both_eigenvalue_solvers)
{
  CGP::Dirac_options options;
  options.max_iterations = 1000;
  options.tolerance = 1e-7;
  const CGP::Spin_result a = transformed<CGP::Cholmod_hermitian_solver_traits>(sphere);
  const CGP::Spin_result b =
      transformed<CGP::Cholmod_hermitian_solver_traits, CGP::Inverse_power_eigensolver_traits>(
          sphere, options);
  EXPECT_TRUE(b.report);
  EXPECT_LT(difference(a, b), 1e-6);
}

TEST(Spin_transformation, gives_the_same_bits_twice_with_cholmod)
{
  const CGP::Spin_result a = transformed<CGP::Cholmod_hermitian_solver_traits>(sphere);
  const CGP::Spin_result b = transformed<CGP::Cholmod_hermitian_solver_traits>(sphere);
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.lambda, b.lambda);
}
