// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <type_traits>

namespace Conformal_geometry_processing {
namespace internal {

/// \brief which of a surface is counted, and how the numbers of several parts become those of the
/// whole: with one, what measures a surface measures one whose parts are in several processes.
///
/// By default, a surface in one part. A part has all faces around its own vertices, so that what is
/// computed there is right, and its own vertices and faces come first. Values at the other vertices
/// are those of their owners; sums over vertices, such as areas and gradients, are zero there, so
/// that a product of both is that of the own vertices.
struct Surface_part {
  int vertices = (std::numeric_limits<int>::max)(), faces = vertices;  ///< own ones, or all
  std::function<bool(int edge)> is_own_edge = {};
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> sum_of_parts = {};
  std::function<double(double)> largest_of_parts = {};
  std::function<void(Eigen::MatrixXd&)> take_from_owners = {};  ///< a column for each vertex

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

  /// replaces values at other vertices, a column for each vertex, by those of their owners
  template <class Values>
  void complete(Values&& values) const
  {
    if (!take_from_owners) return;
    Eigen::MatrixXd all = values;
    take_from_owners(all);
    values = all;
  }

  /// sets sums at other vertices, a row for each vertex, to zero
  template <class Sums>
  void clear_others(Sums&& sums) const
  {
    const Eigen::Index others = sums.rows() - own_vertices(sums.rows());
    sums.bottomRows(others).setConstant(typename std::decay_t<Sums>::Scalar{});
  }
};

}  // namespace internal
}  // namespace Conformal_geometry_processing
