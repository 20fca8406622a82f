// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Plane_polygon.h"

#include <array>
#include <cstddef>

namespace conformal {

/// \brief The corners of a polygon at which it is not convex: no other one can lie in an ear.
/// Cutting ears off makes no new ones.
class Dents {
 public:
  explicit Dents(const Plane_polygon& points);

  /// Forgets a corner that is cut off.
  void remove(std::size_t corner);

  /// whether one lies in a triangle of corners, or on its sides
  bool has_any_in(const std::array<std::size_t, 3>& triangle) const;

 private:
  std::size_t column(double x, Eigen::Index axis) const;
  std::vector<std::size_t>& cell(std::size_t corner);

  const Plane_polygon& m_points;
  Eigen::Vector2d m_low, m_size;
  std::size_t m_columns = 1;
  std::vector<std::vector<std::size_t>> m_cells;  // of a grid with a few dents in each
};

}  // namespace conformal
