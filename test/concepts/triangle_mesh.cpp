// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/core/Graph_view.h
//       include/Conformal_geometry_processing/compute_vertex_normals.h
#include "concepts/triangle_mesh_archetype.h"

#include <Conformal_geometry_processing/compute_vertex_normals.h>

#include <gtest/gtest.h>

#include "concepts/geometry_traits_archetype.h"

namespace cgp_test::triangle_mesh_tests {

using namespace Conformal_geometry_processing;
using cgp_test::Geometry_traits_archetype;
using cgp_test::Point_archetype;

/// the corner of the unit cube at the origin without its diagonal plane: two faces, x = 0 and y = 0
const archetype::Triangle_mesh mesh{4, {{0, 3, 2}, {0, 1, 3}}};
const double unit = 8;

struct Point_map {
  using key_type = archetype::Vertex;
  using value_type = Point_archetype;
  using reference = Point_archetype;
  using category = boost::readable_property_map_tag;

  friend Point_archetype get(const Point_map&, archetype::Vertex v)
  {
    const auto n = v.number;
    return Geometry_traits_archetype(unit).construct_point_3_object()(n == 1, n == 2, n == 3);
  }
};

struct Vector {
  Vector(double x, double y, double z) : coordinates(x, y, z) {}
  Eigen::Vector3d coordinates;
};

/// a writable map, which cannot be read
struct Normal_map {
  using key_type = archetype::Vertex;
  using value_type = Vector;
  using reference = void;
  using category = boost::writable_property_map_tag;

  std::vector<Eigen::Vector3d>* values;
  friend void put(const Normal_map& map, archetype::Vertex v, const Vector& n)
  {
    (*map.values)[v.number] = n.coordinates;
  }
};

/// keeps the points in the order in which they are written
struct Recorder {
  std::vector<Point_archetype>* points;
  friend void put(const Recorder& map, archetype::Vertex, const Point_archetype& p)
  {
    map.points->push_back(p);
  }
};

TEST(Triangle_mesh_archetype, with_archetypes_of_maps_and_traits_is_enough)
{
  std::vector<Eigen::Vector3d> normals(4);
  compute_vertex_normals(
      mesh, Normal_map{&normals},
      parameters::vertex_point_map(Point_map()).geom_traits(Geometry_traits_archetype(unit)));
  EXPECT_EQ(normals[1], Eigen::Vector3d(0, -1, 0));
  EXPECT_EQ(normals[2], Eigen::Vector3d(-1, 0, 0));
  EXPECT_NEAR((normals[3] - Eigen::Vector3d(-1, -1, 0).normalized()).norm(), 0, 1e-15);
}

TEST(Triangle_mesh_archetype, is_read_and_written_in_the_units_of_traits_that_have_a_state)
{
  const Geometry_traits_archetype traits(2 * unit);
  const Graph_view<archetype::Triangle_mesh> graph(mesh, Point_map(), traits, "test");
  EXPECT_EQ(graph.view().position(1), Eigen::Vector3d(2, 0, 0));
  std::vector<Point_archetype> written;
  graph.write_positions(graph.view().positions(), Recorder{&written}, traits);
  EXPECT_EQ(Geometry_traits_archetype(unit).compute_x_3_object()(written.at(1)), 1);
}

}  // namespace cgp_test::triangle_mesh_tests
