// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <numeric>
#include <string>

namespace Conformal_geometry_processing {

Mesh_view::Mesh_view(Points positions, Corners corners)
    : m_positions(std::move(positions)),
      m_connectivity(std::make_shared<const internal::Mesh_connectivity>(std::move(corners),
                                                                         size_of_vertices()))
{
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
  m_areas.resize(corners().size());
  for (int f = 0; f < size_of_faces(); ++f)
    m_areas[index(f)] = stable_norm(double_area_vector(f)) / 2;
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

namespace internal {

Mesh_connectivity::Mesh_connectivity(Corners faces, int size_of_vertices)
    : corners(std::move(faces))
{
  check_corners(size_of_vertices);
  sort_halfedges(size_of_vertices);
  number_edges();
  pair_halfedges();
}

// Everything below reads and writes arrays at these indices.
void Mesh_connectivity::check_corners(int size_of_vertices) const
{
  if (corners.size() > index((std::numeric_limits<int>::max)() / 3))
    throw Precondition_error("Mesh_view", "there are more faces than an int can count halfedges");
  for (std::size_t f = 0; f < corners.size(); ++f)
    for (int v : corners[f])
      if (v < 0 || v >= size_of_vertices)
        throw Precondition_error("Mesh_view", "face " + std::to_string(f) + " has the corner " +
                                                  std::to_string(v) + "; vertices are 0 to " +
                                                  std::to_string(size_of_vertices - 1));
}

// Buckets the halfedges by their lower end and sorts each bucket by the higher end. This needs no
// hash map, and the numbering depends only on the faces.
void Mesh_connectivity::sort_halfedges(int size_of_vertices)
{
  const int count = static_cast<int>(3 * corners.size());
  std::vector<int> bucket(index(size_of_vertices) + 1, 0);
  for (int h = 0; h < count; ++h) ++bucket[index(low(h)) + 1];
  std::partial_sum(bucket.begin(), bucket.end(), bucket.begin());
  halfedges.resize(index(count));
  std::vector<int> slot(bucket.begin(), bucket.end() - 1);
  for (int h = 0; h < count; ++h) halfedges[index(slot[index(low(h))]++)] = h;
  for (int v = 0; v < size_of_vertices; ++v)
    std::sort(halfedges.begin() + bucket[index(v)], halfedges.begin() + bucket[index(v) + 1],
              [this](int g, int h) { return std::pair(high(g), g) < std::pair(high(h), h); });
}

void Mesh_connectivity::number_edges()
{
  edges.resize(halfedges.size());
  ends.reserve(halfedges.size() / 2);
  first.reserve(halfedges.size() / 2 + 1);
  for (std::size_t k = 0; k < halfedges.size(); ++k) {
    const int h = halfedges[k];
    const std::array<int, 2> own{low(h), high(h)};
    if (ends.empty() || ends.back() != own) {
      first.push_back(static_cast<int>(k));
      ends.push_back(own);
    }
    edges[index(h)] = static_cast<int>(ends.size()) - 1;
  }
  first.push_back(static_cast<int>(halfedges.size()));
}

void Mesh_connectivity::pair_halfedges()
{
  twins.assign(halfedges.size(), -1);
  for (std::size_t k = 0; k < ends.size(); ++k) {
    if (first[k + 1] - first[k] != 2) continue;
    const int g = halfedges[index(first[k])], h = halfedges[index(first[k]) + 1];
    twins[index(g)] = h;
    twins[index(h)] = g;
  }
}

}  // namespace internal

double stable_norm(const Eigen::Vector3d& v)
{
  const double squared = v.squaredNorm(), least = 1e-280, most = 1e280;
  if (least < squared && squared < most) return std::sqrt(squared);
  return std::hypot(v.x(), v.y(), v.z());  // five times as slow
}

Eigen::Vector3d stable_normalized(const Eigen::Vector3d& v)
{
  const double largest = v.cwiseAbs().maxCoeff();
  return largest > 0 ? Eigen::Vector3d((v / largest).normalized()) : v;
}

}  // namespace Conformal_geometry_processing
