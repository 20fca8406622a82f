// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
// Tests forms/Dirac_energy_inverse.h
#include <Conformal_geometry_processing/forms/Dirac_energy_inverse.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>

#include <gtest/gtest.h>

#include <limits>

#include "support/dense.h"
#include "support/meshes.h"

namespace {

using namespace cgp_test;
namespace CGP = Conformal_geometry_processing;

/// columns of random quaternions without sum
Quaternion_matrix sources(int rows, int columns)
{
  Quaternion_matrix c = zero_matrix(rows, columns);
  for (int j = 0; j < columns; ++j) {
    c.col(j) = random_quaternions(rows, static_cast<std::uint64_t>(j));
    Quaternion<double> sum{};
    for (int i = 1; i < rows; ++i) sum += c(i, j);
    c(0, j) = -sum;
  }
  return c;
}

Quaternion<double> weighted_sum(const Eigen::VectorXd& m, const Quaternion_vector<double>& y)
{
  Quaternion<double> sum{};
  for (Eigen::Index i = 0; i < y.size(); ++i) sum += m[i] * y[i];
  return sum;
}

CGP::Curvature_potential zero_potential(const Mesh_view& mesh)
{
  return CGP::Curvature_potential::on_vertices(Eigen::VectorXd::Zero(mesh.size_of_vertices()));
}

/// solves with a factor of its own
struct Inverse {
  CGP::Dirac_system<> system;
  explicit Inverse(const Mesh_view& mesh) : system(mesh) { system.prepare_response(); }
  Quaternion_matrix operator()(const Quaternion_matrix& c) const { return system.response(c); }
};

void expect_solutions(const Mesh_view& mesh, const Quaternion_matrix& Y, const Quaternion_matrix& c)
{
  ASSERT_EQ(Y.cols(), c.cols());
  const auto X = CGP::dirac_energy(mesh, zero_potential(mesh));
  const Eigen::VectorXd m = CGP::vertex_areas(mesh);
  for (Eigen::Index j = 0; j < c.cols(); ++j) {
    EXPECT_LT(greatest_difference(X * Y.col(j), c.col(j)), 1e-8 * greatest_entry(c));
    EXPECT_LT(norm(weighted_sum(m, Y.col(j))), 1e-11 * m.sum() * greatest_entry(Y));
  }
}

}  // namespace

TEST(Dirac_energy_inverse, inverts_the_matrix_on_vectors_without_sum)
{
  for (const Mesh_view& mesh : {icosphere(2), perturbed(btorus(12), 0.04)}) {
    const Inverse inverse(mesh);
    const Quaternion_matrix c = sources(mesh.size_of_vertices(), 11);
    expect_solutions(mesh, inverse(c), c);
  }
}

TEST(Dirac_energy_inverse, passes_over_what_has_no_solution)
{
  const Mesh_view mesh = btorus(12);
  const Inverse inverse(mesh);
  const Quaternion_matrix c = sources(mesh.size_of_vertices(), 1);
  Quaternion_matrix shifted = c;
  for (Eigen::Index i = 0; i < c.rows(); ++i) shifted(i, 0) += Quaternion<double>{1, -2, 3, 4};
  expect_solutions(mesh, inverse(shifted), c);
}

TEST(Dirac_energy_inverse, of_nothing_is_nothing)
{
  const Mesh_view mesh = icosphere(1);
  const Inverse inverse(mesh);
  EXPECT_EQ(inverse(zero_matrix(mesh.size_of_vertices(), 0)).cols(), 0);
  EXPECT_EQ(greatest_entry(inverse(zero_matrix(mesh.size_of_vertices(), 2))), 0);
}

TEST(Dirac_energy_inverse, follows_a_mesh_that_moves)
{
  Mesh_view mesh = btorus(12);
  Inverse inverse(mesh);
  const auto structure = inverse.system.solver().structure();
  mesh.set_positions(perturbed(mesh, 0.04).positions());
  inverse.system.update_geometry();
  inverse.system.prepare_response();
  EXPECT_EQ(inverse.system.solver().structure(), structure);
  const Quaternion_matrix c = sources(mesh.size_of_vertices(), 2);
  expect_solutions(mesh, inverse(c), c);
}

TEST(Dirac_energy_inverse, refuses_coordinates_that_are_not_finite)
{
  Mesh_view mesh = btorus(8);
  Inverse inverse(mesh);
  Points p = mesh.positions();
  p(0, 0) = std::numeric_limits<double>::quiet_NaN();
  mesh.set_positions(p);
  inverse.system.update_geometry();
  EXPECT_THROW(inverse.system.prepare_response(), CGP::Solver_error);
}

TEST(Dirac_energy_inverse, takes_the_factor_of_the_eigenvalue_problem_for_any_rho)
{
  const Mesh_view mesh = btorus(12);
  const auto X = CGP::dirac_energy(mesh, zero_potential(mesh));
  const Quaternion_matrix c = sources(mesh.size_of_vertices(), 3);
  for (const double amplitude : {0., 0.2}) {
    CGP::Dirac_system<> problem(mesh);
    CGP::Dirac_solution::Seconds seconds;
    CGP::Curvature_potential rho = zero_potential(mesh);
    rho.values = amplitude * random_numbers(mesh.size_of_vertices(), 5);
    problem.set_potential(rho, seconds);
    const CGP::Dirac_energy_inverse inverse(X, problem.areas(), problem.solver());
    expect_solutions(mesh, inverse(c), c);
  }
}

TEST(Dirac_energy_inverse, gives_up_on_values_that_are_not_finite)
{
  const Mesh_view mesh = btorus(8);
  const Inverse inverse(mesh);
  Quaternion_matrix c = sources(mesh.size_of_vertices(), 1);
  c(3, 0).y = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)inverse(c), CGP::Solver_error);
}
