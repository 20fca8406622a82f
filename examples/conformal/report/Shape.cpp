// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Shape.h"

#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace conformal {

Shape shape(const Conformal_geometry_processing::Mesh_view& mesh)
{
  using namespace Conformal_geometry_processing;
  const double degrees = 180 / std::acos(-1.);
  Shape s;
  s.area = total_area(mesh);
  s.diagonal =
      (mesh.positions().rowwise().maxCoeff() - mesh.positions().rowwise().minCoeff()).stableNorm();
  s.min_angle = 180;
  double shortest = std::numeric_limits<double>::infinity(), longest = 0;
  for (int h = 0; h < mesh.size_of_halfedges(); ++h) {
    s.min_angle = std::min(s.min_angle, corner_angle(mesh.sheet(h / 3), h % 3) * degrees);
    shortest = std::min(shortest, mesh.vector(h).stableNorm());
    longest = std::max(longest, mesh.vector(h).stableNorm());
  }
  s.edge_ratio = longest / shortest;
  const Eigen::VectorXd w = cotan_weights(mesh);
  const double rounding = 1e-12;  // two right angles opposite an edge give zero
  s.negative_weights =
      static_cast<double>((w.array() < -rounding).count()) / static_cast<double>(w.size());
  return s;
}

}  // namespace conformal
