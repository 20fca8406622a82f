// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/core/geometry_traits.h
#include <Conformal_geometry_processing/core/geometry_traits.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include "concepts/geometry_traits_archetype.h"

namespace cgp_test::geometry_traits_tests {

using namespace Conformal_geometry_processing;
using cgp_test::Geometry_traits_archetype;
using cgp_test::Point_archetype;

using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Points_of_surface = Surface::Property_map<Surface::Vertex_index, Kernel::Point_3>;

struct Traits_without_z {
  using FT = double;
  using Point_3 = Kernel::Point_3;
  Kernel::Compute_x_3 compute_x_3_object() const { return {}; }
  Kernel::Compute_y_3 compute_y_3_object() const { return {}; }
  Kernel::Construct_point_3 construct_point_3_object() const { return {}; }
};

static_assert(internal::is_conformal_geometry_traits<Kernel>);
static_assert(
    internal::is_conformal_geometry_traits<CGAL::Exact_predicates_inexact_constructions_kernel>);
static_assert(internal::is_conformal_geometry_traits<Geometry_traits_archetype>);
static_assert(!internal::is_conformal_geometry_traits<Traits_without_z>);
static_assert(!internal::is_conformal_geometry_traits<int>);

static_assert(std::is_same_v<internal::Vector_of<Kernel::Point_3>, Kernel::Vector_3>);
static_assert(std::is_same_v<internal::Vector_of<Point_archetype>, Eigen::Vector3d>);

Points_of_surface add_points(Surface& mesh, const char* name)
{
  return mesh.add_property_map<Surface::Vertex_index, Kernel::Point_3>(name).first;
}

TEST(Geometry_traits, are_the_kernel_of_the_points_by_default)
{
  const auto traits = internal::geometry_traits<Surface>(parameters::default_values());
  static_assert(std::is_same_v<decltype(traits), const Kernel>);
}

TEST(Geometry_traits, are_the_instance_that_is_passed)
{
  const auto traits =
      internal::geometry_traits<Surface>(parameters::geom_traits(Geometry_traits_archetype(4)));
  EXPECT_EQ(traits.compute_x_3_object().unit, 4);
}

TEST(Vertex_points, are_read_from_the_map_passed_or_else_from_the_mesh)
{
  Surface mesh;
  const auto v = mesh.add_vertex(Kernel::Point_3(1, 0, 0));
  const auto given = add_points(mesh, "v:given");
  put(given, v, Kernel::Point_3(2, 0, 0));
  EXPECT_EQ(get(internal::vertex_points(mesh, parameters::default_values()), v).x(), 1);
  EXPECT_EQ(get(internal::vertex_points(mesh, parameters::vertex_point_map(given)), v).x(), 2);
}

TEST(Output_vertex_points, are_written_where_it_is_told_or_else_in_place)
{
  Surface mesh;
  const auto v = mesh.add_vertex(Kernel::Point_3(1, 0, 0));
  const auto given = add_points(mesh, "v:given"), output = add_points(mesh, "v:output");
  const auto write = [&](const auto& np, double x) {
    put(internal::output_vertex_points(mesh, np), v, Kernel::Point_3(x, 0, 0));
  };
  write(parameters::default_values(), 5);
  write(parameters::vertex_point_map(given), 6);
  write(parameters::vertex_point_map(given).output_vertex_point_map(output), 7);
  EXPECT_EQ(mesh.point(v).x(), 5);
  EXPECT_EQ(get(given, v).x(), 6);
  EXPECT_EQ(get(output, v).x(), 7);
}

}  // namespace cgp_test::geometry_traits_tests
