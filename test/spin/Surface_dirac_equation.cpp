// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Boundary_condition.h
// Tests include/Conformal_geometry_processing/spin/Surface_dirac_equation.h
#include <limits>

#include "spin/boundary_tools.h"
#include "support/meshes.h"

namespace {

using namespace cgp_test;
using Kind = Boundary_condition::Kind;

/// with which a condition on `disk(2)`, whose boundary has 12 vertices, is refused
std::string refusal(const Boundary_condition& condition, const Mesh_view& mesh = disk(2))
{
  return refusal_of([&] { CGP::require_condition(mesh, condition, "f"); });
}

Points constant(int count, double x = 1)
{
  return Eigen::Vector3d(x, 0, 0).replicate(1, count);
}

Points with_column(Points p, int k, const Eigen::Vector3d& v)
{
  p.col(k) = v;
  return p;
}

const double infinity = std::numeric_limits<double>::infinity();

/// the solution of an equation that lives as long as it takes
CGP::Dirac_solution solved(const Mesh_view& mesh, const Boundary_condition& condition,
                           const Curvature_potential& rho, const CGP::Dirac_options& options = {})
{
  return CGP::Surface_dirac_equation<>(mesh, condition, "f").solve(rho, options);
}

}  // namespace

TEST(Boundary_condition, of_each_kind_has_what_it_needs)
{
  EXPECT_EQ(Boundary_condition().kind, Kind::free);
  EXPECT_EQ(Boundary_condition::free().kind, Kind::free);
  const auto tangents = Boundary_condition::tangents(constant(3));
  EXPECT_EQ(tangents.kind, Kind::directions);
  EXPECT_EQ(tangents.direction, Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(tangents.targets, constant(3));
  EXPECT_EQ(Boundary_condition::binormals().direction, Eigen::Vector3d(0, 0, 1));
  EXPECT_EQ(Boundary_condition::binormals().targets.cols(), 0);
  const auto positions = Boundary_condition::positions(constant(3), constant(3, 2));
  EXPECT_EQ(positions.kind, Kind::positions);
  EXPECT_EQ(positions.targets, constant(3));
  EXPECT_EQ(positions.normals, constant(3, 2));
}

TEST(Boundary_condition, is_self_adjoint_if_the_direction_is_orthogonal_to_the_tangent)
{
  EXPECT_TRUE(Boundary_condition::binormals().is_self_adjoint());
  EXPECT_TRUE(Boundary_condition::directions({0, 1, -2}).is_self_adjoint());
  EXPECT_FALSE(Boundary_condition::tangents().is_self_adjoint());
  EXPECT_FALSE(Boundary_condition::directions({.1, 0, 1}).is_self_adjoint());
  EXPECT_FALSE(Boundary_condition::free().is_self_adjoint());
}

TEST(Require_condition, takes_what_fits)
{
  EXPECT_EQ(refusal(Boundary_condition::free()), "");
  EXPECT_EQ(refusal(Boundary_condition::free(), icosahedron()), "");
  EXPECT_EQ(refusal(Boundary_condition::tangents()), "");
  EXPECT_EQ(refusal(Boundary_condition::tangents(constant(12, 1e-300))), "");
  EXPECT_EQ(refusal(Boundary_condition::directions({0, 100, 1}, constant(12, 1e200))), "");
  EXPECT_EQ(refusal(Boundary_condition::positions(constant(12, 0), constant(12))), "");
}

TEST(Require_condition, refuses_to_prescribe_what_is_not_there)
{
  const std::string message = "the surface is closed; no boundary can be prescribed";
  EXPECT_EQ(refusal(Boundary_condition::binormals(), icosahedron()), message);
  EXPECT_EQ(refusal(Boundary_condition::positions(constant(0), constant(0)), icosahedron()),
            message);
}

TEST(Require_condition, refuses_other_numbers_of_targets)
{
  EXPECT_EQ(refusal(Boundary_condition::tangents(constant(11))),
            "11 directions, one per boundary vertex is needed: 12");
  EXPECT_EQ(refusal(Boundary_condition::positions(constant(13), constant(12))),
            "13 positions, one per boundary vertex is needed: 12");
  EXPECT_EQ(refusal(Boundary_condition::positions(constant(0), constant(12))),
            "0 positions, one per boundary vertex is needed: 12");
  EXPECT_EQ(refusal(Boundary_condition::positions(constant(12), constant(0))),
            "0 normals, one per boundary vertex is needed: 12");
}

TEST(Require_condition, refuses_directions_that_are_none)
{
  Points two = with_column(with_column(constant(12), 4, {0, 0, 0}), 5, {infinity, 0, 0});
  EXPECT_EQ(
      refusal(Boundary_condition::tangents(two)),
      "2 directions zero or not finite, the first is vertex 11; finite vectors that are not zero "
      "are needed");
  const Points one = with_column(constant(12), 11, {0, 0, std::nan("")});
  EXPECT_EQ(
      refusal(Boundary_condition::positions(constant(12), one)),
      "1 normal zero or not finite, the first is vertex 18; finite vectors that are not zero are "
      "needed");
  EXPECT_EQ(refusal(Boundary_condition::positions(one, constant(12))),
            "1 position not finite, the first is vertex 18; finite coordinates are needed");
}

TEST(Require_condition, refuses_to_prescribe_the_normal)
{
  for (const Eigen::Vector3d& d : {Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(1e-4, 1, 1e-4),
                                   Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, infinity, 0)})
    EXPECT_EQ(refusal(Boundary_condition::directions(d)),
              "only tangents, binormals and directions between them and the normal can be "
              "prescribed; that of the normal is not elliptic");
}

