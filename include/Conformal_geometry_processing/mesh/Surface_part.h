// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace Conformal_geometry_processing {
namespace internal {

/// \brief which of a surface is counted, and how the numbers of several parts become those of the
/// whole: with one, what measures a surface measures one whose parts are in several processes.
///
/// By default, a surface in one part. A part has all faces around its own vertices, so that what is
/// computed there is right, and its own vertices and faces come first.
struct Surface_part {
  int vertices = (std::numeric_limits<int>::max)(), faces = vertices;  ///< own ones, or all
  std::function<bool(int edge)> is_own_edge = {};
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> sum_of_parts = {};
  std::function<double(double)> largest_of_parts = {};

  int own_vertices(Eigen::Index all) const { return (std::min)(vertices, static_cast<int>(all)); }
  int own_faces(Eigen::Index all) const { return (std::min)(faces, static_cast<int>(all)); }
  bool counts(int edge) const { return !is_own_edge || is_own_edge(edge); }

  /// of each coefficient
  Eigen::VectorXd sum(const Eigen::VectorXd& own) const
  {
    return sum_of_parts ? sum_of_parts(own) : own;
  }
  double sum(double own) const { return sum(Eigen::VectorXd::Constant(1, own))[0]; }

  /// the largest coefficient, -infinity if there is none
  double largest(const Eigen::VectorXd& own) const
  {
    const double most = own.size() > 0 ? own.maxCoeff() : -HUGE_VAL;
    return largest_of_parts ? largest_of_parts(most) : most;
  }
  double smallest(const Eigen::VectorXd& own) const { return -largest(-own); }
};

}  // namespace internal
}  // namespace Conformal_geometry_processing
