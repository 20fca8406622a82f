// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Conformal_mesh_traits.h>
#include <Conformal_geometry_processing/filter_curvature.h>
#include <Conformal_geometry_processing/minimal_surface.h>
#include <Conformal_geometry_processing/nearest_spin_transform.h>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "support/bounded_meshes.h"
#include "support/cgal_meshes.h"
#include "support/meshes.h"
#include "support/views.h"

/// Compares shape editing of meshes of any type with the classes on flat arrays.
namespace cgp_test {

namespace CGP = Conformal_geometry_processing;

/// a sphere, stretched in a direction, and not conformally
inline Points stretched(const Mesh_view& mesh)
{
  return mapped(mesh,
                [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
                  return {p.x() + 0.3 * p.z() * p.z(), 1.3 * p.y(), p.z()};
                })
      .positions();
}

/// a map from the vertices of a mesh to values in the order of its vertices
template <class Mesh, class Value>
auto vertex_map(const Mesh& mesh, const std::vector<Value>& values)
{
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  auto numbering = std::make_shared<const CGP::internal::Element_numbering<Vertex>>(vertices(mesh));
  CGP::internal::Associated_property_map<Vertex, Value> map(numbering, values.front());
  std::size_t i = 0;
  for (const Vertex v : vertices(mesh)) map[v] = values[i++];
  return map;
}

/// `Points` as points of the mesh
template <class Mesh>
auto point_map(const Mesh& mesh, const Points& positions)
{
  using Map = typename boost::property_map<Mesh, CGAL::vertex_point_t>::const_type;
  using Point = typename boost::property_traits<Map>::value_type;
  std::vector<Point> list;
  for (Eigen::Index v = 0; v < positions.cols(); ++v)
    list.emplace_back(positions(0, v), positions(1, v), positions(2, v));
  return vertex_map(mesh, list);
}

template <class Mesh>
void expect_nearest_transformation(Mesh mesh, double tolerance)
{
  const Mesh_view before = view_of(mesh);
  CGP::Nearest_spin_transformation near(before, stretched(before));
  const CGP::Nearest_spin_result expected = near.transform();
  const auto target = point_map(mesh, stretched(before));
  const CGP::Nearest_spin_report report = CGP::nearest_spin_transform(mesh, target);
  ASSERT_TRUE(report);
  EXPECT_LT(greatest_distance(view_of(mesh).positions(), expected.positions), tolerance);
  EXPECT_NEAR(report.distance, expected.distance, tolerance);
  EXPECT_EQ(report.sign_conflicts, 0);
}

template <class Mesh>
void expect_minimal_surface(Mesh mesh, double tolerance)
{
  const Mesh_view before = view_of(mesh);
  const CGP::Spin_result expected = CGP::spin_to_minimal_surface(before);
  ASSERT_TRUE(CGP::minimal_surface(mesh));
  EXPECT_LT(greatest_distance(view_of(mesh).positions(), expected.positions), tolerance);
}

/// low and high frequencies add up to the function, and unsharp masking adds the high ones
template <class Mesh>
void expect_filtered_curvature(const Mesh& mesh)
{
  std::vector<double> values;
  for (int v = 0; v < view_of(mesh).size_of_vertices(); ++v)
    values.push_back(std::sin(5 * view_of(mesh).position(v).x()));
  const auto filtered = [&](CGP::Curvature_band band) {
    const auto map = vertex_map(mesh, values);
    CGP::filter_curvature(mesh, map, band,
                          CGP::parameters::filter(CGP::Filter_options{0.05, 2, 3}));
    Eigen::VectorXd result(static_cast<Eigen::Index>(values.size()));
    Eigen::Index i = 0;
    for (const auto v : vertices(mesh)) result[i++] = get(map, v);
    return result;
  };
  const Eigen::VectorXd low = filtered(CGP::Curvature_band::low),
                        high = filtered(CGP::Curvature_band::high),
                        unsharp = filtered(CGP::Curvature_band::unsharp);
  const Eigen::Map<const Eigen::VectorXd> v(values.data(), low.size());
  EXPECT_LT((low + high - v).norm(), 1e-12 * v.norm());
  EXPECT_LT((v + 3 * high - unsharp).norm(), 1e-12 * v.norm());
  EXPECT_GT(high.norm(), 0.1 * v.norm());
  EXPECT_GT(low.norm(), 0.1 * v.norm());
}

inline Mesh_view cap_to_flatten()
{
  return cap_from_disk(disk(6), 1.);
}

}  // namespace cgp_test
