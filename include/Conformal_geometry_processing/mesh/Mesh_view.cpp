// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Quaternionic_linear_algebra/algebra/stable_norm.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Geometry>

#include <limits>
#include <numeric>
#include <string>

namespace Conformal_geometry_processing {

Mesh_view::Mesh_view(Points positions, Corners corners)
    : m_positions(std::move(positions)), m_corners(std::move(corners))
{
  check_corners();
  find_edges();
  measure_areas();
}

void Mesh_view::set_positions(Points positions)
{
  if (positions.cols() != m_positions.cols())
    throw Precondition_error("Mesh_view::set_positions",
                             std::to_string(positions.cols()) + " positions for " +
                                 std::to_string(m_positions.cols()) + " vertices");
  m_positions = std::move(positions);
  measure_areas();
}

void Mesh_view::measure_areas()
{
  m_areas.resize(m_corners.size());
  for (int f = 0; f < size_of_faces(); ++f)
    m_areas[index(f)] = stable_norm(double_area_vector(f)) / 2;
}

// Everything below reads and writes arrays at these indices.
void Mesh_view::check_corners() const
{
  if (m_corners.size() > index((std::numeric_limits<int>::max)() / 3))
    throw Precondition_error("Mesh_view", "there are more faces than an int can count halfedges");
  for (std::size_t f = 0; f < m_corners.size(); ++f)
    for (int v : m_corners[f])
      if (v < 0 || v >= size_of_vertices())
        throw Precondition_error("Mesh_view", "face " + std::to_string(f) + " has the corner " +
                                                  std::to_string(v) + "; vertices are 0 to " +
                                                  std::to_string(size_of_vertices() - 1));
}

Eigen::Vector3d Mesh_view::double_area_vector(int f, const Points& positions) const
{
  const std::array<int, 3>& v = corners(f);
  const Eigen::Vector3d p = positions.col(v[2]);
  return (p - positions.col(v[1])).cross(positions.col(v[0]) - p);
}

Sheet Mesh_view::sheet(int f) const
{
  Sheet sheet;
  sheet.corners = corners(f);
  sheet.edges = {edge(3 * f), edge(3 * f + 1), edge(3 * f + 2)};
  sheet.triangle = sheet.face = f;
  const Eigen::Vector3d p = position(sheet.corners[0]), q = position(sheet.corners[1]),
                        r = position(sheet.corners[2]);
  sheet.vectors << r - q, p - r, q - p;
  sheet.area = m_areas[index(f)];
  sheet.share = 1;
  return sheet;
}

// Buckets the halfedges by their lower end and sorts each bucket by the higher end. This needs no
// hash map, and the numbering depends only on the faces.
void Mesh_view::find_edges()
{
  std::vector<int> bucket(index(size_of_vertices()) + 1, 0);
  for (int h = 0; h < size_of_halfedges(); ++h) ++bucket[index(low(h)) + 1];
  std::partial_sum(bucket.begin(), bucket.end(), bucket.begin());
  m_halfedges.resize(index(size_of_halfedges()));
  std::vector<int> slot(bucket.begin(), bucket.end() - 1);
  for (int h = 0; h < size_of_halfedges(); ++h) m_halfedges[index(slot[index(low(h))]++)] = h;
  for (int v = 0; v < size_of_vertices(); ++v)
    std::sort(m_halfedges.begin() + bucket[index(v)], m_halfedges.begin() + bucket[index(v) + 1],
              [this](int g, int h) { return std::pair(high(g), g) < std::pair(high(h), h); });
  number_edges();
  pair_halfedges();
}

void Mesh_view::number_edges()
{
  m_edges.resize(m_halfedges.size());
  m_ends.reserve(m_halfedges.size() / 2);
  m_first.reserve(m_halfedges.size() / 2 + 1);
  for (int k = 0; k < size_of_halfedges(); ++k) {
    const int h = m_halfedges[index(k)];
    const int i = low(h), j = high(h);
    if (m_ends.empty() || m_ends.back()[0] != i || m_ends.back()[1] != j) {
      m_first.push_back(k);
      m_ends.push_back({i, j});
    }
    m_edges[index(h)] = size_of_edges() - 1;
  }
  m_first.push_back(size_of_halfedges());
}

void Mesh_view::pair_halfedges()
{
  m_twins.assign(m_halfedges.size(), -1);
  for (int k = 0; k < size_of_edges(); ++k) {
    if (halfedges_end(k) - halfedges_begin(k) != 2) continue;
    const int g = halfedges_begin(k)[0], h = halfedges_begin(k)[1];
    m_twins[index(g)] = h;
    m_twins[index(h)] = g;
  }
}

}  // namespace Conformal_geometry_processing
