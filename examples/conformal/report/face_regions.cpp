// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "face_regions.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

namespace conformal {
namespace {

/// Grows regions from seeds; distances are between centres of faces, across common edges.
class Region_growth {
 public:
  explicit Region_growth(const CGP::Mesh_view& mesh)
      : m_mesh(mesh), m_region(faces(), -1), m_distance(faces(), HUGE_VAL)
  {}

  /// Gives a new region all faces that are nearer to the seed than to those before.
  void add_seed(int seed)
  {
    ++m_count;
    enter(seed, 0);
    while (!m_queue.empty()) {
      const auto [distance, f] = m_queue.top();
      m_queue.pop();
      if (-distance > m_distance[at(f)]) continue;
      for (int h = 3 * f; h < 3 * f + 3; ++h) {
        const int twin = m_mesh.twin(h);
        if (twin < 0) continue;
        const int g = CGP::Mesh_view::face(twin);
        const double further = (middle(f) - middle(g)).norm() - distance;
        if (further < m_distance[at(g)]) enter(g, further);
      }
    }
  }

  int farthest_face() const
  {
    return static_cast<int>(std::max_element(m_distance.begin(), m_distance.end()) -
                            m_distance.begin());
  }

  bool has_reached_all() const { return m_distance[at(farthest_face())] < HUGE_VAL; }
  int count() const { return m_count; }
  std::vector<int> regions() && { return std::move(m_region); }

 private:
  static std::size_t at(int f) { return static_cast<std::size_t>(f); }
  std::size_t faces() const { return at(m_mesh.size_of_faces()); }

  Eigen::Vector3d middle(int f) const
  {
    const auto& c = m_mesh.corners(f);
    return (m_mesh.position(c[0]) + m_mesh.position(c[1]) + m_mesh.position(c[2])) / 3;
  }

  void enter(int f, double distance)
  {
    m_distance[at(f)] = distance;
    m_region[at(f)] = m_count - 1;
    m_queue.emplace(-distance, f);
  }

  const CGP::Mesh_view& m_mesh;
  std::vector<int> m_region;
  std::vector<double> m_distance;
  std::priority_queue<std::pair<double, int>> m_queue;  // nearest first: minus the distance
  int m_count = 0;
};

}  // namespace

std::vector<int> face_regions(const CGP::Mesh_view& mesh, int count)
{
  Region_growth growth(mesh);
  growth.add_seed(0);
  while (growth.count() < count || !growth.has_reached_all())
    growth.add_seed(growth.farthest_face());
  return std::move(growth).regions();
}

}  // namespace conformal
