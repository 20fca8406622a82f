// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Dents.h"

#include <algorithm>
#include <cmath>

namespace conformal {

// Straight corners are among them: rounding may make them dents later.
Dents::Dents(const Plane_polygon& points)
    : m_points(points), m_low(points.front()), m_size(points.front())
{
  std::vector<std::size_t> dents;
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    m_low = m_low.cwiseMin(points[i]);
    m_size = m_size.cwiseMax(points[i]);
    const Eigen::Vector2d &before = points[(i + n - 1) % n], &after = points[(i + 1) % n];
    if (!(twice_area(before, points[i], after) > 0)) dents.push_back(i);
  }
  m_size -= m_low;
  m_columns = 1 + static_cast<std::size_t>(std::sqrt(static_cast<double>(dents.size()) / 2));
  m_cells.resize(m_columns * m_columns);
  for (const std::size_t i : dents) cell(i).push_back(i);
}

std::size_t Dents::column(double x, Eigen::Index axis) const
{
  const double share = m_size[axis] > 0 ? (x - m_low[axis]) / m_size[axis] : 0;
  return std::min(static_cast<std::size_t>(share * static_cast<double>(m_columns)), m_columns - 1);
}

std::vector<std::size_t>& Dents::cell(std::size_t corner)
{
  const Eigen::Vector2d& p = m_points[corner];
  return m_cells[column(p.x(), 0) * m_columns + column(p.y(), 1)];
}

void Dents::remove(std::size_t corner)
{
  std::vector<std::size_t>& all = cell(corner);
  all.erase(std::remove(all.begin(), all.end(), corner), all.end());
}

bool Dents::has_any_in(const std::array<std::size_t, 3>& t) const
{
  const Eigen::Vector2d &a = m_points[t[0]], &b = m_points[t[1]], &c = m_points[t[2]];
  const Eigen::Vector2d low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
  const auto is_in = [&](std::size_t i) {
    const Eigen::Vector2d& p = m_points[i];
    return i != t[0] && i != t[1] && i != t[2] && twice_area(a, b, p) >= 0 &&
           twice_area(b, c, p) >= 0 && twice_area(c, a, p) >= 0;
  };
  for (std::size_t x = column(low.x(), 0); x <= column(high.x(), 0); ++x)
    for (std::size_t y = column(low.y(), 1); y <= column(high.y(), 1); ++y) {
      const auto& all = m_cells[x * m_columns + y];
      if (std::any_of(all.begin(), all.end(), is_in)) return true;
    }
  return false;
}

}  // namespace conformal
