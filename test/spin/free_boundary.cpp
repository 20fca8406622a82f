// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/free_boundary.h
#include <Conformal_geometry_processing/linear_algebra/adapters/Eigen_hermitian_solver_traits.h>
#include <Conformal_geometry_processing/operators/dirac.h>
#include <Conformal_geometry_processing/spin/free_boundary.h>
#include <Conformal_geometry_processing/templates.h>

#include "spin/boundary_tools.h"
#include "support/dense.h"

namespace {

using namespace cgp_test;
using Problem = CGP::Dirac_eigenproblem<CGP::Eigen_hermitian_solver_traits>;
using Q = Quaternion<double>;

/// (X + weight M_V) x, with the matrix of the problem
Quaternion_vector<double> shifted(const Problem& problem, double weight,
                                  const Quaternion_vector<double>& x)
{
  Quaternion_vector<double> b = problem.matrix() * x;
  for (int v = 0; v < b.size(); ++v) b[v] += weight * problem.areas()[v] * x[v];
  return b;
}

class Free_boundary : public testing::Test {
 protected:
  const Mesh_view mesh = perturbed(cap_from_disk(jittered_disk(5, .3), 1), .02);
  const Curvature_potential rho =
      potential_on_faces(mesh, [](const Eigen::Vector3d& p) { return 2 * std::cos(3 * p.x()); });
  Problem problem{mesh};
  const double weight = CGP::nearness_weight(mesh, problem.areas());
};

}  // namespace

TEST_F(Free_boundary, has_a_weight_of_ten_edges_on_the_disk_of_the_same_area)
{
  const double alpha = 10 * mean_edge_length(mesh) * pi / area(mesh);
  EXPECT_NEAR(weight, alpha * alpha, 1e-12 * weight);
  const Mesh_view large = scaled(mesh, 3);
  const double other = CGP::nearness_weight(large, CGP::vertex_areas(large));
  EXPECT_NEAR(other, weight / 9, 1e-12 * weight);  // 1/area
}

TEST_F(Free_boundary, gives_the_minimiser_of_energy_plus_distance_from_one)
{
  CGP::Dirac_solution s;
  CGP::solve_with_free_boundary(problem, rho, s);
  EXPECT_TRUE(s.converged);
  EXPECT_LT(s.residual, 1e-13);
  const auto b = shifted(problem, weight, s.lambda);
  for (int v = 0; v < b.size(); ++v)
    EXPECT_LT(norm(b[v] - Q{weight * problem.areas()[v], 0, 0, 0}), 1e-12);
}

TEST_F(Free_boundary, reports_the_energy_of_what_it_found)
{
  CGP::Dirac_solution s;
  CGP::solve_with_free_boundary(problem, rho, s);
  const auto A = CGP::dirac(mesh) * s.lambda;
  const auto R = CGP::potential_matrix(mesh, rho) * s.lambda;
  double energy = 0, mass = 0;
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    energy += mesh.double_area_vector(f).norm() / 2 * squared_norm(A[f] - R[f]);
  for (int v = 0; v < mesh.size_of_vertices(); ++v)
    mass += problem.areas()[v] * squared_norm(s.lambda[v]);
  EXPECT_NEAR(s.energy, energy / mass, 1e-12);
  EXPECT_NEAR(s.eigenvalue, std::sqrt(energy / mass), 1e-12);
}

TEST_F(Free_boundary, answers_to_sources_with_the_inverse_for_rho_zero)
{
  const auto c = random_quaternions(mesh.size_of_vertices(), 3);
  const CGP::Block<Q> x = CGP::free_response(problem, CGP::Block<Q>(c));
  EXPECT_LT(greatest_difference(shifted(problem, weight, x.col(0)), c), 1e-11);
}

TEST_F(Free_boundary, changes_to_first_order_as_the_response_to_minus_rho)
{
  // (X + a^2 M) lambda = a^2 M 1 with X = (D - rho)^* (D - rho): the derivative of X 1 along rho is
  // -D^* M_F rho.
  const double t = 1e-5;
  CGP::Dirac_solution plus, minus;
  CGP::solve_with_free_boundary(problem, {rho.on, t * rho.values}, plus);
  CGP::solve_with_free_boundary(problem, {rho.on, -t * rho.values}, minus);
  Quaternion_vector<double> c = Quaternion_vector<double>::Constant(mesh.size_of_vertices(), Q{});
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    for (int k = 0; k < 3; ++k) {  // D = -e / (2 A), its conjugate transpose e / (2 A)
      const Q adjoint = CGP::imaginary(Eigen::Vector3d(mesh.vector(3 * f + k) / 2));
      c[mesh.corners(f)[at(k)]] += rho.values[f] * adjoint;
    }
  const CGP::Block<Q> expected = CGP::free_response(problem, CGP::Block<Q>(c));
  for (int v = 0; v < mesh.size_of_vertices(); ++v)
    EXPECT_LT(norm((plus.lambda[v] - minus.lambda[v]) / (2 * t) - expected(v, 0)), 1e-6);
}

TEST_F(Free_boundary, has_a_finite_gamma_where_rounding_makes_the_energy_negative)
{
  Points p(3, 3);
  p << -1, 1, 0, -1e-3, -1e-3, 1e-3, 0, 0, 0;
  const Mesh_view triangle(p, {{0, 1, 2}});
  Problem thin(triangle);
  CGP::Dirac_solution s;
  CGP::solve_with_free_boundary(thin,
                                Curvature_potential::on_vertices(Eigen::Vector3d(-.25, .25, 0)), s);
  EXPECT_NEAR(s.eigenvalue, 0, 1e-9);  // of rho only the mean over the face counts
}
