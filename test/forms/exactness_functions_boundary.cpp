// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/forms/exactness_functions.h
#include <Conformal_geometry_processing/forms/Hodge_decomposition.h>
#include <Conformal_geometry_processing/forms/exactness_functions.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Conformal_geometry_processing/spin/solve_dirac_equation.h>

#include <gtest/gtest.h>

#include "holed_surfaces.h"
#include "support/random.h"

namespace cgp_test::exactness_functions_boundary_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Boundary_condition;
using On = CGP::Curvature_potential::On;

/// a surface with holes, its harmonic forms, and its Dirac equation with a boundary condition
struct Holed {
  Mesh_view mesh;
  Boundary_condition condition;
  CGP::Hodge_decomposition hodge{mesh};
  CGP::internal::Dirac_system system{mesh, condition, "test"};

  Holed(Mesh_view mesh_, Boundary_condition condition_)
      : mesh(std::move(mesh_)), condition(std::move(condition_))
  {}

  Eigen::MatrixXd constraints(On on)
  {
    system.prepare_response();
    const auto respond = [&](const auto& c) { return system.response(c); };
    return CGP::exactness_functions(mesh, hodge.harmonic_basis(), respond, on,
                                    system.coefficients());
  }

  /// of the edges of the surface that rho leads to; number of forms x 3
  Eigen::MatrixXd harmonic_part(On on, const Eigen::VectorXd& rho)
  {
    CGP::Dirac_options options;
    options.tolerance = 1e-11;
    const CGP::internal::Dirac_solution s = CGP::solve_dirac_equation(system, {on, rho}, options);
    EXPECT_TRUE(s.converged);
    return hodge.harmonic_part().coefficients(CGP::transformed_edges(mesh, s.lambda));
  }
};

Mesh_view bumpy(const Mesh_view& flat)
{
  return mapped(flat, [](const Eigen::Vector3d& p) {
    const double x = p.x(), y = p.y();
    return Eigen::Vector3d(x, y,
                           .15 * std::sin(3 * x + 1) * std::cos(2 * y) + .1 * std::cos(4 * y));
  });
}

/// The harmonic part of the new edges, differentiated numerically.
void expect_half_the_derivative(const Mesh_view& mesh, const Boundary_condition& condition)
{
  Holed c(mesh, condition);
  for (const On on : {On::vertices, On::faces}) {
    const Eigen::VectorXd m = on == On::vertices ? CGP::vertex_areas(mesh) : CGP::face_areas(mesh);
    Eigen::VectorXd rho = random_numbers(static_cast<int>(m.size()), 4);
    if (condition.is_self_adjoint()) rho.array() -= m.dot(rho) / m.sum();  // or gamma takes it
    const Eigen::VectorXd predicted = 2 * c.constraints(on).transpose() * m.cwiseProduct(rho);
    const double t = 1e-4;
    const Eigen::MatrixXd derivative =
        (c.harmonic_part(on, t * rho) - c.harmonic_part(on, -t * rho)) / (2 * t);
    const Eigen::VectorXd found = derivative.transpose().reshaped();
    ASSERT_EQ(found.size(), 3 * c.hodge.harmonic_basis().size());
    EXPECT_LT((found - predicted).norm(), 1e-4 * predicted.norm());
    EXPECT_GT(predicted.norm(), 1e-3);
  }
}

TEST(Exactness_functions_with_boundary, of_a_disk_are_none)
{
  Holed c(disk(4), Boundary_condition::tangents());
  EXPECT_EQ(c.constraints(On::vertices).cols(), 0);
  EXPECT_EQ(c.constraints(On::faces).rows(), c.mesh.size_of_faces());
}

TEST(Exactness_functions_with_boundary, are_half_the_derivative_with_binormals)
{
  expect_half_the_derivative(bumpy(annulus(.4, 1, 24, 4)), Boundary_condition::binormals());
}

TEST(Exactness_functions_with_boundary, are_half_the_derivative_with_tangents)
{
  expect_half_the_derivative(bumpy(annulus(.4, 1, 24, 4)), Boundary_condition::tangents());
}

TEST(Exactness_functions_with_boundary, are_half_the_derivative_with_a_free_boundary)
{
  expect_half_the_derivative(bumpy(annulus(.4, 1, 24, 4)), Boundary_condition::free());
}

TEST(Exactness_functions_with_boundary, are_three_for_each_hole_and_six_for_a_handle)
{
  expect_half_the_derivative(bumpy(disk_with_three_holes(6)), Boundary_condition::binormals());
  expect_half_the_derivative(perturbed(torus_with_hole(12, 8), .05),
                             Boundary_condition::binormals());
}

}  // namespace cgp_test::exactness_functions_boundary_tests
