// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/filter_curvature.h
// Tests include/Conformal_geometry_processing/minimal_surface.h
// Tests include/Conformal_geometry_processing/nearest_spin_transform.h
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <limits>

#include "shape_editing_checks.h"

namespace cgp_test::shape_editing_surface_mesh_tests {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Surface = CGAL::Surface_mesh<Point>;

/// Returns the message of the exception, empty if there is none; checks that the mesh is unchanged
template <class Call>
std::string refusal(Surface& mesh, Call call)
{
  const Points before = view_of(mesh).positions();
  try {
    call();
  } catch (const CGP::Precondition_error& error) {
    EXPECT_EQ(view_of(mesh).positions(), before);
    return error.message();
  }
  return "";
}

TEST(Nearest_spin_transform_of_a_Surface_mesh, is_that_of_its_triangles)
{
  expect_nearest_transformation(to_cgal_mesh<Surface>(icosphere(2)), 1e-12);
}

TEST(Nearest_spin_transform_of_a_Surface_mesh, blends_and_scales_as_told)
{
  Surface mesh = to_cgal_mesh<Surface>(icosphere(2));
  const Mesh_view before = view_of(mesh);
  const auto target = point_map(mesh, stretched(before));
  const auto output = mesh.add_property_map<Surface::Vertex_index, Point>("v:out").first;
  CGP::Nearest_spin_transformation near(before, stretched(before));
  const CGP::Nearest_spin_result half = near.blend(near.transform(), 0.5);
  const auto report = CGP::nearest_spin_transform(
      mesh, target, CGP::parameters::blend(0.5).output_vertex_point_map(output));
  ASSERT_TRUE(report);
  EXPECT_NEAR(report.distance, half.distance, 1e-12);
  EXPECT_EQ(view_of(mesh).positions(), before.positions());
  const auto scales = vertex_map(mesh, std::vector<double>(before.size_of_vertices(), 4.));
  const auto scaled = CGP::nearest_spin_transform(
      mesh, target, CGP::parameters::vertex_scale_map(scales).output_vertex_point_map(output));
  EXPECT_TRUE(scaled);
  EXPECT_LT(scaled.distance, half.distance + 0.1);
}

TEST(Nearest_spin_transform_of_a_Surface_mesh, gives_a_boundary_the_binormals_if_told_so)
{
  Surface mesh = to_cgal_mesh<Surface>(disk(6));
  const Mesh_view before = view_of(mesh);
  const auto target = point_map(mesh, stretched(before));
  CGP::Nearest_spin_options options;
  options.direction = {0, 0, 1};
  CGP::Nearest_spin_transformation near(before, stretched(before), "test", options);
  const auto expected = near.transform();
  ASSERT_TRUE(CGP::nearest_spin_transform(
      mesh, target, CGP::parameters::boundary_direction(CGP::Boundary_direction{0, 0, 1})));
  EXPECT_LT(greatest_distance(view_of(mesh).positions(), expected.positions), 1e-12);
}

TEST(Nearest_spin_transform_of_a_Surface_mesh, refuses_targets_and_scales_that_are_none)
{
  Surface mesh = to_cgal_mesh<Surface>(icosphere(1));
  Points target = view_of(mesh).positions();
  target(0, 5) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refusal(mesh, [&] { (void)CGP::nearest_spin_transform(mesh, point_map(mesh, target)); })
                .find("vertex 5"),
            std::string::npos);
  std::vector<double> scales(num_vertices(mesh), 1.);
  scales[3] = 0;
  EXPECT_NE(refusal(mesh,
                    [&] {
                      (void)CGP::nearest_spin_transform(
                          mesh, mesh.points(),
                          CGP::parameters::vertex_scale_map(vertex_map(mesh, scales)));
                    })
                .find("vertex 3"),
            std::string::npos);
}

TEST(Minimal_surface_of_a_Surface_mesh, is_that_of_its_triangles)
{
  expect_minimal_surface(to_cgal_mesh<Surface>(cap_to_flatten()), 1e-12);
}

TEST(Minimal_surface_of_a_Surface_mesh, is_not_for_closed_surfaces)
{
  Surface mesh = to_cgal_mesh<Surface>(icosphere(1));
  EXPECT_NE(refusal(mesh, [&] { (void)CGP::minimal_surface(mesh); }).find("closed"),
            std::string::npos);
}

TEST(Filter_curvature_on_a_Surface_mesh, splits_functions_by_frequency)
{
  expect_filtered_curvature(to_cgal_mesh<Surface>(icosphere(2)));
  expect_filtered_curvature(to_cgal_mesh<Surface>(cap_to_flatten()));
}

TEST(Filter_curvature_on_a_Surface_mesh, refuses_what_it_cannot_filter)
{
  Surface mesh = to_cgal_mesh<Surface>(icosphere(1));
  std::vector<double> values(num_vertices(mesh), 1.);
  values[7] = std::numeric_limits<double>::infinity();
  const auto map = vertex_map(mesh, values);
  const auto filter = [&](const auto& np) {
    return refusal(mesh, [&] { CGP::filter_curvature(mesh, map, CGP::Curvature_band::low, np); });
  };
  EXPECT_NE(filter(CGP::parameters::default_values()).find("vertex 7"), std::string::npos);
  EXPECT_EQ(map[*vertices(mesh).begin()], 1);
  map[Surface::Vertex_index(7)] = 1;
  EXPECT_NE(filter(CGP::parameters::filter(CGP::Filter_options{-1})).find("weight"),
            std::string::npos);
}

}  // namespace cgp_test::shape_editing_surface_mesh_tests
