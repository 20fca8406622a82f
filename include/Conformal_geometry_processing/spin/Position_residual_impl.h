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
CGP_INLINE Points with_axes(const Points& points, const Eigen::VectorXd& shares)
{
  const double size = 1e-6;  // its square is what they count
  Points all(3, points.cols() + 6);
  all.leftCols(points.cols()) = points;
  const Eigen::Vector3d mean = points * shares;
  all.middleCols(points.cols(), 3) = (size * Eigen::Matrix3d::Identity()).colwise() + mean;
  all.rightCols(3) = (-size * Eigen::Matrix3d::Identity()).colwise() + mean;
  return all;
}

CGP_INLINE Alignment placement(const Points& points, const Points& targets,
                               const Eigen::VectorXd& masses)
{
  Eigen::VectorXd all = Eigen::VectorXd::Ones(points.cols() + 6);
  if (masses.size() > 0) all.head(points.cols()) = masses;
  const Eigen::VectorXd shares = all.head(points.cols()) / all.head(points.cols()).sum();
  return align(with_axes(points, shares), with_axes(targets, shares), all);
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

CGP_INLINE Shape_motions::Shape_motions(const Points& points, const Eigen::VectorXd& masses)
{
  const double line = 1e-6;  // points this near to a line are on it
  const Eigen::VectorXd roots = masses.cwiseSqrt().transpose().replicate<3, 1>().reshaped();
  m_qr.compute(roots.asDiagonal() * similarity_motions(points));
  m_qr.setThreshold(line);
}

CGP_INLINE Eigen::VectorXd Shape_motions::coordinates(const Eigen::VectorXd& v,
                                                      Eigen::Index size) const
{
  const Eigen::VectorXd all = m_qr.householderQ().adjoint() * v;
  return all.tail(size);
}

CGP_INLINE Eigen::VectorXd Shape_motions::motion(const Eigen::VectorXd& y) const
{
  Eigen::VectorXd all = Eigen::VectorXd::Zero(m_qr.rows());
  all.tail(y.size()) = y;
  return m_qr.householderQ() * all;
}

}  // namespace internal
}  // namespace Conformal_geometry_processing

#endif
