// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin_transform.h
// Tests include/Conformal_geometry_processing/spin/Spin_visitor.h
#include "concepts/triangle_mesh_archetype.h"

#include <Conformal_geometry_processing/spin_transform.h>

#include <gtest/gtest.h>

#include "concepts/Sparse_hermitian_eigensolver_archetype.h"
#include "concepts/Sparse_hermitian_solver_archetype.h"
#include "concepts/geometry_traits_archetype.h"
#include "support/dense.h"
#include "support/meshes.h"

namespace {

namespace params = Conformal_geometry_processing::parameters;
using cgp_test::Geometry_traits_archetype;
using cgp_test::Point_archetype;
using cgp_test::Quaternion;

const double unit = 8;  // of the geometry traits

archetype::Triangle_mesh archetype_of(const cgp_test::Mesh_view& view)
{
  archetype::Triangle_mesh mesh{cgp_test::at(view.size_of_vertices()), {}};
  for (const auto& v : view.corners())
    mesh.corners.push_back({cgp_test::at(v[0]), cgp_test::at(v[1]), cgp_test::at(v[2])});
  return mesh;
}

/// readable, by value, not default constructible
struct Point_map {
  using key_type = archetype::Vertex;
  using value_type = Point_archetype;
  using reference = Point_archetype;
  using category = boost::readable_property_map_tag;

  explicit Point_map(const cgp_test::Mesh_view& mesh) : view(&mesh) {}
  const cgp_test::Mesh_view* view;

  friend Point_archetype get(const Point_map& map, archetype::Vertex v)
  {
    const Eigen::Vector3d p = map.view->position(static_cast<int>(v.number));
    return Geometry_traits_archetype(unit).construct_point_3_object()(p.x(), p.y(), p.z());
  }
};

struct Rho_map {
  using key_type = archetype::Vertex;
  using value_type = double;
  using reference = double;
  using category = boost::readable_property_map_tag;

  explicit Rho_map(const cgp_test::Mesh_view& mesh) : view(&mesh) {}
  const cgp_test::Mesh_view* view;

  friend double get(const Rho_map& map, archetype::Vertex v)
  {
    return cgp_test::rho_of_section_3(map.view->position(static_cast<int>(v.number)));
  }
};

/// can be written only
struct Output_map {
  using key_type = archetype::Vertex;
  using value_type = Point_archetype;
  using reference = void;
  using category = boost::writable_property_map_tag;

  explicit Output_map(cgp_test::Points& out) : points(&out) {}
  cgp_test::Points* points;

  friend void put(const Output_map& map, archetype::Vertex v, const Point_archetype& p)
  {
    const Geometry_traits_archetype traits(unit);
    map.points->col(static_cast<int>(v.number)) << traits.compute_x_3_object()(p),
        traits.compute_y_3_object()(p), traits.compute_z_3_object()(p);
  }
};

struct Spin_map {
  using key_type = archetype::Vertex;
  using value_type = Quaternion<double>;
  using reference = void;
  using category = boost::writable_property_map_tag;

  explicit Spin_map(cgp_test::Quaternion_vector<double>& out) : spins(&out) {}
  cgp_test::Quaternion_vector<double>* spins;

  friend void put(const Spin_map& map, archetype::Vertex v, const Quaternion<double>& q)
  {
    (*map.spins)[static_cast<int>(v.number)] = q;
  }
};

/// exactly the concept, and tied to its place
struct Visitor {
  Visitor() = default;
  Visitor(const Visitor&) = delete;
  Visitor& operator=(const Visitor&) = delete;
  void on_iteration(const Conformal_geometry_processing::Eigen_progress&) { ++count; }
  bool go_further() { return true; }
  int count = 0;
};

class Spin_transform_with_archetypes : public testing::Test {
 protected:
  template <class NamedParameters>
  void expect_transformation(const NamedParameters& np)
  {
    const auto report = Conformal_geometry_processing::spin_transform(mesh, Rho_map(view), np);
    EXPECT_TRUE(report);
    EXPECT_LT((points - expected.positions).norm(), 1e-6);
    EXPECT_LT(cgp_test::greatest_difference(spins, expected.lambda), 1e-6);
  }

  const cgp_test::Mesh_view view = cgp_test::icosphere(1);
  archetype::Triangle_mesh mesh = archetype_of(view);
  cgp_test::Points points{3, view.size_of_vertices()};
  cgp_test::Quaternion_vector<double> spins{view.size_of_vertices()};
  const Conformal_geometry_processing::Spin_result expected =
      Conformal_geometry_processing::Spin_transformation<>(view).transform(
          Conformal_geometry_processing::Curvature_potential::on_vertices(
              cgp_test::rho_of_section_3_on_vertices(view)));
};

}  // namespace

TEST_F(Spin_transform_with_archetypes, of_the_mesh_the_maps_the_geometry_and_the_visitor)
{
  Visitor visitor;
  expect_transformation(params::vertex_point_map(Point_map(view))
                            .output_vertex_point_map(Output_map(points))
                            .vertex_spin_map(Spin_map(spins))
                            .geom_traits(Geometry_traits_archetype(unit))
                            .visitor(std::ref(visitor)));
  EXPECT_GT(visitor.count, 0);
}

TEST_F(Spin_transform_with_archetypes, of_the_solvers_too)
{
  expect_transformation(params::vertex_point_map(Point_map(view))
                            .output_vertex_point_map(Output_map(points))
                            .vertex_spin_map(Spin_map(spins))
                            .geom_traits(Geometry_traits_archetype(unit))
                            .sparse_solver(cgp_test::Sparse_hermitian_solver_traits_archetype())
                            .eigenvalue_solver(cgp_test::Sparse_hermitian_eigensolver_archetype()));
}
