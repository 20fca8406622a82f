// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/spin/Control_point.h>

#include <cmath>
#include <vector>

#include "support/mesh_tools.h"

/// Control points that are spread over a surface.
namespace cgp_test {

using Conformal_geometry_processing::internal::Control_point;

/// `count` vertices: the highest one, and each next as far as possible from those before
inline std::vector<int> spread_vertices(const Mesh_view& mesh, int count)
{
  const auto& p = mesh.positions();
  std::vector<int> all(1);
  p.row(1).maxCoeff(&all[0]);
  Eigen::RowVectorXd distances = (p.colwise() - p.col(all[0])).colwise().norm();
  while (static_cast<int>(all.size()) < count) {
    int next;
    distances.maxCoeff(&next);
    all.push_back(next);
    distances = distances.cwiseMin((p.colwise() - p.col(next)).colwise().norm());
  }
  return all;
}

inline double diagonal(const Mesh_view& mesh)
{
  const auto& p = mesh.positions();
  return (p.rowwise().maxCoeff() - p.rowwise().minCoeff()).norm();
}

/// the radius of the sphere of the same area
inline double radius(const Mesh_view& mesh)
{
  double area = 0;
  for (int f = 0; f < mesh.size_of_faces(); ++f) area += mesh.double_area_vector(f).norm() / 2;
  return std::sqrt(area / (16 * std::atan(1.)));
}

/// holds `count` spread vertices where they are, but moves the second one by so many radii
inline std::vector<Control_point> one_moved(const Mesh_view& mesh, int count, double radii)
{
  std::vector<Control_point> points;
  for (const int v : spread_vertices(mesh, count))
    points.push_back(Conformal_geometry_processing::internal::control_point(v, mesh.position(v)));
  points[1].target += radii * radius(mesh) * Eigen::Vector3d(.6, .5, .62);
  return points;
}

}  // namespace cgp_test
