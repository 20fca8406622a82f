// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Boundary_frames.h>

#include <cmath>
#include <cstddef>

#include "conformal_willmore_flow_checks.h"
#include "support/bounded_meshes.h"

/// What conformal_willmore_flow() does to a mesh of any type with boundary, measured against the
/// class.
namespace cgp_test {

using CGP::Boundary_condition;

inline Mesh_view bumpy_cap_of_few_faces()
{
  return mapped(cap_from_disk(disk(5), 1), [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d((1 + .1 * std::sin(4 * p.x()) * std::cos(3 * p.y())) * p);
  });
}

/// a direction between binormal and normal, for a surface around the z axis
inline Eigen::Vector3d new_binormal(const Eigen::Vector3d& p)
{
  return {2 * p.x(), 2 * p.y(), -.9};
}

/// that direction for each vertex
template <class Mesh>
auto binormals_at_vertices(const Mesh& mesh, const Mesh_view& view)
{
  auto map = get(CGAL::dynamic_vertex_property_t<Eigen::Vector3d>(), mesh);
  int v = 0;
  for (const auto vertex : vertices(mesh)) put(map, vertex, new_binormal(view.position(v++)));
  return map;
}

inline Boundary_condition condition_of_binormals(const Mesh_view& view)
{
  const CGP::internal::Boundary_frames b = CGP::boundary_frames(view);
  Points targets(3, static_cast<Eigen::Index>(b.vertices.size()));
  for (std::size_t k = 0; k < b.vertices.size(); ++k)
    targets.col(static_cast<Eigen::Index>(k)) = new_binormal(view.position(b.vertices[k]));
  return Boundary_condition::binormals(targets);
}

/// \param mesh the mesh that the maps in `np` refer to
/// \param np two steps with this condition
template <class Mesh, class NamedParameters>
void expect_flow_with(Mesh&& mesh, const NamedParameters& np, const Boundary_condition& condition,
                      double tolerance)
{
  CGP::Flow_options options;
  options.max_steps = 2;
  options.surface.boundary = condition;
  CGP::Conformal_willmore_flow expected(view_of(mesh), options);
  const CGP::Flow_report expected_report = expected.run();
  EXPECT_EQ(expected_report.steps.size(), 2U) << expected_report.message;
  const CGP::Flow_report report = CGP::conformal_willmore_flow(mesh, np);
  EXPECT_EQ(report.stop, expected_report.stop);
  EXPECT_EQ(report.energy, expected_report.energy);
  EXPECT_LT(greatest_distance(view_of(mesh).positions(), expected.mesh().positions()), tolerance);
}

/// the one with most parameters
template <class Mesh>
void expect_flow_with_binormals(Mesh mesh, double tolerance)
{
  const Mesh_view view = view_of(mesh);
  expect_flow_with(mesh,
                   CGP::parameters::boundary_direction(CGP::Boundary_direction{0, 0, 1})
                       .boundary_direction_map(binormals_at_vertices(mesh, view))
                       .number_of_iterations(2),
                   condition_of_binormals(view), tolerance);
}

}  // namespace cgp_test
