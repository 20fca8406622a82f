// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Dirac_system.h
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>

#include "spin/boundary_tools.h"
#include "support/dense.h"
#include "support/meshes.h"

namespace cgp_test::dirac_system_boundary_tests {

/// What a condition at the boundary makes of the space of spins.

/// the positions and the normals of the boundary that a mesh has
Boundary_condition kept_positions(const Mesh_view& mesh)
{
  return Boundary_condition::positions(
      at_boundary(mesh, [](const Eigen::Vector3d& p, const auto&) { return p; }),
      at_boundary(mesh,
                  [](const auto&, const auto& frame) -> Eigen::Vector3d { return frame.col(1); }));
}

TEST(Dirac_system_boundary, of_a_closed_surface_has_no_condition)
{
  const Mesh_view mesh = radially_perturbed(icosphere(1), .1);
  CGP::internal::Dirac_system system(mesh);
  EXPECT_TRUE(system.is_closed());
  EXPECT_TRUE(system.is_self_adjoint());
  EXPECT_EQ(system.directions(), nullptr);
  EXPECT_EQ(system.positions(), nullptr);
  EXPECT_EQ(system.coefficients(), CGP::internal::Coefficients::quaternions);
  const Quaternion_matrix v = random_quaternions(mesh.size_of_vertices(), 1);
  EXPECT_TRUE(system.projected(v) == v);
}

TEST(Dirac_system_boundary, has_what_belongs_to_the_condition)
{
  const Mesh_view mesh = disk(3);
  CGP::internal::Dirac_system free(mesh);
  EXPECT_FALSE(free.is_closed());
  EXPECT_FALSE(free.is_self_adjoint());
  EXPECT_FALSE(free.directions() || free.positions());
  CGP::internal::Dirac_system bound(mesh, Boundary_condition::binormals());
  EXPECT_TRUE(bound.directions() && !bound.positions());
  EXPECT_TRUE(bound.is_self_adjoint());
  EXPECT_EQ(bound.coefficients(), CGP::internal::Coefficients::reals);
  CGP::internal::Dirac_system tangents(mesh, Boundary_condition::tangents());
  EXPECT_FALSE(tangents.is_self_adjoint());
  EXPECT_EQ(tangents.coefficients(), CGP::internal::Coefficients::reals);
  CGP::internal::Dirac_system fixed(mesh, kept_positions(mesh));
  EXPECT_TRUE(fixed.positions() && !fixed.directions());
  EXPECT_EQ(fixed.coefficients(), CGP::internal::Coefficients::quaternions);
}

TEST(Dirac_system_boundary, refuses_conditions_that_do_not_fit)
{
  const Mesh_view mesh = disk(3), sphere = icosphere(1);
  EXPECT_THROW(CGP::internal::Dirac_system(sphere, Boundary_condition::binormals()),
               CGP::Precondition_error);
  EXPECT_THROW(CGP::internal::Dirac_system(mesh, Boundary_condition::tangents(Points::Ones(3, 5))),
               CGP::Precondition_error);
  EXPECT_NE(refusal_of([&] {
              Boundary_condition twisted = kept_positions(mesh);
              twisted.normals = at_boundary(mesh, [](const Eigen::Vector3d& p, const auto& frame) {
                return Eigen::Vector3d(p.x() * frame.col(1) + p.y() * frame.col(2));
              });
              CGP::internal::Dirac_system(mesh, twisted);
            }).find("twisted by a full turn"),
            std::string::npos);
}

TEST(Dirac_system_boundary, solves_in_the_space_of_its_directions)
{
  const Mesh_view mesh = perturbed(cap_from_disk(jittered_disk(4, .3), 1), .04);
  CGP::internal::Dirac_system system(mesh, Boundary_condition::tangents());
  CGP::internal::Dirac_evidence::Seconds seconds;
  system.set_potential(constant_potential(mesh, .7), seconds);
  const Quaternion_matrix b = random_quaternions(mesh.size_of_vertices(), 1), x = system.solve(b);
  EXPECT_LT(greatest_difference(system.projected(x).col(0), x.col(0)), 1e-12);
  Quaternion_vector<double> image = system.matrix() * x.col(0);
  for (Eigen::Index v = 0; v < image.size(); ++v)
    image[v] += (system.shift() * system.areas()[v]) * x(v, 0);
  const auto& basis = system.directions()->basis();
  EXPECT_LT((basis.coordinates(Quaternion_matrix(image)) - basis.coordinates(b)).norm(), 1e-10);
}

TEST(Dirac_system_boundary, scales_spins_with_prescribed_directions_to_a_mean_square_of_one)
{
  const Mesh_view mesh = scaled(disk(4), 2);
  const CGP::internal::Dirac_system system(mesh, Boundary_condition::binormals());
  const Eigen::VectorXd areas = CGP::vertex_areas(mesh);
  const Quaternion_vector<double> v = random_quaternions(mesh.size_of_vertices(), 5),
                                  u = system.normalized(v);
  double square = 0;
  for (Eigen::Index i = 0; i < areas.size(); ++i) {
    square += areas[i] / areas.sum() * squared_norm(u[i]);
    EXPECT_LT(norm(norm(v[0]) * u[i] - norm(u[0]) * v[i]), 1e-13);
  }
  EXPECT_NEAR(square, 1, 1e-12);
}

}  // namespace cgp_test::dirac_system_boundary_tests
