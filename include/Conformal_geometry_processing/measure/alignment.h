// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MEASURE_ALIGNMENT_H
#define CONFORMAL_GEOMETRY_PROCESSING_MEASURE_ALIGNMENT_H

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>

namespace Conformal_geometry_processing {

/// \ingroup PkgMeasure
/// a similarity of R^3 that takes one set of points as close as possible to another
struct Alignment {
  Eigen::Matrix3d rotation;  ///< determinant +1
  double scale;
  Eigen::Vector3d translation;
  double rms, max;  ///< distances left, relative to the diagonal of the target's bounding box

  /// scale * rotation * p + translation for every column p
  Points apply(const Points& points) const
  {
    return ((scale * rotation) * points).colwise() + translation;
  }
};

/// \ingroup PkgMeasure
/// \brief the best similarity from `source` to `target`, both 3 x n, in the sense of least squares.
inline Alignment align(const Points& source, const Points& target)
{
  const Eigen::Matrix4d T = Eigen::umeyama(source, target, true);
  Alignment a;
  a.scale = std::cbrt(T.topLeftCorner<3, 3>().determinant());
  a.rotation = T.topLeftCorner<3, 3>() / a.scale;
  a.translation = T.topRightCorner<3, 1>();
  const Eigen::RowVectorXd distance = (a.apply(source) - target).colwise().norm();
  const double diagonal = (target.rowwise().maxCoeff() - target.rowwise().minCoeff()).norm();
  a.rms = distance.norm() / std::sqrt(static_cast<double>(source.cols())) / diagonal;
  a.max = distance.maxCoeff() / diagonal;
  return a;
}

}  // namespace Conformal_geometry_processing

#endif
