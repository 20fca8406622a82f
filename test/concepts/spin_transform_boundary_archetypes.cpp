// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin_transform.h
// Tests include/Conformal_geometry_processing/core/boundary_parameters.h
#include "concepts/archetype_maps.h"

#include <Conformal_geometry_processing/spin_transform.h>

#include <gtest/gtest.h>

#include "concepts/Sparse_hermitian_solver_archetype.h"
#include "support/bounded_meshes.h"

namespace cgp_test::spin_transform_boundary_archetypes_tests {

namespace CGP = Conformal_geometry_processing;
using cgp_test::Geometry_traits_archetype;
using cgp_test::Mesh_view;
using cgp_test::Points;

/// a vector that has coordinates and nothing else
class Vector_archetype {
 public:
  Vector_archetype() = delete;
  explicit Vector_archetype(const Eigen::Vector3d& v) : m_v(v) {}
  double x() const { return m_v.x(); }
  double y() const { return m_v.y(); }
  double z() const { return m_v.z(); }

 private:
  Eigen::Vector3d m_v;
};

/// what can only be read, by value, and cannot be default constructed
/// \tparam Value is made of a column
template <class Value>
struct Readable_map {
  using key_type = archetype::Vertex;
  using value_type = Value;
  using reference = Value;
  using category = boost::readable_property_map_tag;

  explicit Readable_map(const Points& p) : columns(&p) {}
  const Points* columns;

  friend Value get(const Readable_map& map, archetype::Vertex v)
  {
    return Value(map.columns->col(static_cast<int>(v.number)));
  }
};
using Vector_map = Readable_map<Vector_archetype>;

/// Only a condition
struct Constrained_map {
  using key_type = archetype::Vertex;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;
  explicit Constrained_map(int n) : first(n) {}
  int first;
  friend bool get(const Constrained_map& map, archetype::Vertex v)
  {
    return static_cast<int>(v.number) >= map.first;
  }
};

class Spin_transform_of_boundary_archetypes : public testing::Test {
 protected:
  auto parameters()
  {
    return CGP::parameters::vertex_point_map(cgp_test::Point_map_archetype(view))
        .output_vertex_point_map(cgp_test::Output_map_archetype(points))
        .geom_traits(Geometry_traits_archetype(cgp_test::archetype_unit))
        .sparse_solver(cgp_test::Sparse_hermitian_solver_traits_archetype());
  }

  template <class NamedParameters>
  void expect_transformation(const NamedParameters& np, const CGP::Boundary_condition& condition)
  {
    const boost::static_property_map<double, archetype::Vertex> rho(.5);
    EXPECT_TRUE(CGP::spin_transform(mesh, rho, np));
    const auto expected = CGP::Spin_transformation(view, {condition})
                              .transform(CGP::Curvature_potential::on_vertices(
                                  Eigen::VectorXd::Constant(view.size_of_vertices(), .5)));
    EXPECT_LT((points - expected.positions).norm(), 1e-6);
  }

  const Mesh_view view = cgp_test::cap_from_disk(cgp_test::disk(3), 1);
  const Mesh_view moved = cgp_test::mapped(
      view, [](const Eigen::Vector3d& p) { return Eigen::Vector3d(p.x(), 1.1 * p.y(), p.z()); });
  const Points normals = view.positions();  // of the sphere
  archetype::Triangle_mesh mesh = cgp_test::archetype_of(view);
  Points points{3, view.size_of_vertices()};
};

TEST_F(Spin_transform_of_boundary_archetypes, needs_vectors_to_have_coordinates_only)
{
  const Points up = view.positions().colwise() - Eigen::Vector3d(0, 0, 2);
  expect_transformation(parameters()
                            .boundary_direction(CGP::Boundary_direction{0, 0, 1})
                            .boundary_direction_map(Vector_map(up)),
                        CGP::Boundary_condition::binormals(up.rightCols(18)));
}

TEST_F(Spin_transform_of_boundary_archetypes, reads_target_points_with_the_geometry_traits)
{
  expect_transformation(
      parameters()
          .vertex_target_point_map(cgp_test::Point_map_archetype(moved))
          .vertex_normal_map(Vector_map(normals))
          .vertex_is_constrained_map(Constrained_map(19)),
      CGP::Boundary_condition::positions(moved.positions().rightCols(18), normals.rightCols(18)));
}

}  // namespace cgp_test::spin_transform_boundary_archetypes_tests
