// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/conformal_class/Class_equations.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/direct/Supernodal_cholesky.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <gtest/gtest.h>
#include <Eigen/Core>

#include "support/bounded_meshes.h"
#include "support/meshes.h"
#include "support/moebius.h"
#include "support/random.h"
#include "support/spheres.h"
#include "support/tori.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace cgp_test::class_equations_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::internal::Class_form;
using CGP::internal::Edge_scales;

TEST(Edge_scales, of_an_inversion_are_known_in_closed_form)
{
  // |F(p) - F(q)| = |p - q| / (|p - c| |q - c|) up to a constant factor: u = -2 log |p - c|.
  const Eigen::Vector3d c(.3, .1, 2.5);
  for (const Mesh_view& mesh : {bumpy_sphere(2), torus(2, 1, 20, 10), disk(4)}) {
    const Edge_scales scales(mesh);
    const Points f = inverted(mesh, c).positions();
    const Eigen::VectorXd u = scales.nearest_scales(f);
    for (int v = 1; v < mesh.size_of_vertices(); ++v)
      EXPECT_NEAR(u[v] - u[0],
                  2 * std::log((mesh.position(0) - c).norm() / (mesh.position(v) - c).norm()),
                  1e-11);
    EXPECT_LT(scales.residuals(f, u).lpNorm<Eigen::Infinity>(), 1e-12);
  }
}

TEST(Edge_scales, are_those_of_least_squares)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const Edge_scales scales(mesh);
  const Points f = perturbed(mesh, .1).positions();
  const Eigen::VectorXd c = scales.residuals(f, scales.nearest_scales(f));
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(mesh.size_of_vertices());
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    for (const int v : mesh.ends(k)) gradient[v] += c[k];
  EXPECT_GT(c.norm(), .1);
  EXPECT_LT(gradient.norm(), 1e-12);
}

TEST(Edge_scales, are_as_exact_as_rounded_coordinates)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const Edge_scales scales(mesh);
  const Eigen::VectorXd u = Eigen::VectorXd::Zero(mesh.size_of_vertices());
  for (const double distance : {1., 1e3, 1e6}) {
    const Eigen::Vector3d o = distance * Eigen::Vector3d(1, -2, 3);
    const Points away = mesh.positions().colwise() + o, back = away.colwise() - o;
    const double change = (scales.residuals(back, u)).lpNorm<Eigen::Infinity>();
    EXPECT_LT(change, scales.rounding(away));
    EXPECT_GT(change, .02 * scales.rounding(away));
  }
}

TEST(Edge_scales, of_a_surface_without_extent_do_not_exist)
{
  const Mesh_view mesh = icosphere(1);
  const Edge_scales scales(mesh);
  EXPECT_THROW(scales.nearest_scales(Points::Zero(3, mesh.size_of_vertices())), CGP::Solver_error);
}

CGP::Sparse_pattern complete_pattern(int n)
{
  CGP::Sparse_pattern pattern;
  pattern.offsets = {0};
  for (int j = 0; j < n; ++j) {
    for (int i = j; i < n; ++i) pattern.indices.push_back(i);
    pattern.offsets.push_back(static_cast<int>(pattern.indices.size()));
  }
  return pattern;
}

// d^T A d is |J d|^2 w, by differences of the residuals, and what was added beside it; b^T d is -w
// <c, J d>.
TEST(Class_form, is_the_square_of_the_change_of_the_residuals)
{
  const Mesh_view mesh = bumpy_sphere(2);
  std::vector<int> all(at(mesh.size_of_vertices()));
  std::iota(all.begin(), all.end(), 0);
  std::vector<int> upper = all;
  int count = 0;  // of the vertices above, which are free
  for (int& v : upper) v = mesh.position(v).z() > 0 ? count++ : -1;
  for (const std::vector<int>& free : {all, upper}) {
    const int n = 1 + *std::max_element(free.begin(), free.end());
    const Edge_scales scales(mesh, free);
    Class_form form(scales, complete_pattern(n));
    form.linearize(mesh.positions());
    form.add_equations(3);
    form.add_of_scale(1, 5);
    form.add_of_positions(2, 0, 7);
    const Eigen::VectorXd d = random_numbers(4 * n, 5);
    const double t = 1e-6;
    const auto residuals_at = [&](double way) {
      Points f = mesh.positions();
      Eigen::VectorXd u(n);
      for (int v = 0; v < mesh.size_of_vertices(); ++v)
        if (const int k = free[at(v)]; k >= 0)
          f.col(v) += way * d.segment<3>(4 * k), u[k] = way * d[4 * k + 3];
      return scales.residuals(f, u);
    };
    const Eigen::VectorXd Jd = (residuals_at(t) - residuals_at(-t)) / (2 * t);
    const double extra = 5 * d[7] * d[7] + 14 * d.segment<3>(8).dot(d.segment<3>(0));
    EXPECT_NEAR(d.dot(form.matrix() * d), 3 * Jd.squaredNorm() + extra, 1e-6 * Jd.squaredNorm());
    const Eigen::VectorXd c = random_numbers(static_cast<int>(Jd.size()), 6);
    EXPECT_NEAR(form.right_hand_side(c).col(0).dot(d), -3 * c.dot(Jd), 1e-6 * Jd.squaredNorm());
  }
}

// L has the constants in its kernel, and rounding decides the sign of the last pivot.
TEST(Factorize_definite, bears_what_rounding_makes_indefinite_and_nothing_worse)
{
  const Mesh_view mesh = icosphere(2);
  CGP::Hermitian_sparse_matrix<double> L(CGP::vertex_graph(mesh));
  CGP::assemble_cotan_laplacian(mesh, CGP::cotan_weights(mesh), L);
  const int last = L.pattern().offsets[at(mesh.size_of_vertices() - 1)];
  L.value(last) *= 1 - 1e-13;
  CGP::Supernodal_cholesky<double> solver;
  solver.analyze(L.pattern());
  ASSERT_NE(solver.factorize(L, {}), CGP::Solver_status::success);
  EXPECT_EQ(CGP::internal::factorize_definite(solver, L, 1), CGP::Solver_status::success);
  CGP::Block<double> b = CGP::Block<double>::Zero(L.size(), 1), x;
  b(0, 0) = 1;
  b(1, 0) = -1;
  ASSERT_EQ(solver.solve(b, x), CGP::Solver_status::success);
  EXPECT_LT((L * Eigen::VectorXd(x.col(0)) - b.col(0)).norm(), 1e-6);
  L.value(last) = -1;
  EXPECT_EQ(CGP::internal::factorize_definite(solver, L, 1e-2),
            CGP::Solver_status::not_positive_definite);
}

}  // namespace cgp_test::class_equations_tests
