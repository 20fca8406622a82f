// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests dirac_spectrum.h, dirac_sphere.h
#include "dirac_spectrum_checks.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <vector>

#include "support/bounded_meshes.h"
#include "support/polyhedra.h"

namespace cgp_test::dirac_spectrum_tests {

namespace params = CGP::parameters;
using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

/// a tetrahedron beside the surface, which is removed and leaves its slots behind
Surface with_garbage(const Mesh_view& surface)
{
  Surface mesh;
  add_to_cgal_mesh(tetrahedron(), mesh);
  const std::vector<Surface::Face_index> first(faces(mesh).begin(), faces(mesh).end());
  add_to_cgal_mesh(surface, mesh);
  for (const auto f : first) CGAL::Euler::remove_face(halfedge(f, mesh), mesh);
  return mesh;
}

TEST(Dirac_spectrum_of_a_Surface_mesh, is_that_of_its_view)
{
  expect_spectrum_of_the_view(to_cgal_mesh<Surface>(bumpy_sphere(2)));
}

TEST(Dirac_spectrum_of_a_Surface_mesh, ignores_removed_elements)
{
  const Surface mesh = with_garbage(bumpy_sphere(2));
  ASSERT_TRUE(mesh.has_garbage());
  ASSERT_EQ(current_view(mesh).size_of_faces(), bumpy_sphere(2).size_of_faces());
  expect_spectrum_of_the_view(mesh);
}

TEST(Dirac_spectrum_of_a_Surface_mesh, knows_rho_and_a_shift)
{
  Surface mesh = to_cgal_mesh<Surface>(icosphere(2));
  const auto rho = mesh.add_property_map<Surface::Vertex_index, double>("v:rho", 0.5).first;
  const CGP::internal::Dirac_spectrum s = CGP::dirac_spectrum(
      mesh, 3, params::curvature_potential_map(rho).spectral_shift(1.6).tolerance(1e-10));
  ASSERT_TRUE(s.converged);
  EXPECT_LT(s.residuals.maxCoeff(), 1e-9);
  for (double value : s.eigenvalues) EXPECT_NEAR(value, 2 - 0.5, 0.1);
}

TEST(Dirac_spectrum_of_a_Surface_mesh, keeps_the_binormals_of_a_boundary)
{
  const Surface mesh = to_cgal_mesh<Surface>(disk(8));
  const CGP::internal::Dirac_spectrum by_default =
                                          CGP::dirac_spectrum(mesh, 3, params::spectral_shift(2.1)),
                                      asked = CGP::dirac_spectrum(
                                          mesh, 3,
                                          params::spectral_shift(2.1).boundary_direction(
                                              CGP::Boundary_direction{0, 0, 1}));
  EXPECT_EQ(by_default.eigenvalues, asked.eigenvalues);
  EXPECT_NEAR(by_default.pencil_eigenvalues[0], 1.83705, 1e-5);
}

TEST(Dirac_spectrum_of_a_Surface_mesh, refuses_meshes_in_its_own_name)
{
  try {
    (void)CGP::dirac_spectrum(to_cgal_mesh<Surface>(disk(3)), 3,
                              params::boundary_direction(CGP::Boundary_direction{1, 0, 0}));
    FAIL() << "not refused";
  } catch (const CGP::Precondition_error& error) {
    EXPECT_NE(std::string(error.what()).find("dirac_spectrum"), std::string::npos);
  }
}

TEST(Dirac_sphere_of_a_Surface_mesh, overwrites_the_points_and_tells_the_spins)
{
  const Mesh_view sphere = scaled(icosphere(3), 2);
  Surface mesh = to_cgal_mesh<Surface>(sphere);
  const auto spins =
      mesh.add_property_map<Surface::Vertex_index, CGP::Quaternion<double>>("v:spin").first;
  const CGP::Spin_report report = CGP::dirac_sphere(mesh, -2, 0, params::vertex_spin_map(spins));
  ASSERT_TRUE(report);
  EXPECT_NEAR(report.eigenvalue, 1 / 2., 0.01);
  const CGP::Spin_result expected = CGP::spin_to_dirac_sphere(sphere, -2, 0);
  const CGP::Graph_view<Surface> graph(mesh, params::default_values(), "test");
  EXPECT_LT((graph.view().positions() - expected.positions).norm(), 1e-9);
  EXPECT_LT(norm(spins[Surface::Vertex_index(5)] - expected.lambda[5]), 1e-12);
}

TEST(Dirac_sphere_of_a_Surface_mesh, ignores_removed_elements)
{
  const Surface mesh = with_garbage(icosphere(3));
  ASSERT_TRUE(mesh.has_garbage());
  expect_dirac_sphere(mesh, 1e-9);
}

TEST(Dirac_sphere_of_a_Surface_mesh, leaves_what_is_no_sphere_alone)
{
  Surface mesh = to_cgal_mesh<Surface>(bumpy_sphere(2));
  const CGP::Graph_view<Surface> before(mesh, params::default_values(), "test");
  EXPECT_THROW((void)CGP::dirac_sphere(mesh, -2, 0), CGP::Precondition_error);
  const CGP::Graph_view<Surface> after(mesh, params::default_values(), "test");
  EXPECT_TRUE(before.view().positions() == after.view().positions());
}

}  // namespace cgp_test::dirac_spectrum_tests
