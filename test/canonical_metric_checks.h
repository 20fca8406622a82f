// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/canonical_metric.h>

#include <gtest/gtest.h>

#include <vector>

#include "support/cgal_meshes.h"
#include "support/meshes.h"

/// What canonical_metric() writes for a mesh of any type, measured against flat arrays.
namespace cgp_test {

namespace CGP = Conformal_geometry_processing;

inline Mesh_view torus_to_measure()
{
  return btorus(12);
}

template <class Range, class Map>
Eigen::VectorXd values(const Range& range, Map map)
{
  std::vector<double> list;
  for (const auto element : range) list.push_back(get(map, element));
  return Eigen::VectorXd::Map(list.data(), static_cast<Eigen::Index>(list.size()));
}

/// Densities on faces and on vertices equal those of the arrays up to `tolerance`, the precision of
/// the points
template <class Mesh>
void expect_canonical_metric(Mesh& mesh, double tolerance)
{
  const Mesh_view view = torus_to_measure();
  const Eigen::VectorXd u =
      CGP::canonical_area_density(view, CGP::Hodge_decomposition(view).harmonic_basis().one_forms);

  auto on_faces = get(CGAL::dynamic_face_property_t<double>(), mesh);
  const CGP::Canonical_metric_report report = CGP::canonical_metric(mesh, on_faces);
  EXPECT_EQ(report.genus, 1);
  EXPECT_NEAR(report.area, 1, 1e-10);
  EXPECT_NEAR(report.min_density, u.minCoeff(), tolerance);
  EXPECT_NEAR(report.max_density, u.maxCoeff(), tolerance);
  EXPECT_LT((values(faces(mesh), on_faces) - u).cwiseAbs().maxCoeff(), tolerance);

  auto on_vertices = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
  (void)CGP::canonical_metric(mesh, on_vertices);
  const Eigen::VectorXd areas =
      values(vertices(mesh), on_vertices).cwiseProduct(CGP::vertex_areas(view));
  EXPECT_LT((areas - CGP::canonical_vertex_areas(view, u)).cwiseAbs().maxCoeff(), tolerance);
}

}  // namespace cgp_test
