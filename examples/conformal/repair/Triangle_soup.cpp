// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Triangle_soup.h"

#include "triangulation.h"

#include "conformal/process/at.h"

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace conformal {
namespace {

/// whether two corners have the same values, or both none
bool is_same_row(const Corner_values& values, int i, int j)
{
  if (i < 0 || j < 0) return i < 0 && j < 0;
  return i == j ||
         values.values[static_cast<std::size_t>(i)] == values.values[static_cast<std::size_t>(j)];
}

/// Adds the row (1 - s) times row i plus s times row j.
/// \returns its number, -1 if either is missing
int append_between(Corner_values& values, int i, int j, double s)
{
  if (i < 0 || j < 0) return -1;
  const auto row = [&](int k) {
    return Eigen::Vector3d::Map(values.values[static_cast<std::size_t>(k)].data());
  };
  const Eigen::Vector3d between = (1 - s) * row(i) + s * row(j);
  values.values.push_back({between.x(), between.y(), between.z()});
  return static_cast<int>(values.values.size()) - 1;
}

/// where the foot of the perpendicular from c on the line ab is: 0 at a, 1 at b, not beyond
double share_along(const Point& a, const Point& b, const Point& c)
{
  const Eigen::Vector3d p = Eigen::Vector3d::Map(a.data()),
                        edge = Eigen::Vector3d::Map(b.data()) - p;
  const double length = edge.stableNorm();
  if (!(length > 0)) return 0;
  return std::clamp((Eigen::Vector3d::Map(c.data()) - p).dot(edge / length) / length, 0., 1.);
}

int row(const Corner_values& values, std::size_t corner)
{
  return values.index.empty() ? -1 : values.index[corner];
}

}  // namespace

Triangle_soup::Triangle_soup(Surface_file& file)
    : m_file(file), m_around(file.points.size()), m_is_changed(file.polygons.size(), 0)
{
  const Triangulation all = triangulate(file);
  m_triangles.reserve(all.corners.size());
  for (std::size_t t = 0; t < all.corners.size(); ++t) {
    Triangle triangle{{}, all.face_in_file[t], true};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t place = all.places[t][k];
      triangle.corners[k] = {all.corners[t][k], row(file.texture, place), row(file.normals, place)};
      m_around[at(all.corners[t][k])].push_back(static_cast<int>(t));
    }
    m_triangles.push_back(triangle);
  }
}

int Triangle_soup::corner_at(int t, int v) const
{
  for (int k = 0; k < 3; ++k)
    if (vertex(t, k) == v) return k;
  return -1;
}

std::vector<int> Triangle_soup::around(int v, int w) const
{
  if (around(w).size() < around(v).size()) std::swap(v, w);  // one may be the hub of a large fan
  std::vector<int> both;
  for (const int t : around(v))
    if (corner_at(t, w) >= 0) both.push_back(t);
  return both;
}

int Triangle_soup::find(const std::array<int, 3>& v) const
{
  for (const int t : around(v[0], v[1]))
    if (opposite(t, v[0], v[1]) == v[2]) return t;
  return -1;
}

int Triangle_soup::neighbor(int t, int k) const
{
  const int a = vertex(t, k + 1), b = vertex(t, k + 2);
  const std::vector<int> both = around(a, b);
  if (both.size() != 2) return -1;
  const int g = both[0] == t ? both[1] : both[0];
  return vertex(g, corner_at(g, b) + 1) == a ? g : -1;
}

int Triangle_soup::opposite(int t, int v, int w) const
{
  int k = 0;
  while (vertex(t, k) == v || vertex(t, k) == w) ++k;
  return vertex(t, k);
}

void Triangle_soup::leave(int t)
{
  for (const Corner& c : (*this)[t].corners) {
    std::vector<int>& around = m_around[at(c.vertex)];
    around.erase(std::find(around.begin(), around.end(), t));
  }
}

