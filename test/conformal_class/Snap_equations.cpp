// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/conformal_class/Conformal_class.h>
#include <Conformal_geometry_processing/conformal_class/Snap_equations.h>
#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <gtest/gtest.h>
#include <Eigen/Core>

#include "support/bounded_meshes.h"
#include "support/decompositions.h"
#include "support/meshes.h"
#include "support/moebius.h"
#include "support/random.h"
#include "support/tori.h"

#include <cmath>
#include <vector>

namespace cgp_test::snap_equations_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::internal::Rim_directions;

/// tangents, normals, binormals, and a direction between them
const std::vector<Eigen::Vector3d>& kinds()
{
  static const std::vector<Eigen::Vector3d> list = {
      Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ(), {1, -2, 3}};
  return list;
}

Mesh_view surface()
{
  return perturbed(cap_from_disk(disk(6), pi / 3), .01);
}

Points moved(const Mesh_view& mesh, double by)
{
  return mesh.positions() +
         by * random_numbers(3 * mesh.size_of_vertices(), 7).reshaped(3, mesh.size_of_vertices());
}

TEST(Rim_directions, has_two_residuals_for_each_edge_that_motions_and_scalings_leave)
{
  const Mesh_view mesh = surface();
  EXPECT_EQ(Rim_directions().size_of_rows(), 0);
  for (const Eigen::Vector3d& kind : kinds()) {
    const Rim_directions rim(mesh, kind);
    EXPECT_EQ(rim.size_of_rows(), 2 * 36);
    const Points f = (3 * mesh.positions()).colwise() + Eigen::Vector3d(1, 2, 3);
    EXPECT_LT(rim.residuals(f).lpNorm<Eigen::Infinity>(), 1e-13);
    EXPECT_GT(rim.residuals(moved(mesh, .01)).lpNorm<Eigen::Infinity>(), 1e-3);
  }
}

TEST(Rim_directions, are_angles)
{
  const Mesh_view mesh = surface();
  const double angle = 1e-4;
  const Eigen::Matrix3d R =
      Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 1, 2).normalized()).toRotationMatrix();
  const Eigen::VectorXd r = Rim_directions(mesh, {0, 0, 1}).residuals(R * mesh.positions());
  EXPECT_LT(r.lpNorm<Eigen::Infinity>(), angle);
  EXPECT_GT(r.lpNorm<Eigen::Infinity>(), .5 * angle);
}

TEST(Rim_directions, derivative_is_that_of_the_residuals)
{
  const Mesh_view mesh = surface();
  for (const Eigen::Vector3d& kind : kinds()) {
    const Rim_directions rim(mesh, kind);
    const Points v = moved(mesh, 1) - mesh.positions();
    const double t = 1e-6;
    const Eigen::VectorXd difference =
        (rim.residuals(mesh.positions() + t * v) - rim.residuals(mesh.positions() - t * v)) /
        (2 * t);
    Eigen::VectorXd derivative = Eigen::VectorXd::Zero(rim.size_of_rows());
    Eigen::Index k = 0;
    for (const Rim_directions::Row& row : rim.derivative(mesh.positions())) {
      for (int c = 0; c < 3; ++c)
        derivative[k] += row.gradients.col(c).dot(v.col(row.vertices[at(c)]));
      ++k;
    }
    EXPECT_EQ(k, rim.size_of_rows());
    EXPECT_LT((derivative - difference).norm(), 1e-7 * difference.norm());
  }
}

TEST(Rim_directions, are_kept_on_the_way_to_the_conformal_class)
{
  const Mesh_view mesh = surface();
  const Points before = moved(mesh, .003);
  for (const Eigen::Vector3d& kind : {kinds()[0], kinds()[2], kinds()[3]}) {
    SCOPED_TRACE(kind.transpose());
    CGP::internal::Conformal_class conformal_class(mesh);
    const Rim_directions rim({before, mesh.corners()}, kind);
    conformal_class.keep(rim);
    Points f = before;
    const CGP::internal::Snap_report report = conformal_class.snap(f);
    EXPECT_TRUE(report.converged);
    EXPECT_GT(report.initial_residual, 1e-3);
    EXPECT_LT(CGP::length_cross_ratio_change(mesh, f).max, 1e-10);
    EXPECT_LT(rim.residuals(f).lpNorm<Eigen::Infinity>(), 1e-10);
  }
}

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
  const CGP::internal::Edge_scales scales(mesh);
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
