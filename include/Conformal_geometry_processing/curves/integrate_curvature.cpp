// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/curves/integrate_curvature.h>

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing {

void integrate_curvature(const Eigen::VectorXd& curvatures,
                         const internal::Polygon_lengths& lengths, double angle,
                         internal::Plane_points& tangents)
{
  tangents.resize(2, lengths.size_of_edges());
  for (Eigen::Index i = 0; i < lengths.size_of_edges(); ++i) {
    if (i > 0) angle += lengths.duals()[i] * curvatures[i];
    tangents(0, i) = lengths.edges()[i] * std::cos(angle);
    tangents(1, i) = lengths.edges()[i] * std::sin(angle);
  }
}

}  // namespace Conformal_geometry_processing
