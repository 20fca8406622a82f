// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {
namespace internal {

/// A similarity of R^3 that aligns one set of points with another
struct Alignment {
  Eigen::Matrix3d rotation;  ///< determinant +1
  double scale;
  Eigen::Vector3d translation;
  double rms, max;  ///< remaining distances, relative to the bounding box diagonal of the target

  /// Returns scale * rotation * p + translation for every column p
  Points apply(const Points& points) const;
};

}  // namespace internal

/// \ingroup PkgMeasure
/// \brief Computes the least-squares similarity from `source` to `target`, both 3 x n.
/// \param masses weights of the squares of distances, n; all equal if empty
internal::Alignment align(const Points& source, const Points& target,
                          const Eigen::VectorXd& masses = {});

}  // namespace Conformal_geometry_processing
