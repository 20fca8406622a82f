// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Prescribed_boundary.h
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Conformal_geometry_processing/spin/solve_dirac_equation.h>

#include "spin/boundary_tools.h"
#include "support/dense.h"

namespace cgp_test::prescribed_positions_tests {

using Q = Quaternion<double>;
using Positions = CGP::internal::Prescribed_positions;

/// the normals of a curve whose boundary frames turn `turns` times about its tangents
Points twisted_normals(const Mesh_view& mesh, int turns)
{
  return at_boundary(mesh, [=](const Eigen::Vector3d& p, const auto& frame) -> Eigen::Vector3d {
    const double angle = turns * std::atan2(p.y(), p.x());
    return std::cos(angle) * frame.col(1) + std::sin(angle) * frame.col(2);
  });
}

Points boundary_of(const Mesh_view& mesh)
{
  return at_boundary(mesh, [](const Eigen::Vector3d& p, const auto&) { return p; });
}

/// what the spins and positions of a condition are refused with
std::string refusal(const Mesh_view& mesh, const Points& targets, const Points& normals)
{
  const CGP::internal::Dirac_system system(mesh);
  return refusal_of([&] {
    const Positions positions(mesh, Boundary_condition::positions(targets, normals),
                              system.matrix().shared_pattern(), system.solver(), "f");
  });
}

class Prescribed_positions : public testing::Test {
 protected:
  const Mesh_view mesh = perturbed(cap_from_disk(jittered_disk(5, .3), 1), .02);
  const Mesh_view curve = perturbed(mesh, .03, 7);
  const Points targets = boundary_of(curve), normals = twisted_normals(curve, 0);
  const Curvature_potential rho =
      potential_on_vertices(mesh, [](const Eigen::Vector3d& p) { return std::cos(3 * p.x()); });
  const CGP::internal::Boundary_frames frames = CGP::boundary_frames(mesh);
  CGP::internal::Dirac_system system{mesh, Boundary_condition::positions(targets, normals)};
};

TEST_F(Prescribed_positions, turn_and_stretch_the_boundary_into_the_curve)
{
  const CGP::internal::Dirac_solution s = CGP::solve_dirac_equation(system, rho);
  ASSERT_TRUE(s.converged);
  const auto wanted = CGP::boundary_frames(curve).frames;
  const std::vector<int>& loop = frames.loops[0];
  const std::size_t n = loop.size();
  for (std::size_t k = 0; k < n; ++k) {
    const int v = loop[k], next = loop[(k + 1) % n], last = loop[(k + n - 1) % n];
    const auto in = [&](const Mesh_view& m) { return (m.position(v) - m.position(last)).norm(); };
    const auto out = [&](const Mesh_view& m) { return (m.position(next) - m.position(v)).norm(); };
    const double ratio = (in(curve) / in(mesh)*out(mesh) + out(curve) / out(mesh) * in(mesh)) /
                         (in(mesh) + out(mesh));
    for (int c = 0; c < 3; ++c)
      EXPECT_LT((CGP::spin(s.lambda[v], frames.frames[k].col(c)) - ratio * wanted[k].col(c)).norm(),
                1e-13);
  }
}

TEST_F(Prescribed_positions, have_spins_of_least_energy_inside)
{
  const CGP::internal::Dirac_solution s = CGP::solve_dirac_equation(system, rho);
  const Quaternion_vector<double> image = system.matrix() * s.lambda;
  const std::vector<char> is_boundary = CGP::boundary_vertices(mesh);
  for (int v = 0; v < mesh.size_of_vertices(); ++v)
    if (!is_boundary[at(v)]) {
      EXPECT_LT(norm(image[v]), 1e-12);
    }
  EXPECT_LT(s.residual, 1e-13);
  const Eigen::VectorXd areas = CGP::vertex_areas(mesh);
  double energy = 0, square = 0;
  for (int v = 0; v < mesh.size_of_vertices(); ++v) {
    energy += dot(s.lambda[v], image[v]);
    square += areas[v] * squared_norm(s.lambda[v]);
  }
  EXPECT_NEAR(s.energy, energy / square, 1e-12);
  EXPECT_NEAR(s.eigenvalue * s.eigenvalue, s.energy, 1e-12);
}

TEST_F(Prescribed_positions, say_how_much_of_what_the_boundary_contributes_is_left_over)
{
  const CGP::internal::Dirac_solution s = CGP::solve_dirac_equation(system, rho);
  const std::vector<char> is_boundary = CGP::boundary_vertices(mesh);
  Quaternion_vector<double> known = s.lambda;
  for (int v = 0; v < mesh.size_of_vertices(); ++v)
    if (!is_boundary[at(v)]) known[v] = Q{};
  const Quaternion_vector<double> image = system.matrix() * s.lambda,
                                  contributed = system.matrix() * known;
  double left = 0, all = 0;
  for (int v = 0; v < mesh.size_of_vertices(); ++v) {
    left = std::hypot(left, is_boundary[at(v)] ? 0 : norm(image[v]));
    all = std::hypot(all, is_boundary[at(v)] ? 0 : norm(contributed[v]));
  }
  EXPECT_GT(s.residual, 0);
  EXPECT_NEAR(s.residual / (left / all), 1, 1e-9);
}

TEST_F(Prescribed_positions, keep_the_boundary_on_the_curve_and_fit_the_edges_inside)
{
  const Eigen::VectorXd w = CGP::cotan_weights(mesh);
  const Eigen::MatrixX3d edges = Eigen::MatrixX3d::Random(mesh.size_of_edges(), 3);
  const Points f = system.positions()->positions(edges);
  for (std::size_t k = 0; k < frames.vertices.size(); ++k)
    EXPECT_EQ(f.col(frames.vertices[k]), targets.col(int(k)));
  Points sum = Points::Zero(3, mesh.size_of_vertices());  // of the misfits at each vertex
  for (int k = 0; k < mesh.size_of_edges(); ++k) {
    const auto [i, j] = mesh.ends(k);
    const Eigen::Vector3d misfit = w[k] * (f.col(j) - f.col(i) - edges.row(k).transpose());
    sum.col(i) -= misfit;
    sum.col(j) += misfit;
  }
  const std::vector<char> is_boundary = CGP::boundary_vertices(mesh);
  for (int v = 0; v < mesh.size_of_vertices(); ++v)
    if (!is_boundary[at(v)]) {
      EXPECT_LT(sum.col(v).norm(), 1e-12);
    }
}

TEST(Prescribed_positions_of_a_curve, that_is_similar_give_the_similar_surface)
{
  const Mesh_view mesh = perturbed(cap_from_disk(jittered_disk(4, .3), 1), .02);
  const Eigen::Matrix3d R = Random(3).rotation();
  const auto similar =
      mapped(mesh, [&](const Eigen::Vector3d& p) -> Eigen::Vector3d { return 2 * (R * p); });
  CGP::internal::Dirac_system system(
      mesh, Boundary_condition::positions(boundary_of(similar), twisted_normals(similar, 0)));
  const CGP::internal::Dirac_solution s =
      CGP::solve_dirac_equation(system, constant_potential(mesh, 0));
  EXPECT_LT(s.eigenvalue, 1e-7);
  const Points f = system.positions()->positions(CGP::transformed_edges(mesh, s.lambda));
  EXPECT_LT((f - similar.positions()).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Prescribed_positions_of_a_curve, need_normals_that_turn_as_those_of_the_surface_do)
{
  const Mesh_view mesh = disk(6);
  const auto twisted = [&](int turns) {
    return refusal(mesh, boundary_of(mesh), twisted_normals(mesh, turns));
  };
  EXPECT_EQ(twisted(0), "");
  EXPECT_EQ(twisted(1),
            "the curve for the loop at vertex 91 is twisted by a full turn against it; no "
            "continuous spins do that");
  EXPECT_EQ(twisted(2), "");  // two full turns are none
  EXPECT_NE(twisted(-1), "");
}

TEST(Prescribed_positions_of_a_curve, name_the_loop_that_is_twisted)
{
  const Mesh_view mesh = annulus(1, 2, 40, 3);
  Points normals = twisted_normals(mesh, 0);
  normals.rightCols(40) = twisted_normals(mesh, 1).rightCols(40);
  EXPECT_NE(refusal(mesh, boundary_of(mesh), normals).find("loop at vertex 120 "),
            std::string::npos);
}

TEST(Prescribed_positions_of_a_curve, name_the_vertex_that_has_no_frame)
{
  const Mesh_view mesh = disk(2);
  const std::string message = "the curve folds back, or has its normal along it, at vertex 9";
  Points folded = boundary_of(mesh), normals = twisted_normals(mesh, 0);
  folded.col(1) = folded.col(3);
  EXPECT_EQ(refusal(mesh, folded, normals), message);
  normals.col(2) = boundary_of(mesh).col(3) - boundary_of(mesh).col(1);
  EXPECT_EQ(refusal(mesh, boundary_of(mesh), normals), message);
}

}  // namespace cgp_test::prescribed_positions_tests
