// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "support/random.h"

/// Delaunay triangulations of random points of the plane: disks and rings whose boundary edges
/// jump in length, with numbers in random order. Nothing in them is symmetric or in rows, so no
/// error cancels that does not cancel on meshes of users.
namespace cgp_test {

struct Circle {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radius = 1;
};

/// adds points one by one, and joins the edges of the faces in whose circle they are to them
class Delaunay {
 public:
  /// \param p in the unit disk. The last come first: those inside before those on circles, of
  /// which no four then have an empty circle
  explicit Delaunay(std::vector<Eigen::Vector2d> p) : m_p(std::move(p))
  {
    const int n = static_cast<int>(m_p.size());
    m_p.insert(m_p.end(), {{-40, -30}, {40, -31}, {1, 50}});
    m_faces.push_back({n, n + 1, n + 2});
    for (int v = n - 1; v >= 0; --v) insert(v);
  }

  /// those of the first n points
  Corners faces(int n) const
  {
    Corners inside;
    for (const auto& f : m_faces)
      if (f[0] < n && f[1] < n && f[2] < n) inside.push_back(f);
    return inside;
  }

 private:
  bool has_in_circle(const std::array<int, 3>& f, int v) const
  {
    Eigen::Matrix3d m;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector2d d = m_p[at(f[at(i)])] - m_p[at(v)];
      m.row(i) << d.x(), d.y(), d.squaredNorm();
    }
    return m.determinant() > 0;
  }

  void insert(int v)
  {
    std::set<std::pair<int, int>> edges;
    Corners kept;
    for (const auto& f : m_faces) {
      if (!has_in_circle(f, v)) {
        kept.push_back(f);
        continue;
      }
      for (int i = 0; i < 3; ++i) {
        const std::pair<int, int> e{f[at(i)], f[at((i + 1) % 3)]};
        if (edges.erase({e.second, e.first}) == 0) edges.insert(e);
      }
    }
    for (const auto& e : edges) kept.push_back({e.first, e.second, v});
    m_faces = std::move(kept);
  }

  std::vector<Eigen::Vector2d> m_p;
  Corners m_faces;
};

/// points on a circle, with gaps between half and one and a half times h
std::vector<Eigen::Vector2d> uneven_points(const Circle& circle, double h, Random& random);

/// \brief the part of the unit disk outside of the circles, in edges of length about h; the normal
/// is +z
Mesh_view random_domain(double h, std::uint64_t seed, const std::vector<Circle>& holes = {});

}  // namespace cgp_test
