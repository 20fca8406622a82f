// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_POSITION_RESIDUAL_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_POSITION_RESIDUAL_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/spin/Position_residual.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/QR>

namespace Conformal_geometry_processing {
namespace internal {

/// the points, and six near their mean that decide what they leave open
CGP_INLINE Points with_axes(const Points& points)
{
  const double size = 1e-6;  // its square is what they count
  Points all(3, points.cols() + 6);
  all.leftCols(points.cols()) = points;
  const Eigen::Vector3d mean = points.rowwise().mean();
  all.middleCols(points.cols(), 3) = (size * Eigen::Matrix3d::Identity()).colwise() + mean;
  all.rightCols(3) = (-size * Eigen::Matrix3d::Identity()).colwise() + mean;
  return all;
}

CGP_INLINE Alignment placement(const Points& points, const Points& targets)
{
  return align(with_axes(points), with_axes(targets));
}

/// translations, turns and scaling about the mean, 3k x 7
CGP_INLINE Eigen::MatrixXd similarity_motions(const Points& points)
{
  const Eigen::Vector3d mean = points.rowwise().mean();
  Eigen::MatrixXd motions(points.size(), 7);
  for (Eigen::Index k = 0; k < points.cols(); ++k) {
    const Eigen::Vector3d arm = points.col(k) - mean;
    auto block = motions.middleRows(3 * k, 3);
    block.leftCols(3).setIdentity();
    for (int axis = 0; axis < 3; ++axis)
      block.col(3 + axis) = Eigen::Vector3d::Unit(axis).cross(arm);
    block.col(6) = arm;
  }
  return motions;
}

CGP_INLINE Eigen::Index number_of_shape_motions(const Points& points)
{
  const double line = 1e-6;  // points this near to a line are on it
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(similarity_motions(points));
  qr.setThreshold(line);
  return points.size() - qr.rank();
}

CGP_INLINE Eigen::MatrixXd shape_motions(const Points& points, Eigen::Index columns)
{
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(similarity_motions(points));
  const Eigen::MatrixXd all =
      qr.householderQ() * Eigen::MatrixXd::Identity(points.size(), points.size());
  return all.rightCols(columns);
}

}  // namespace internal
}  // namespace Conformal_geometry_processing

#endif
