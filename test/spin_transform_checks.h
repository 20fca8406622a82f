// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/spin_transform.h>

#include <gtest/gtest.h>

#include <optional>

#include "support/cgal_meshes.h"
#include "support/dense.h"
#include "support/meshes.h"
#include "support/views.h"

/// What spin_transform() does to a mesh of any type, measured against the class on flat arrays.
namespace cgp_test {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;

template <class Mesh>
using Vertex_of = typename boost::graph_traits<Mesh>::vertex_descriptor;
template <class Mesh>
using Face_of = typename boost::graph_traits<Mesh>::face_descriptor;

/// the eigenvector: the transformation of the class by default, not that of the entry points
inline auto unbounded()
{
  return CGP::parameters::scale_bound(std::nullopt);
}

inline Mesh_view sphere_to_transform()
{
  return icosphere(2);
}

inline CGP::Spin_result expected_result(const Mesh_view& mesh, const Curvature_potential& rho)
{
  return CGP::Spin_transformation(mesh).transform(rho);
}

inline Curvature_potential rho_on_vertices(const Mesh_view& mesh)
{
  return Curvature_potential::on_vertices(rho_of_section_3_on_vertices(mesh));
}

inline Curvature_potential rho_on_faces(const Mesh_view& mesh)
{
  return Curvature_potential::on_faces(rho_of_section_3_on_faces(mesh));
}

/// writes the values of rho into a map on the vertices or faces of the mesh
template <class Range, class Map>
void fill(const Range& range, Map map, const Eigen::VectorXd& values)
{
  Eigen::Index i = 0;
  for (const auto element : range) put(map, element, values[i++]);
}

template <class Range, class Map>
Quaternion_vector<double> spins(const Range& range, Map map, int size)
{
  Quaternion_vector<double> lambda(size);
  Eigen::Index i = 0;
  for (const auto element : range) {
    const auto& value = get(map, element);
    lambda[i++] = CGP::Quaternion_access<std::decay_t<decltype(value)>>::from(value);
  }
  return lambda;
}

/// rho on vertices with lambda, and rho on faces: positions and spins equal those of the class, up
/// to `tolerance`, the precision of the points
template <class Mesh>
void expect_transformation(const Mesh& original, double tolerance)
{
  const Mesh_view before = view_of(original);
  {
    Mesh mesh = original;
    auto rho = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
    auto lambda = get(CGAL::dynamic_vertex_property_t<Quaternion<double>>(), mesh);
    fill(vertices(mesh), rho, rho_on_vertices(before).values);
    const auto report = CGP::spin_transform(mesh, rho, unbounded().vertex_spin_map(lambda));
    EXPECT_TRUE(report);
    const CGP::Spin_result expected = expected_result(before, rho_on_vertices(before));
    EXPECT_LT(greatest_distance(view_of(mesh).positions(), expected.positions), tolerance);
    EXPECT_LT(greatest_difference(spins(vertices(mesh), lambda, before.size_of_vertices()),
                                  expected.lambda),
              1e-12);
    EXPECT_EQ(report.eigenvalue, expected.report.eigenvalue);
  }
  Mesh mesh = original;
  auto rho = get(CGAL::dynamic_face_property_t<double>(), mesh);
  fill(faces(mesh), rho, rho_on_faces(before).values);
  EXPECT_TRUE(CGP::spin_transform(mesh, rho, unbounded()));
  const CGP::Spin_result expected = expected_result(before, rho_on_faces(before));
  EXPECT_LT(greatest_distance(view_of(mesh).positions(), expected.positions), tolerance);
}

}  // namespace cgp_test
