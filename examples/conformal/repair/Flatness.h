// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Triangle_soup.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace conformal {

/// \brief Predicates on flat triangles of a soup, and on the effect of flips and collapses; changes
/// nothing.
class Flatness {
 public:
  using Corners = std::array<int, 3>;

  explicit Flatness(const Triangle_soup& soup);

  /// by the rule by which surfaces are refused
  bool is_flat(const Corners& v) const;
  bool is_flat(int t) const { return is_flat(corners(t)); }

  /// lengths and areas are in units of the largest coordinate
  double length(int v, int w) const { return (point(w) - point(v)).norm(); }
  double unit() const { return m_unit; }

  /// the corners of a triangle, the one opposite the longest edge first
  std::array<int, 3> longest_edge_first(int t) const;

  /// Whether to flip the edge opposite corner k of t: fewer flat triangles, or as many and a
  /// shorter edge; none turned over, and no edge that is there already.
  bool is_better_flipped(int t, int k, int g) const;

  /// How much areas change if v moves to w, or a negative number if that leaves no fewer flat
  /// triangles, if a triangle is turned over, or edges of more than two triangles arise.
  double cost_of_collapse(int v, int w) const;

  /// Whether v is so near w that they can be taken for one, and fewer triangles are flat then.
  bool is_better_united(int v, int w, double longest) const;

  /// whether an edge at v has one triangle only or more than two, so that the surface ends there
  bool is_at_boundary(int v) const;

 private:
  Corners corners(int t) const
  {
    return {m_soup.vertex(t, 0), m_soup.vertex(t, 1), m_soup.vertex(t, 2)};
  }
  Eigen::Vector3d point(int v) const;
  Eigen::Vector3d area(const Corners& v) const;
  bool keeps_manifold(int v, int w) const;

  /// the corners with w in the place of v, or the same if w is among them
  static Corners moved(const Corners& corners, int v, int w);

  const Triangle_soup& m_soup;
  double m_unit = 1;
};

}  // namespace conformal
