// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/mesh/Surface_ref.h
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Conformal_geometry_processing/spin/solve_dirac_equation.h>

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "support/meshes.h"

namespace cgp_test::conformal_surface_archetype_tests {

namespace CGP = Conformal_geometry_processing;

namespace archetype {

/// no more than the concept `ConformalSurface` offers
class Surface {
 public:
  explicit Surface(const Mesh_view& mesh) : m_mesh(mesh) {}
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;

  const CGP::Points& positions() const { return m_mesh.positions(); }
  int size_of_faces() const { return m_mesh.size_of_faces(); }
  const std::vector<std::array<int, 2>>& ends() const { return m_mesh.ends(); }
  int size_of_sheets() const { return m_mesh.size_of_faces(); }
  CGP::Sheet sheet(int i) const { return m_mesh.sheet(i); }

 private:
  Mesh_view m_mesh;
};

std::vector<std::vector<int>> boundary_loops(const Surface&)
{
  return {};
}

}  // namespace archetype

TEST(Operators_of_an_archetype, need_no_more_than_the_concept_offers)
{
  const Mesh_view mesh = bumpy_sphere(1);
  const archetype::Surface surface(mesh);
  const auto rho =
      CGP::Curvature_potential::on_vertices(random_numbers(mesh.size_of_vertices(), 1));
  const auto X = CGP::dirac_energy(surface, rho), of_mesh = CGP::dirac_energy(mesh, rho);
  for (int i = 0; i < X.size(); ++i)
    for (int j = 0; j < X.size(); ++j) EXPECT_EQ(X.coefficient(i, j), of_mesh.coefficient(i, j));
  EXPECT_EQ(CGP::cotan_weights(surface), CGP::cotan_weights(mesh));
  EXPECT_EQ(CGP::mean_curvature(surface), CGP::mean_curvature(mesh));
}

TEST(Operators_of_an_archetype, solve_its_dirac_equation)
{
  const Mesh_view mesh = bumpy_sphere(1);
  const archetype::Surface surface(mesh);
  const auto rho =
      CGP::Curvature_potential::on_vertices(random_numbers(mesh.size_of_vertices(), 1));
  CGP::internal::Dirac_system system(surface), expected(mesh);
  const CGP::internal::Dirac_solution s = CGP::solve_dirac_equation(system, rho);
  EXPECT_TRUE(s.converged);
  EXPECT_TRUE(s.lambda == CGP::solve_dirac_equation(expected, rho).lambda);
  const Eigen::MatrixX3d edges = CGP::transformed_edges(surface, s.lambda);
  const CGP::Poisson_reconstruction poisson(surface, system.matrix().shared_pattern());
  EXPECT_TRUE(poisson.positions(edges).allFinite());
}

}  // namespace cgp_test::conformal_surface_archetype_tests
