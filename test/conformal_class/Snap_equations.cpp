// Tests include/Conformal_geometry_processing/conformal_class/Snap_equations.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/conformal_class/Edge_scales.h>
#include <Conformal_geometry_processing/conformal_class/Snap_equations.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <gtest/gtest.h>

#include <Eigen/Core>

#include "support/decompositions.h"
#include "support/meshes.h"
#include "support/random.h"

namespace cgp_test::snap_equations_tests {

namespace CGP = Conformal_geometry_processing;

struct Step {
  Points df;
  Eigen::VectorXd du;
};

Step step_at(const Mesh_view& mesh, const Points& f, const Eigen::VectorXd& c)
{
  CGP::internal::Snap_equations equations(mesh, *CGP::vertex_graph(mesh));
  equations.factorize(f);
  Step step;
  equations.solve(c, step.df, step.du);
  return step;
}

TEST(Snap_equations, minimize_the_change_and_the_linear_residuals)
{
  // The dense normal equations of the same quadratic form, solved by least squares.
  const Mesh_view mesh = perturbed(icosphere(1), .2);
  const int n = mesh.size_of_vertices(), edges = mesh.size_of_edges();
  const Eigen::VectorXd c = .1 * random_numbers(edges, 3);
  const double root = std::sqrt(1e-6);
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(4 * edges + n, 4 * n);
  for (int k = 0; k < edges; ++k) {
    const auto [i, j] = mesh.ends(k);
    const Eigen::Vector3d e = mesh.position(j) - mesh.position(i);
    for (int d = 0; d < 3; ++d) {
      A(k, 4 * j + d) = e[d] / e.squaredNorm(), A(k, 4 * i + d) = -e[d] / e.squaredNorm();
      A(edges + 3 * k + d, 4 * j + d) = root / e.norm();
      A(edges + 3 * k + d, 4 * i + d) = -root / e.norm();
    }
    A(k, 4 * i + 3) = A(k, 4 * j + 3) = -.5;
  }
  for (int v = 0; v < n; ++v) A(4 * edges + v, 4 * v + 3) = .1 * root;
  Eigen::VectorXd b = Eigen::VectorXd::Zero(A.rows());
  b.head(edges) = -c;
  const Eigen::VectorXd d = least_squares(A, b);
  const Step step = step_at(mesh, mesh.positions(), c);
  for (int v = 0; v < n; ++v) {
    EXPECT_LT((step.df.col(v) - d.segment<3>(4 * v)).norm(), 1e-6);
    EXPECT_NEAR(step.du[v], d[4 * v + 3], 1e-6);
  }
}

TEST(Snap_equations, remove_the_residuals_to_second_order)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const CGP::internal::Edge_scales scales(mesh, CGP::vertex_graph(mesh));
  std::vector<double> left;
  for (const double amount : {1e-2, 1e-3}) {
    const Points f = perturbed(mesh, amount).positions();
    const Eigen::VectorXd u = scales.nearest_scales(f), c = scales.residuals(f, u);
    const Step step = step_at(mesh, f, c);
    left.push_back(scales.residuals(f + step.df, u + step.du).norm());
  }
  EXPECT_NEAR(std::log10(left[0] / left[1]), 2, .15);
}

}  // namespace cgp_test::snap_equations_tests
