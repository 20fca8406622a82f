// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests spin/solve_dirac_equation.h
// Tests spin/Spin_residual.h
#include <Conformal_geometry_processing/operators/calculus.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Spin_residual.h>
#include <Conformal_geometry_processing/spin/solve_dirac_equation.h>
#include <Quaternionic_linear_algebra/adapters/Eigen_hermitian_solver_traits.h>

#include "spin/boundary_tools.h"
#include "spin/solved.h"
#include "support/dense.h"

namespace cgp_test::solve_dirac_equation_boundary_tests {

using System = CGP::internal::Dirac_system;
using Q = Quaternion<double>;

/// (X + weight M_V) x, with the matrix of the system
Quaternion_vector<double> shifted(const System& system, double weight,
                                  const Quaternion_vector<double>& x)
{
  Quaternion_vector<double> b = system.matrix() * x;
  for (int v = 0; v < b.size(); ++v) b[v] += weight * system.areas()[v] * x[v];
  return b;
}

class Free_boundary : public testing::Test {
 protected:
  const Mesh_view mesh = perturbed(cap_from_disk(jittered_disk(5, .3), 1), .02);
  const Curvature_potential rho =
      potential_on_faces(mesh, [](const Eigen::Vector3d& p) { return 2 * std::cos(3 * p.x()); });
  System system{mesh, {}, "test", CGP::Eigen_hermitian_solver_traits()};
  const double weight = CGP::nearness_weight(mesh);
};

TEST_F(Free_boundary, has_a_weight_of_ten_edges_on_the_disk_of_the_same_area)
{
  const double alpha = 10 * mean_edge_length(mesh) * pi / area(mesh);
  EXPECT_NEAR(weight, alpha * alpha, 1e-12 * weight);
  const Mesh_view large = scaled(mesh, 3);
  EXPECT_NEAR(CGP::nearness_weight(large), weight / 9, 1e-12 * weight);  // 1/area
}

TEST_F(Free_boundary, gives_the_minimiser_of_energy_plus_distance_from_one)
{
  const CGP::internal::Dirac_solution s = CGP::solve_dirac_equation(system, rho);
  EXPECT_TRUE(s.converged);
  EXPECT_LT(s.residual, 1e-13);
  const auto b = shifted(system, weight, s.lambda);
  for (int v = 0; v < b.size(); ++v)
    EXPECT_LT(norm(b[v] - Q{weight * system.areas()[v], 0, 0, 0}), 1e-12);
}

TEST_F(Free_boundary, reports_the_energy_of_what_it_found)
{
  const CGP::internal::Dirac_solution s = CGP::solve_dirac_equation(system, rho);
  const auto A = CGP::dirac(mesh) * s.lambda;
  const auto R = CGP::potential_matrix(mesh, rho) * s.lambda;
  double energy = 0, mass = 0;
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    energy += mesh.double_area_vector(f).norm() / 2 * squared_norm(A[f] - R[f]);
  for (int v = 0; v < mesh.size_of_vertices(); ++v)
    mass += system.areas()[v] * squared_norm(s.lambda[v]);
  EXPECT_NEAR(s.energy, energy / mass, 1e-12);
  EXPECT_NEAR(s.eigenvalue, std::sqrt(energy / mass), 1e-12);
}

TEST_F(Free_boundary, answers_to_sources_with_the_inverse_for_rho_zero)
{
  const auto c = random_quaternions(mesh.size_of_vertices(), 3);
  system.prepare_response();
  const CGP::Block<Q> x = system.response(CGP::Block<Q>(c));
  EXPECT_LT(greatest_difference(shifted(system, weight, x.col(0)), c), 1e-11);
}

TEST_F(Free_boundary, changes_to_first_order_as_the_response_to_minus_rho)
{
  // (X + a^2 M) lambda = a^2 M 1 with X = (D - rho)^* (D - rho): the derivative of X 1 along rho is
  // -D^* M_F rho.
  const double t = 1e-5;
  const CGP::internal::Dirac_solution plus =
      CGP::solve_dirac_equation(system, Curvature_potential{rho.on, t * rho.values});
  const CGP::internal::Dirac_solution minus =
      CGP::solve_dirac_equation(system, Curvature_potential{rho.on, -t * rho.values});
  Quaternion_vector<double> c = Quaternion_vector<double>::Constant(mesh.size_of_vertices(), Q{});
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    for (int k = 0; k < 3; ++k) {  // D = -e / (2 A), its conjugate transpose e / (2 A)
      const Q adjoint = CGP::imaginary(Eigen::Vector3d(mesh.vector(3 * f + k) / 2));
      c[mesh.corners(f)[at(k)]] += rho.values[f] * adjoint;
    }
  system.prepare_response();
  const CGP::Block<Q> expected = system.response(CGP::Block<Q>(c));
  for (int v = 0; v < mesh.size_of_vertices(); ++v)
    EXPECT_LT(norm((plus.lambda[v] - minus.lambda[v]) / (2 * t) - expected(v, 0)), 1e-6);
}

TEST_F(Free_boundary, has_a_finite_gamma_where_rounding_makes_the_energy_negative)
{
  Points p(3, 3);
  p << -1, 1, 0, -1e-3, -1e-3, 1e-3, 0, 0, 0;
  const Mesh_view triangle(p, {{0, 1, 2}});
  System thin(triangle);
  const CGP::internal::Dirac_solution s = CGP::solve_dirac_equation(
      thin, Curvature_potential::on_vertices(Eigen::Vector3d(-.25, .25, 0)));
  EXPECT_NEAR(s.eigenvalue, 0, 1e-9);  // of rho only the mean over the face counts
}

TEST(Solve_dirac_equation_with_a_boundary, with_rho_zero_and_nothing_to_turn_is_solved_by_one)
{
  const Mesh_view mesh = perturbed(cap_from_disk(jittered_disk(4, .3), 1), .02);
  const Points kept = at_boundary(mesh, [](const Eigen::Vector3d& p, const auto&) { return p; });
  const Points normals =
      at_boundary(mesh, [](const auto&, const auto& frame) { return frame.col(1); });
  for (const Boundary_condition& condition :
       {Boundary_condition::free(), Boundary_condition::tangents(), Boundary_condition::binormals(),
        Boundary_condition::directions({1, 2, 3}), Boundary_condition::positions(kept, normals)}) {
    const CGP::internal::Dirac_solution s =
        solved(mesh, constant_potential(mesh, 0), {}, condition);
    EXPECT_TRUE(s.converged);
    EXPECT_NEAR(s.eigenvalue, 0, 1e-7);
    EXPECT_NEAR(s.overlap, 1, 1e-12);
    for (int v = 0; v < mesh.size_of_vertices(); ++v)
      EXPECT_LT(norm(s.lambda[v] - Quaternion<double>{1, 0, 0, 0}), 1e-7);
  }
}

TEST(Solve_dirac_equation_with_a_boundary, follows_the_mesh)
{
  const Mesh_view before = cap_from_disk(disk(4), 1), after = cap_from_disk(disk(4), 1.4);
  const auto rho = potential_on_vertices(before, [](const auto& p) { return p.x(); });
  for (const Boundary_condition& condition :
       {Boundary_condition::free(),
        Boundary_condition::tangents(
            at_boundary(after, [](const auto&, const auto& frame) { return frame.col(0); }))}) {
    Mesh_view mesh = before;
    CGP::internal::Dirac_system system(mesh, condition);
    (void)CGP::solve_dirac_equation(system, rho);
    mesh.set_positions(after.positions());
    system.update_geometry();
    const CGP::internal::Dirac_solution s = CGP::solve_dirac_equation(system, rho),
                                        expected = solved(after, rho, {}, condition);
    EXPECT_TRUE(expected.converged);
    for (int v = 0; v < mesh.size_of_vertices(); ++v)
      EXPECT_LT(norm(s.lambda[v] - expected.lambda[v]), 1e-8);
  }
}

TEST(Solve_dirac_equation_with_a_boundary, refuses_the_generalized_problem_with_a_boundary)
{
  CGP::Dirac_options options;
  options.problem = CGP::Dirac_options::Eigenproblem::generalized;
  const Mesh_view mesh = disk(2);
  const auto rho = potential_on_faces(mesh, [](const auto& p) { return p.x(); });
  EXPECT_EQ(refusal_of([&] { (void)solved(mesh, rho, options); }),
            "the generalized problem is for closed surfaces only");
}

}  // namespace cgp_test::solve_dirac_equation_boundary_tests
