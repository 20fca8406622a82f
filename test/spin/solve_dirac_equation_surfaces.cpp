// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/solve_dirac_equation.h
#include <Conformal_geometry_processing/mesh/Delaunay_view.h>

#include "spin/boundary_cases.h"
#include "spin/dense_spectrum.h"
#include "spin/solved.h"
#include "support/dense.h"
#include "support/meshes.h"
#include "support/thin_faces.h"

namespace cgp_test::solve_dirac_equation_surfaces_tests {

/// The same laws for meshes and for their intrinsic Delaunay triangulations.

template <class Surface>
class Solve_dirac_equation_on : public testing::Test {
 protected:
  static std::vector<Curvature_potential> constants(const Surface& surface, double c)
  {
    return {
        Curvature_potential::on_vertices(Eigen::VectorXd::Constant(surface.size_of_vertices(), c)),
        Curvature_potential::on_faces(Eigen::VectorXd::Constant(surface.size_of_faces(), c))};
  }
};

using Surfaces = testing::Types<Mesh_view, CGP::Delaunay_view>;
TYPED_TEST_SUITE(Solve_dirac_equation_on, Surfaces);

double distance_to_one(const Quaternion_vector<double>& lambda)
{
  return greatest_difference(lambda,
                             Quaternion_vector<double>::Constant(lambda.size(), {1, 0, 0, 0}));
}

void expect_agreement(const Mesh_view& mesh, const Curvature_potential& rho,
                      const Boundary_condition& condition = {})
{
  const CGP::Delaunay_view view(mesh);
  ASSERT_EQ(view.number_of_flips(), 0);
  CGP::Dirac_options options;
  options.tolerance = 1e-12;
  const CGP::internal::Dirac_solution s = solved(mesh, rho, options, condition),
                                      of_view = solved(view, rho, options, condition);
  EXPECT_TRUE(s.converged && of_view.converged);
  EXPECT_LT(greatest_difference(s.lambda, of_view.lambda), 1e-10);
  EXPECT_NEAR(s.eigenvalue, of_view.eigenvalue, 1e-10);
  EXPECT_NEAR(s.energy, of_view.energy, 1e-10);
  EXPECT_NEAR(s.overlap, of_view.overlap, 1e-10);
}

TYPED_TEST(Solve_dirac_equation_on, any_surface_with_constant_rho_finds_the_identity)
{
  for (const TypeParam& surface :
       {TypeParam(radially_perturbed(icosphere(2), 0.05)), TypeParam(perturbed(btorus(12), .04))}) {
    CGP::internal::Dirac_system system(surface);
    for (const double c : {0., 0.1, -0.5, 1., 3., -20.})
      for (const Curvature_potential& rho : this->constants(surface, c)) {
        const CGP::internal::Dirac_solution s = CGP::solve_dirac_equation(system, rho);
        EXPECT_TRUE(s.converged) << c;
        EXPECT_LT(distance_to_one(s.lambda), 1e-12) << c;
        EXPECT_NEAR(s.eigenvalue, -c, 1e-12) << c;
      }
  }
}

TYPED_TEST(Solve_dirac_equation_on, any_surface_with_weak_rho_finds_the_smallest_of_rho_and_gamma)
{
  const Mesh_view mesh = perturbed(icosphere(1), .05);
  const TypeParam surface(mesh);
  CGP::internal::Dirac_system system(surface);
  for (const auto& rho :
       {Curvature_potential::on_faces(0.5 * rho_of_section_3_on_faces(mesh)),
        Curvature_potential::on_vertices(0.5 * rho_of_section_3_on_vertices(mesh))}) {
    const CGP::internal::Dirac_solution s = CGP::solve_dirac_equation(system, rho);
    EXPECT_TRUE(s.converged);
    const Curvature_potential moved{rho.on, (rho.values.array() + s.eigenvalue).matrix()};
    EXPECT_NEAR(s.energy, dense_eigenvalues(surface, moved)[0], 1e-12);
  }
}

TYPED_TEST(Solve_dirac_equation_on, any_bounded_surface_with_nothing_to_turn_finds_the_identity)
{
  const Mesh_view mesh = perturbed(cap_from_disk(jittered_disk(4, .3), 1), .02);
  const TypeParam surface(mesh);
  for (const Boundary_condition& condition :
       {Boundary_condition::free(), Boundary_condition::tangents(), Boundary_condition::binormals(),
        Boundary_condition::directions({1, 2, 3})}) {
    const CGP::internal::Dirac_solution s =
        solved(surface, constant_potential(mesh, 0), {}, condition);
    EXPECT_TRUE(s.converged);
    EXPECT_NEAR(s.eigenvalue, 0, 1e-7);
    EXPECT_LT(distance_to_one(s.lambda), 1e-7);
  }
}

// With rho = -0.5 the shift makes X that of rho = 0, so that flat triangles, whose edges close up
// only to the heights that mollification gives them, do not matter.
TEST(Solve_dirac_equation_surfaces, finds_the_identity_on_faces_of_area_zero)
{
  const Mesh_view mesh = spoilt(icosphere(2));
  for (const double share : {1e-4, 1e-6, 1e-8}) {
    const CGP::Delaunay_view surface(mesh, share);
    const CGP::internal::Dirac_solution flat = solved(surface, constant_potential(mesh, 0)),
                                        s = solved(surface, constant_potential(mesh, -0.5));
    EXPECT_TRUE(flat.converged && s.converged);
    EXPECT_LT(distance_to_one(flat.lambda), 1e-12);
    EXPECT_LT(distance_to_one(s.lambda), 1e-12);
    EXPECT_NEAR(s.eigenvalue, 0.5, 1e-12);
  }
}

TEST(Solve_dirac_equation_surfaces, finds_the_same_on_both_views_of_a_Delaunay_mesh)
{
  const Mesh_view mesh = icosphere(2);
  for (const double strength : {1., 3.}) {
    expect_agreement(
        mesh, Curvature_potential::on_vertices(strength * rho_of_section_3_on_vertices(mesh)));
    expect_agreement(mesh,
                     Curvature_potential::on_faces(strength * rho_of_section_3_on_faces(mesh)));
  }
}

TEST(Solve_dirac_equation_surfaces, finds_the_same_on_both_views_with_every_condition)
{
  const Mesh_view mesh = moved_disk(6);
  const Points points = at_boundary(mesh, [](const Eigen::Vector3d& p, const auto&) { return p; });
  const Points normals = at_boundary(
      mesh, [](const auto&, const auto& frame) -> Eigen::Vector3d { return frame.col(1); });
  const auto rho = potential_on_vertices(
      mesh, [](const Eigen::Vector3d& p) { return .5 * std::cos(3 * p.x() + 1); });
  for (const Boundary_condition& condition :
       {Boundary_condition::free(), Boundary_condition::tangents(), Boundary_condition::binormals(),
        Boundary_condition::tangents(enneper_directions(mesh, {1, 0, 0})),
        Boundary_condition::positions(points, normals)})
    expect_agreement(mesh, rho, condition);
}

}  // namespace cgp_test::solve_dirac_equation_surfaces_tests