void Triangle_soup::remove(int t)
{
  mark_changed(t);
  leave(t);
  triangle(t).is_alive = false;
}

void Triangle_soup::replace(int t, const Triangle& by)
{
  mark_changed(t);
  leave(t);
  triangle(t) = by;
  mark_changed(t);
  for (const Corner& c : by.corners) m_around[at(c.vertex)].push_back(t);
}

void Triangle_soup::flip(int t, int k, int g)
{
  const auto corner = [&](int f, int v) { return (*this)[f].corners[at(corner_at(f, v))]; };
  const int a = vertex(t, k + 1), b = vertex(t, k + 2);
  const Corner own_a = corner(t, a), own_b = corner(t, b);
  const Corner at_a = corner(g, a), at_b = corner(g, b), at_d = corner(g, opposite(g, a, b));
  Corner at_c = (*this)[t].corners[at(k % 3)];
  const double s = share_along(point(a), point(b), point(at_c.vertex));
  Corner_values &uv = m_file.texture, &normals = m_file.normals;
  if (!is_same_row(uv, own_a.texture, at_a.texture) ||
      !is_same_row(uv, own_b.texture, at_b.texture))
    at_c.texture = append_between(uv, at_a.texture, at_b.texture, s);
  if (!is_same_row(normals, own_a.normal, at_a.normal) ||
      !is_same_row(normals, own_b.normal, at_b.normal))
    at_c.normal = append_between(normals, at_a.normal, at_b.normal, s);
  const int face = (*this)[g].face;
  replace(t, {{at_c, at_a, at_d}, face, true});
  replace(g, {{at_d, at_b, at_c}, face, true});
}

Triangle_soup::Corner Triangle_soup::moved(const Corner& corner, int w,
                                           const std::vector<int>& between) const
{
  Corner result{w, corner.texture, corner.normal};
  for (const int t : between) {
    const Corner& from = (*this)[t].corners[at(corner_at(t, corner.vertex))];
    const Corner& to = (*this)[t].corners[at(corner_at(t, w))];
    if (is_same_row(m_file.texture, from.texture, corner.texture)) result.texture = to.texture;
    if (is_same_row(m_file.normals, from.normal, corner.normal)) result.normal = to.normal;
  }
  return result;
}

void Triangle_soup::collapse(int v, int w)
{
  const std::vector<int> between = around(v, w), all = around(v);
  for (const int t : all) {
    if (corner_at(t, w) >= 0) continue;
    Triangle changed = (*this)[t];
    Corner& corner = changed.corners[at(corner_at(t, v))];
    corner = moved(corner, w, between);
    const auto& c = changed.corners;
    if (find({c[0].vertex, c[1].vertex, c[2].vertex}) >= 0)
      remove(t);
    else
      replace(t, changed);
  }
  for (const int t : between) remove(t);
}

Selected_faces Triangle_soup::faces() const
{
  std::vector<std::vector<int>> parts(m_is_changed.size());
  for (int t = 0; t < size(); ++t)
    if ((*this)[t].is_alive) parts[at((*this)[t].face)].push_back(t);
  Selected_faces faces;
  for (std::size_t f = 0; f < parts.size(); ++f) {
    if (!m_is_changed[f]) {
      std::vector<std::size_t> places;
      for (std::size_t c = m_file.polygons.first[f]; c < m_file.polygons.first[f + 1]; ++c)
        places.push_back(c);
      append(faces, m_file, static_cast<int>(f), places);
      continue;
    }
    for (const int t : parts[f]) {
      for (const Corner& c : (*this)[t].corners) {
        faces.polygons.corners.push_back(c.vertex);
        if (!m_file.texture.index.empty()) faces.texture.push_back(c.texture);
        if (!m_file.normals.index.empty()) faces.normals.push_back(c.normal);
      }
      faces.polygons.first.push_back(faces.polygons.corners.size());
      faces.face_in_file.push_back(static_cast<int>(f));
    }
  }
  return faces;
}

}  // namespace conformal
