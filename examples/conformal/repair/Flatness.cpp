// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Flatness.h"

#include <Conformal_geometry_processing/mesh/requirements.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace conformal {
namespace {

namespace CGP = Conformal_geometry_processing;

constexpr double next_to_nothing = 1e-12;
constexpr double shorter = 0.9;  // by more than rounding, so that needles are not sent around

bool has(const std::vector<int>& list, int i)
{
  return std::find(list.begin(), list.end(), i) != list.end();
}

}  // namespace

Flatness::Flatness(const Triangle_soup& soup) : m_soup(soup)
{
  double largest = 0;
  for (int t = 0; t < soup.size(); ++t)
    for (int k = 0; k < 3; ++k)
      for (const double x : soup.point(soup.vertex(t, k))) largest = std::max(largest, std::abs(x));
  int exponent = 0;
  std::frexp(largest, &exponent);
  m_unit = std::ldexp(1., std::min(exponent, 1000));  // a power of two rounds nothing
}

Eigen::Vector3d Flatness::point(int v) const
{
  return Eigen::Vector3d::Map(m_soup.point(v).data()) / m_unit;
}

Eigen::Vector3d Flatness::area(const Corners& v) const
{
  return (point(v[1]) - point(v[0])).cross(point(v[2]) - point(v[0])) / 2;
}

bool Flatness::is_flat(const Corners& v) const
{
  Eigen::Matrix3d p, edges;
  for (std::size_t k = 0; k < 3; ++k)
    p.col(static_cast<Eigen::Index>(k)) = Eigen::Vector3d::Map(m_soup.point(v[k]).data());
  edges << p.col(2) - p.col(1), p.col(0) - p.col(2), p.col(1) - p.col(0);
  return CGP::internal::has_area_zero(edges);
}

std::array<int, 3> Flatness::longest_edge_first(int t) const
{
  const auto opposite = [&](int k) {
    return length(m_soup.vertex(t, k + 1), m_soup.vertex(t, k + 2));
  };
  std::array<int, 3> order = {0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&](int i, int j) { return opposite(i) > opposite(j); });
  return order;
}

bool Flatness::is_better_flipped(int t, int k, int g) const
{
  const int c = m_soup.vertex(t, k), a = m_soup.vertex(t, k + 1), b = m_soup.vertex(t, k + 2);
  const int d = m_soup.opposite(g, a, b);
  if (c == d || !m_soup.around(c, d).empty()) return false;
  const std::array<Corners, 2> made = {{{c, a, d}, {d, b, c}}};
  const bool has_side = !is_flat(t) || !is_flat(g);
  const Eigen::Vector3d side = area(corners(t)) + area(corners(g));
  int flat = 0;
  for (const Corners& triangle : made) {
    if (is_flat(triangle))
      ++flat;
    else if (has_side && !(area(triangle).dot(side) > 0))
      return false;
  }
  const int flat_before = int{is_flat(t)} + int{is_flat(g)};
  return flat < flat_before || (flat == flat_before && length(c, d) < shorter * length(a, b));
}

bool Flatness::is_at_boundary(int v) const
{
  for (const int t : m_soup.around(v))
    for (int k = 0; k < 3; ++k)
      if (const int w = m_soup.vertex(t, k); w != v && m_soup.around(v, w).size() != 2) return true;
  return false;
}

bool Flatness::keeps_manifold(int v, int w) const
{
  const std::vector<int> between = m_soup.around(v, w);
  if (between.size() > 2) return false;
  std::vector<int> tips;
  for (const int t : between) {
    tips.push_back(m_soup.opposite(t, v, w));
    if (m_soup.around(v, tips.back()).size() > 2 || m_soup.around(w, tips.back()).size() > 2)
      return false;
  }
  for (const int t : m_soup.around(v))
    for (int k = 0; k < 3; ++k)
      if (const int x = m_soup.vertex(t, k);
          x != v && x != w && !has(tips, x) && !m_soup.around(x, w).empty())
        return false;
  return between.size() < 2 || !is_at_boundary(v) || !is_at_boundary(w);
}

double Flatness::cost_of_collapse(int v, int w) const
{
  const double forbidden = -1;
  if (!keeps_manifold(v, w)) return forbidden;
  int flat_before = 0, flat_after = 0;
  double cost = 0;
  for (const int t : m_soup.around(v)) {
    const Corners old = corners(t), next = moved(old, v, w);
    flat_before += is_flat(old);
    const bool vanishes = next == old;
    if (!vanishes && m_soup.find(next) >= 0) return forbidden;
    if (!vanishes && !is_flat(old) && !(area(old).dot(area(next)) > 0)) return forbidden;
    flat_after += !vanishes && is_flat(next);
    cost += vanishes ? area(old).norm() : (area(next) - area(old)).norm();
  }
  return flat_after < flat_before ? cost : forbidden;
}

bool Flatness::is_better_united(int v, int w, double longest) const
{
  if (!(length(v, w) <= next_to_nothing * longest)) return false;
  int flat_before = 0, flat_after = 0;
  for (const int t : m_soup.around(v)) {
    const Corners old = corners(t), next = moved(old, v, w);
    flat_before += is_flat(old);
    flat_after += next != old && m_soup.find(next) < 0 && is_flat(next);
  }
  return flat_after < flat_before;
}

Flatness::Corners Flatness::moved(const Corners& corners, int v, int w)
{
  Corners result = corners;
  if (std::find(corners.begin(), corners.end(), w) == corners.end())
    std::replace(result.begin(), result.end(), v, w);
  return result;
}

}  // namespace conformal
