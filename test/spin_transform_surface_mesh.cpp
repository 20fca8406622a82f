// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin_transform.h
#include <Conformal_geometry_processing/core/Conformal_mesh_traits_Surface_mesh.h>

#include <CGAL/Simple_cartesian.h>

#include "spin_transform_boundary_checks.h"

namespace cgp_test::spin_transform_surface_mesh_tests {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Surface = CGAL::Surface_mesh<Point>;

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

Surface sphere_with_garbage()
{
  return with_garbage(sphere_to_transform());
}

TEST(Spin_transform_of_a_Surface_mesh, is_that_of_its_triangles)
{
  expect_transformation(to_cgal_mesh<Surface>(sphere_to_transform()), 1e-14);
}

TEST(Spin_transform_of_a_Surface_mesh, ignores_removed_elements)
{
  const Surface mesh = sphere_with_garbage();
  ASSERT_TRUE(mesh.has_garbage());
  ASSERT_EQ(view_of(mesh).size_of_faces(), sphere_to_transform().size_of_faces());
  expect_transformation(mesh, 1e-14);
}

TEST(Spin_transform_of_a_Surface_mesh, prescribes_what_becomes_of_the_boundary)
{
  expect_transformation_with_boundary(to_cgal_mesh<Surface>(cap_to_transform()), 1e-14);
  const Surface mesh = with_garbage(cap_to_transform());
  ASSERT_TRUE(mesh.has_garbage());
  expect_transformation_with_boundary(mesh, 1e-14);
}

TEST(Spin_transform_of_a_Surface_mesh, reads_and_fills_the_properties_of_the_mesh_traits)
{
  Surface mesh = sphere_with_garbage();
  const Mesh_view before = view_of(mesh);
  const CGP::Conformal_mesh_traits<Surface> traits(mesh);
  fill(faces(mesh), traits.face_curvature_potential_map(), rho_on_faces(before).values);
  ASSERT_TRUE(CGP::spin_transform(mesh, traits.face_curvature_potential_map(),
                                  unbounded().vertex_spin_map(traits.vertex_spin_map())));
  const CGP::Spin_result expected = expected_result(before, rho_on_faces(before));
  EXPECT_EQ(spins(vertices(mesh), traits.vertex_spin_map(), before.size_of_vertices()),
            expected.lambda);
  EXPECT_EQ(view_of(mesh).positions(), expected.positions);
}

TEST(Spin_transform_of_a_Surface_mesh, keeps_handles_closed_unless_told_otherwise)
{
  Surface closed = to_cgal_mesh<Surface>(torus(1, 0.4, 24, 12));
  const Mesh_view before = view_of(closed);
  auto rho = closed.add_property_map<Surface::Vertex_index, double>("v:rho").first;
  Eigen::VectorXd sine(before.size_of_vertices());
  for (const auto v : closed.vertices())
    rho[v] = sine[static_cast<Eigen::Index>(v)] = std::sin(3 * closed.point(v).x() + 1);
  const auto values = Curvature_potential::on_vertices(sine);
  Surface open = closed;
  const auto report = CGP::spin_transform(closed, rho, unbounded());
  EXPECT_TRUE(report);
  EXPECT_GT(report.missing_share, 0.01);
  CGP::Spin_report::Limits limits;
  EXPECT_FALSE(CGP::spin_transform(open, rho, unbounded().exactness(std::nullopt)));
  EXPECT_LT(greatest_distance(view_of(open).positions(), before.positions()), 1e-15);
  limits.closure = 1;
  limits.map = {10, 1, 1};
  const auto plain =
      CGP::spin_transform(open, rho, unbounded().exactness(std::nullopt).limits(limits));
  EXPECT_TRUE(plain);
  EXPECT_EQ(plain.missing_share, 0);
  const Points expected = CGP::Spin_transformation(before).step(values).positions;
  EXPECT_LT(greatest_distance(view_of(open).positions(), expected), 1e-12);
  const Points of_class = expected_result(before, values).positions;
  EXPECT_LT(greatest_distance(view_of(closed).positions(), of_class), 1e-12);
  EXPECT_GT(plain.conformality.quasi_conformal.mean - 1,
            2 * (report.conformality.quasi_conformal.mean - 1));
}

}  // namespace cgp_test::spin_transform_surface_mesh_tests
