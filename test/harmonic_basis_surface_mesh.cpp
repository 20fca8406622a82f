// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests harmonic_basis.h
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "harmonic_basis_checks.h"
#include "support/bounded_meshes.h"

namespace cgp_test::harmonic_basis_surface_mesh_tests {

namespace params = CGP::parameters;
using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

/// a tetrahedron beside the torus, which is removed and leaves its slots behind
Surface torus_with_garbage()
{
  Surface mesh;
  add_to_cgal_mesh(tetrahedron(), mesh);
  const std::vector<Surface::Face_index> first(faces(mesh).begin(), faces(mesh).end());
  add_to_cgal_mesh(btorus(8), mesh);
  for (const auto f : first) CGAL::Euler::remove_face(halfedge(f, mesh), mesh);
  return mesh;
}

std::string message_of_refusal(const Mesh_view& view)
{
  try {
    (void)CGP::harmonic_basis(to_cgal_mesh<Surface>(view));
  } catch (const CGP::Precondition_error& error) {
    return error.what();
  }
  return "not refused";
}

TEST(Harmonic_basis_of_a_Surface_mesh, is_that_of_its_triangles)
{
  expect_harmonic_forms(to_cgal_mesh<Surface>(icosphere(1)), 0);
  for (const int genus : {1, 2, 3})
    expect_harmonic_forms(to_cgal_mesh<Surface>(holed_block(genus)), genus);
  expect_basis_of_the_view(to_cgal_mesh<Surface>(smooth_handlebody(2, 1)));
}

TEST(Harmonic_basis_of_a_Surface_mesh, goes_around_holes_too)
{
  expect_harmonic_forms(to_cgal_mesh<Surface>(disk(4)), 0);
  expect_harmonic_forms(to_cgal_mesh<Surface>(annulus(.4, 1, 24, 4)), 0, 1);
  expect_harmonic_forms(to_cgal_mesh<Surface>(without_face(btorus(8), 5)), 1);
  expect_basis_of_the_view(to_cgal_mesh<Surface>(cylinder(1, 2, 12, 6)));
}

TEST(Harmonic_basis_of_a_Surface_mesh, ignores_removed_elements)
{
  const Surface mesh = torus_with_garbage();
  ASSERT_TRUE(mesh.has_garbage());
  expect_harmonic_forms(mesh, 1);
  expect_basis_of_the_view(mesh);
}

TEST(Harmonic_basis_of_a_Surface_mesh, has_vectors_of_its_kernel)
{
  const auto forms = CGP::harmonic_basis(to_cgal_mesh<Surface>(btorus(6)));
  EXPECT_TRUE((std::is_same_v<decltype(forms)::Vector, Kernel::Vector_3>));
}

TEST(Harmonic_basis_of_a_Surface_mesh, outlives_the_mesh_and_is_shared_by_copies_and_maps)
{
  auto mesh = std::make_unique<Surface>(to_cgal_mesh<Surface>(btorus(6)));
  auto forms = std::make_unique<decltype(CGP::harmonic_basis(*mesh))>(CGP::harmonic_basis(*mesh));
  const auto copy = *forms;
  const auto form = forms->one_form(1);
  const Surface::Halfedge_index h = *halfedges(*mesh).begin();
  const double value = get(form, h);
  mesh.reset();
  forms.reset();
  EXPECT_EQ(get(form, h), value);
  EXPECT_EQ(copy.one_form(1)[h], value);
  EXPECT_EQ(copy.size(), 2);
}

TEST(Harmonic_basis_of_a_Surface_mesh, refuses_elements_that_it_does_not_know)
{
  const auto forms = CGP::harmonic_basis(to_cgal_mesh<Surface>(btorus(6)));
  EXPECT_THROW((void)get(forms.one_form(0), Surface::Halfedge_index(1000)),
               CGP::Precondition_error);
  EXPECT_THROW((void)get(forms.tangent_field(0), Surface::Face_index(1000)),
               CGP::Precondition_error);
}

TEST(Harmonic_basis_of_a_Surface_mesh, reads_the_points_of_the_map_given)
{
  Surface mesh = to_cgal_mesh<Surface>(btorus(6));
  const auto expected = CGP::harmonic_basis(mesh);
  auto points = mesh.add_property_map<Surface::Vertex_index, Kernel::Point_3>("points").first;
  for (const auto v : vertices(mesh)) {
    points[v] = mesh.point(v);
    mesh.point(v) = Kernel::Point_3(0, 0, 0);
  }
  const auto forms = CGP::harmonic_basis(mesh, params::vertex_point_map(points));
  for (const auto h : halfedges(mesh))
    EXPECT_EQ(get(forms.one_form(0), h), get(expected.one_form(0), h));
}

TEST(Harmonic_basis_of_a_Surface_mesh, has_fields_in_one_over_length)
{
  const Surface mesh = to_cgal_mesh<Surface>(btorus(6));
  for (const double scale : {1e-200, 3e7, 1e200}) {
    const auto forms = CGP::harmonic_basis(to_cgal_mesh<Surface>(scaled(btorus(6), scale)));
    const auto expected = CGP::harmonic_basis(mesh);
    for (const auto f : faces(mesh)) {
      const Eigen::Vector3d v = to_eigen(get(forms.tangent_field(1), f)) * scale;
      EXPECT_LT((v - to_eigen(get(expected.tangent_field(1), f))).norm(), 1e-12);
    }
  }
}

TEST(Harmonic_basis_of_a_Surface_mesh, refuses_unsuitable_meshes_in_its_name)
{
  const auto refuses = [](const Mesh_view& mesh, const std::string& what) {
    const std::string message = message_of_refusal(mesh);
    return message.find("harmonic_basis: ") == 0 && message.find(what) != std::string::npos;
  };
  EXPECT_TRUE(refuses(disjoint_union(btorus(8), icosphere(1), {9, 0, 0}), "2 components"));
  EXPECT_TRUE(refuses(Mesh_view(), "no faces"));
  Points p = btorus(8).positions();
  p(1, 4) = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(refuses(Mesh_view(p, btorus(8).corners()), "vertex 4"));
}

}  // namespace cgp_test::harmonic_basis_surface_mesh_tests
