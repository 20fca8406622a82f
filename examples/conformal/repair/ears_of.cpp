// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "ears_of.h"

#include "Dents.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace conformal {
namespace {

using Triangle = std::array<std::size_t, 3>;

class Ear_clipper {
 public:
  explicit Ear_clipper(const Plane_polygon& points)
      : m_points(points), m_dents(points), m_left(points.size())
  {
    std::iota(m_left.begin(), m_left.end(), std::size_t{0});
  }

  std::vector<Triangle> triangles()
  {
    constexpr std::size_t large = 100;
    while (m_left.size() > large) cut_all_around();
    while (m_left.size() > 3) {
      const std::size_t i = best_ear();
      m_result.push_back(corner(i));
      m_left.erase(m_left.begin() + static_cast<std::ptrdiff_t>(i));
    }
    m_result.push_back({m_left[0], m_left[1], m_left[2]});
    return std::move(m_result);
  }

 private:
  Triangle corner(std::size_t i) const
  {
    const std::size_t n = m_left.size();
    return {m_left[(i + n - 1) % n], m_left[i], m_left[(i + 1) % n]};
  }

  // Not two in a row, so that no corner gets all triangles. If there is no ear, because the polygon
  // crosses itself, all are cut.
  void cut_all_around()
  {
    const std::size_t before = m_left.size();
    cut_every_other([this](const Triangle& t) { return quality(t) > 0 && !m_dents.has_any_in(t); });
    if (m_left.size() == before) cut_every_other([](const Triangle&) { return true; });
  }

  template <class MayBeCut>
  void cut_every_other(const MayBeCut& may_be_cut)
  {
    std::vector<std::size_t> kept = {m_left[0]};
    for (std::size_t i = 1; i < m_left.size(); ++i) {
      const bool has_next = i + 1 < m_left.size();
      const Triangle t = {kept.back(), m_left[i], m_left[has_next ? i + 1 : 0]};
      if (has_next && may_be_cut(t)) {
        m_result.push_back(t);
        m_dents.remove(m_left[i++]);
      }
      kept.push_back(m_left[i]);
    }
    m_left = std::move(kept);
  }

  // the ear whose cut leaves the best worst triangle
  std::size_t best_ear() const
  {
    std::size_t best = 0;
    double best_quality = -1;
    for (std::size_t i = 0; i < m_left.size(); ++i) {
      const double quality = quality_of_cut(i);
      if (quality <= best_quality || m_dents.has_any_in(corner(i))) continue;
      best = i;
      best_quality = quality;
    }
    return best;
  }

  double quality_of_cut(std::size_t i) const
  {
    const double q = quality(corner(i));
    if (m_left.size() != 4) return q;
    const auto opposite = corner((i + 2) % 4);
    return std::min(q, quality(opposite));
  }

  // 1 for an equilateral triangle, 0 for a flat one, negative for a dent
  double quality(const Triangle& t) const
  {
    const Eigen::Vector2d &a = m_points[t[0]], &b = m_points[t[1]], &c = m_points[t[2]];
    const double squares = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
    return squares > 0 ? 2 * std::sqrt(3.) * twice_area(a, b, c) / squares : 0;
  }

  const Plane_polygon& m_points;
  Dents m_dents;
  std::vector<std::size_t> m_left;  // corners that are not cut off yet
  std::vector<Triangle> m_result;
};

}  // namespace

std::vector<Triangle> ears_of(const Plane_polygon& polygon)
{
  return Ear_clipper(polygon).triangles();
}

}  // namespace conformal