TEST(Require_condition, refuses_a_boundary_that_folds_back)
{
  Points p = disk(2).positions();
  p.col(8) = p.col(10);  // the tangent at vertex 9 vanishes
  const Mesh_view folded(p, disk(2).corners());
  const std::string message =
      "1 boundary vertex without tangent or normal, the first is vertex 9; the boundary must not "
      "fold back";
  EXPECT_EQ(refusal(Boundary_condition::tangents(), folded), message);
  EXPECT_EQ(refusal(Boundary_condition::positions(constant(12), constant(12)), folded), message);
  EXPECT_EQ(refusal(Boundary_condition::free(), folded), "");
}

TEST(Surface_dirac_equation, of_a_closed_surface_is_that_of_closed_surfaces)
{
  const Mesh_view mesh = radially_perturbed(icosphere(1), .1);
  const auto rho = potential_on_vertices(mesh, [](const auto& p) { return p.x() * p.y(); });
  CGP::Surface_dirac_equation<> equation(mesh, {}, "f");
  EXPECT_TRUE(equation.is_closed());
  EXPECT_TRUE(equation.is_self_adjoint());
  EXPECT_EQ(equation.directions(), nullptr);
  EXPECT_EQ(equation.reduced(), nullptr);
  EXPECT_EQ(equation.positions(), nullptr);
  EXPECT_EQ(equation.solve(rho).lambda, CGP::Dirac_equation<>(mesh).solve(rho).lambda);
}

TEST(Surface_dirac_equation, solves_with_what_belongs_to_the_condition)
{
  const Mesh_view mesh = disk(3);
  CGP::Surface_dirac_equation<> free(mesh, {}, "f");
  EXPECT_FALSE(free.is_closed());
  EXPECT_FALSE(free.directions() || free.reduced() || free.positions());
  CGP::Surface_dirac_equation<> bound(mesh, Boundary_condition::binormals(), "f");
  EXPECT_TRUE(bound.directions() && bound.reduced() && !bound.positions());
  EXPECT_TRUE(bound.is_self_adjoint());
  CGP::Surface_dirac_equation<> tangents(mesh, Boundary_condition::tangents(), "f");
  EXPECT_FALSE(tangents.is_self_adjoint());
  const Points kept = at_boundary(mesh, [](const Eigen::Vector3d& p, const auto&) { return p; });
  const Points up = Eigen::Vector3d(0, 0, 1).replicate(1, kept.cols());
  CGP::Surface_dirac_equation<> fixed(mesh, Boundary_condition::positions(kept, up), "f");
  EXPECT_TRUE(fixed.positions() && !fixed.directions());
}

TEST(Surface_dirac_equation, with_rho_zero_and_nothing_to_turn_is_solved_by_one)
{
  const Mesh_view mesh = perturbed(cap_from_disk(jittered_disk(4, .3), 1), .02);
  const Points kept = at_boundary(mesh, [](const Eigen::Vector3d& p, const auto&) { return p; });
  const Points normals =
      at_boundary(mesh, [](const auto&, const auto& frame) { return frame.col(1); });
  for (const Boundary_condition& condition :
       {Boundary_condition::free(), Boundary_condition::tangents(), Boundary_condition::binormals(),
        Boundary_condition::directions({1, 2, 3}), Boundary_condition::positions(kept, normals)}) {
    const CGP::Dirac_solution s = solved(mesh, condition, constant_potential(mesh, 0));
    EXPECT_TRUE(s.converged);
    EXPECT_NEAR(s.eigenvalue, 0, 1e-7);
    EXPECT_NEAR(s.overlap, 1, 1e-12);
    for (int v = 0; v < mesh.size_of_vertices(); ++v)
      EXPECT_LT(norm(s.lambda[v] - Quaternion<double>{1, 0, 0, 0}), 1e-7);
  }
}

TEST(Surface_dirac_equation, follows_the_mesh)
{
  const Mesh_view before = cap_from_disk(disk(4), 1), after = cap_from_disk(disk(4), 1.4);
  const auto rho = potential_on_vertices(before, [](const auto& p) { return p.x(); });
  for (const Boundary_condition& condition :
       {Boundary_condition::free(),
        Boundary_condition::tangents(
            at_boundary(after, [](const auto&, const auto& frame) { return frame.col(0); }))}) {
    Mesh_view mesh = before;
    CGP::Surface_dirac_equation<> equation(mesh, condition, "f");
    (void)equation.solve(rho);
    mesh.set_positions(after.positions());
    equation.update_geometry();
    const CGP::Dirac_solution s = equation.solve(rho), expected = solved(after, condition, rho);
    EXPECT_TRUE(expected.converged);
    for (int v = 0; v < mesh.size_of_vertices(); ++v)
      EXPECT_LT(norm(s.lambda[v] - expected.lambda[v]), 1e-8);
  }
}

TEST(Surface_dirac_equation, refuses_the_generalized_problem_with_a_boundary)
{
  CGP::Dirac_options options;
  options.problem = CGP::Eigenproblem::generalized;
  const Mesh_view mesh = disk(2);
  const auto rho = potential_on_faces(mesh, [](const auto& p) { return p.x(); });
  EXPECT_EQ(refusal_of([&] { (void)solved(mesh, {}, rho, options); }),
            "the generalized problem is for closed surfaces only");
}
