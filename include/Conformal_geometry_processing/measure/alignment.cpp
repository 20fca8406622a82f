// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/alignment.h>

#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion.h>
#include <Quaternionic_linear_algebra/dense/hermitian_eigen_decomposition.h>

#include <Eigen/Geometry>

#include <cmath>

namespace Conformal_geometry_processing {

Points internal::Alignment::apply(const Points& points) const
{
  return ((scale * rotation) * points).colwise() + translation;
}

namespace internal {

Eigen::Matrix3d best_rotation(const Eigen::Matrix3d& S)
{
  const Quaternion<double> units[] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  Block<double> form = Block<double>::Zero(4, 4);
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          form(r, c) -= S(i, j) * dot(units[i + 1] * units[r], units[c] * units[j + 1]);
  const Eigen::Vector4d q = hermitian_eigen_decomposition(form).vectors.col(0);
  return Eigen::Quaterniond(q[0], -q[1], -q[2], -q[3]).toRotationMatrix();  // Eigen: q a q^-1
}

/// \pre all are of moderate size
Alignment alignment_in_frames(const Points& source, const Points& target,
                              const Eigen::VectorXd& shares)
{
  const Eigen::Vector3d from = source * shares, to = target * shares;
  const Points arms = source.colwise() - from;
  const Eigen::Matrix3d S = arms * shares.asDiagonal() * (target.colwise() - to).transpose();
  Alignment a;
  a.rotation = best_rotation(S);
  a.scale = a.rotation.cwiseProduct(S.transpose()).sum() / arms.colwise().squaredNorm().dot(shares);
  a.translation = to - a.scale * (a.rotation * from);
  const Eigen::RowVectorXd distance = (a.apply(source) - target).colwise().norm();
  const double diagonal = (target.rowwise().maxCoeff() - target.rowwise().minCoeff()).norm();
  a.rms = std::sqrt(distance.cwiseAbs2().dot(shares)) / diagonal;
  a.max = distance.maxCoeff() / diagonal;
  return a;
}

}  // namespace internal

internal::Alignment align(const Points& source, const Points& target, const Eigen::VectorXd& masses)
{
  const Eigen::VectorXd all = masses.size() > 0 ? masses : Eigen::VectorXd::Ones(source.cols());
  // In frames of their own, where squares neither overflow nor underflow.
  const internal::Normalized_frame frame(source), target_frame(target);
  internal::Alignment a = internal::alignment_in_frames(
      frame.to_frame(source), target_frame.to_frame(target), all / all.sum());
  a.scale *= target_frame.unit() / frame.unit();
  a.translation = target_frame.from_frame(a.translation) - a.scale * (a.rotation * frame.center());
  return a;
}

}  // namespace Conformal_geometry_processing
