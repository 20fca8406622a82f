// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests conformal_parameterization.h, Spectral_conformal_parameterizer_3.h
#include <Conformal_geometry_processing/Spectral_conformal_parameterizer_3.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "conformal_parameterization_checks.h"
#include "support/meshes.h"

namespace cgp_test::conformal_parameterization_surface_mesh_tests {

namespace params = CGP::parameters;
namespace SMP = CGAL::Surface_mesh_parameterization;
using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Surface::Vertex_index;
using Plane_point = Kernel::Point_2;

/// a tetrahedron beside the surface, which is removed and leaves its slots behind
Surface with_garbage(const Mesh_view& view)
{
  Surface mesh;
  add_to_cgal_mesh(tetrahedron(), mesh);
  const std::vector<Surface::Face_index> first(faces(mesh).begin(), faces(mesh).end());
  add_to_cgal_mesh(view, mesh);
  for (const auto f : first) CGAL::Euler::remove_face(halfedge(f, mesh), mesh);
  return mesh;
}

Surface::Property_map<Vertex, Plane_point> uv_map(Surface& mesh)
{
  return mesh.add_property_map<Vertex, Plane_point>("v:uv", Plane_point(7, 7)).first;
}

Surface::Halfedge_index border_of(const Surface& mesh)
{
  for (const auto h : halfedges(mesh))
    if (is_border(h, mesh)) return h;
  return Surface::null_halfedge();
}

void expect_untouched(const Surface& mesh, const Surface::Property_map<Vertex, Plane_point>& uv)
{
  for (const Vertex v : vertices(mesh)) EXPECT_EQ(uv[v], Plane_point(7, 7));
}

TEST(Conformal_parameterization_of_a_Surface_mesh, is_that_of_its_triangles_without_garbage)
{
  expect_parameterization_of_the_view(to_cgal_mesh<Surface>(cap_to_map()), 1e-12);
  const Surface mesh = with_garbage(cap_to_map());
  ASSERT_TRUE(mesh.has_garbage());
  expect_parameterization_of_the_view(mesh, 1e-12);
}

TEST(Conformal_parameterization_of_a_Surface_mesh, writes_points_of_any_type)
{
  Surface mesh = to_cgal_mesh<Surface>(cap_to_map());
  const auto cgal = uv_map(mesh);
  const auto array = mesh.add_property_map<Vertex, std::array<double, 2>>("v:array").first;
  const auto eigen = mesh.add_property_map<Vertex, Eigen::Vector2d>("v:eigen").first;
  ASSERT_TRUE(CGP::conformal_parameterization(mesh, cgal));
  ASSERT_TRUE(CGP::conformal_parameterization(mesh, array));
  ASSERT_TRUE(CGP::conformal_parameterization(mesh, eigen));
  for (const Vertex v : vertices(mesh)) {
    EXPECT_EQ(cgal[v].x(), array[v][0]);
    EXPECT_EQ(cgal[v].y(), array[v][1]);
    EXPECT_EQ(Eigen::Vector2d(array[v][0], array[v][1]), eigen[v]);
  }
}

TEST(Conformal_parameterization_of_a_Surface_mesh, reads_the_points_of_the_map_given)
{
  Surface mesh = to_cgal_mesh<Surface>(cap_to_map());
  const auto expected = uv_map(mesh);
  ASSERT_TRUE(CGP::conformal_parameterization(mesh, expected));
  const auto points = mesh.add_property_map<Vertex, Kernel::Point_3>("points").first;
  for (const Vertex v : vertices(mesh)) {
    points[v] = mesh.point(v);
    mesh.point(v) = Kernel::Point_3(0, 0, 0);
  }
  const auto uv = mesh.add_property_map<Vertex, Plane_point>("v:other").first;
  ASSERT_TRUE(CGP::conformal_parameterization(mesh, uv, params::vertex_point_map(points)));
  for (const Vertex v : vertices(mesh)) EXPECT_EQ(uv[v], expected[v]);
}

TEST(Conformal_parameterization_of_a_Surface_mesh, obeys_its_parameters)
{
  Surface mesh = to_cgal_mesh<Surface>(cylinder(1, 1, 24, 4));
  const auto uv = uv_map(mesh);
  const auto rough = CGP::conformal_parameterization(mesh, uv, params::tolerance(1e-3));
  ASSERT_TRUE(rough);
  EXPECT_LT(rough.residual, 1e-3);
  EXPECT_EQ(rough.normalized_vertices, 24);
}

TEST(Conformal_parameterization_of_a_Surface_mesh, writes_nothing_without_success)
{
  Surface mesh = to_cgal_mesh<Surface>(cap_to_map());
  const auto uv = uv_map(mesh);
  EXPECT_FALSE(
      CGP::conformal_parameterization(mesh, uv, params::tolerance(1e-12).number_of_iterations(1)));
  expect_untouched(mesh, uv);
  Surface closed = to_cgal_mesh<Surface>(icosphere(1));
  const auto closed_uv = uv_map(closed);
  EXPECT_THROW((void)CGP::conformal_parameterization(closed, closed_uv), CGP::Precondition_error);
  expect_untouched(closed, closed_uv);
}

TEST(Spectral_conformal_parameterizer_3, gives_the_map_of_the_entry_point_by_way_of_cgal)
{
  for (Surface mesh : {to_cgal_mesh<Surface>(cap_to_map()), with_garbage(cap_to_map())}) {
    const auto expected = uv_map(mesh);
    ASSERT_TRUE(CGP::conformal_parameterization(mesh, expected, params::tolerance(1e-8)));
    const auto uv = mesh.add_property_map<Vertex, Plane_point>("v:other").first;
    CGP::Parameterization_options options;
    options.tolerance = 1e-8;
    ASSERT_EQ(SMP::parameterize(mesh, CGP::Spectral_conformal_parameterizer_3<Surface>(options),
                                border_of(mesh), uv),
              SMP::OK);
    // Equal up to a rotation, because the loop may begin at another vertex.
    std::vector<std::complex<double>> z, w;
    for (const Vertex v : vertices(mesh)) {
      z.emplace_back(expected[v].x(), expected[v].y());
      w.emplace_back(uv[v].x(), uv[v].y());
    }
    for (std::size_t i = 1; i < z.size(); ++i)
      EXPECT_NEAR(std::abs(z[i] - z[0]), std::abs(w[i] - w[0]), 1e-7);
  }
}

TEST(Spectral_conformal_parameterizer_3, flattens_the_component_of_the_border_only)
{
  Surface mesh;
  add_to_cgal_mesh(cap_to_map(), mesh);
  const auto n = num_vertices(mesh);
  add_to_cgal_mesh(icosphere(1), mesh);
  const auto uv = uv_map(mesh);
  ASSERT_EQ(SMP::parameterize(mesh, CGP::Spectral_conformal_parameterizer_3<Surface>(),
                              border_of(mesh), uv),
            SMP::OK);
  for (const Vertex v : vertices(mesh)) EXPECT_EQ(uv[v] == Plane_point(7, 7), v.idx() >= n);
}

TEST(Spectral_conformal_parameterizer_3, keeps_the_spread_of_the_border_given)
{
  Surface mesh = to_cgal_mesh<Surface>(cylinder(1, 1, 24, 4));
  for (const auto h : halfedges(mesh)) {
    if (!is_border(h, mesh)) continue;
    const auto uv = uv_map(mesh);
    ASSERT_EQ(SMP::parameterize(mesh, CGP::Spectral_conformal_parameterizer_3<Surface>(), h, uv),
              SMP::OK);
    const Plane_point p = uv[target(h, mesh)];  // centred around that border: on a circle
    for (const auto g : CGAL::halfedges_around_face(h, mesh))
      EXPECT_NEAR(CGAL::squared_distance(uv[target(g, mesh)], Plane_point(0, 0)),
                  CGAL::squared_distance(p, Plane_point(0, 0)), 1e-6);
  }
}

TEST(Spectral_conformal_parameterizer_3, returns_what_is_wrong)
{
  CGP::Spectral_conformal_parameterizer_3<Surface> parameterizer;
  const auto status_of = [&](Surface mesh, bool on_border) {
    const auto uv = uv_map(mesh);
    const auto number = mesh.add_property_map<Vertex, int>("v:number").first;
    const auto done = mesh.add_property_map<Vertex, bool>("v:done").first;
    for (const Vertex v : vertices(mesh)) number[v] = static_cast<int>(v.idx());
    const auto border = on_border ? border_of(mesh) : *halfedges(mesh).begin();
    const auto code = parameterizer.parameterize(mesh, border, uv, number, done);
    if (code != SMP::OK) expect_untouched(mesh, uv);
    return code;
  };
  EXPECT_EQ(status_of(to_cgal_mesh<Surface>(disk(2)), true), SMP::OK);
  EXPECT_EQ(status_of(to_cgal_mesh<Surface>(icosphere(1)), false), SMP::ERROR_EMPTY_MESH);
  Surface quad;
  std::vector<Vertex> corners;
  for (const auto& p : {Kernel::Point_3(0, 0, 0), {1, 0, 0}, {1, 1, 0}, {0, 1, 0}})
    corners.push_back(quad.add_vertex(p));
  quad.add_face(corners);
  EXPECT_EQ(status_of(quad, true), SMP::ERROR_NON_TRIANGULAR_MESH);
  Surface flat = to_cgal_mesh<Surface>(disk(2));
  for (const Vertex v : vertices(flat)) flat.point(v) = Kernel::Point_3(1, 2, 3);
  EXPECT_EQ(status_of(flat, true), SMP::ERROR_WRONG_PARAMETER);
}

TEST(Spectral_conformal_parameterizer_3, returns_that_it_has_not_converged)
{
  CGP::Parameterization_options options;
  options.tolerance = 1e-12;
  options.maximum_number_of_iterations = 1;
  Surface mesh = to_cgal_mesh<Surface>(cap_to_map());
  const auto uv = uv_map(mesh);
  EXPECT_EQ(SMP::parameterize(mesh, CGP::Spectral_conformal_parameterizer_3<Surface>(options),
                              border_of(mesh), uv),
            SMP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM);
  expect_untouched(mesh, uv);
}

}  // namespace cgp_test::conformal_parameterization_surface_mesh_tests
