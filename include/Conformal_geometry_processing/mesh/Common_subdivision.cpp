// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Common_subdivision.h>

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/mesh/requirements.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

internal::Common_subdivision::Common_subdivision(const Mesh_view& mesh,
                                                 const internal::Intrinsic_triangulation& triangles)
    : m_pieces(static_cast<std::size_t>(mesh.size_of_faces()))
{
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    add_face(mesh, triangles, f);
    m_size += pieces(f).size();
  }
}

const std::vector<internal::Common_subdivision::Piece>& internal::Common_subdivision::pieces(
    int face) const
{
  return m_pieces[static_cast<std::size_t>(face)];
}

void internal::Common_subdivision::before_flip(const internal::Intrinsic_triangulation& triangles,
                                               int h)
{
  const int t = triangles.twin(h);
  const Eigen::Vector2d i(0, 0), j(triangles.length(h), 0), k = triangles.apex_in_plane(h),
                                                            l = j - triangles.apex_in_plane(t);
  std::vector<Piece>&a = m_pieces[static_cast<std::size_t>(h / 3)],
  &b = m_pieces[static_cast<std::size_t>(t / 3)];
  std::vector<Piece> all = std::move(a);
  move(all, halfedge_in_plane(triangles, h), {i, {1, 0}});
  move(b, halfedge_in_plane(triangles, t), {j, {-1, 0}});
  all.insert(all.end(), std::make_move_iterator(b.begin()), std::make_move_iterator(b.end()));
  a = left_of(all, l, k);  // (k, i, l)
  b = left_of(all, k, l);  // (l, j, k)
  m_size += a.size() + b.size() - all.size();
  if (m_size > most_pieces_per_face * m_pieces.size()) refuse(triangles, h);
  move(a, {i, (l - i).normalized()}, {{0, 0}, {1, 0}});
  move(b, {j, (k - j).normalized()}, {{0, 0}, {1, 0}});
}

void internal::Common_subdivision::refuse(const internal::Intrinsic_triangulation& triangles,
                                          int h) const
{
  throw Precondition_error("Delaunay_view",
                           "the faces are too thin to be mollified: " + std::to_string(m_size) +
                               " pieces of faces in " + std::to_string(m_pieces.size()) +
                               " triangles, at most " + std::to_string(most_pieces_per_face) +
                               " each are allowed (the last one is at the vertices " +
                               std::to_string(triangles.from(h)) + " and " +
                               std::to_string(triangles.to(h)) + "); try: a mesh without needles");
}

Eigen::Matrix2d internal::Common_subdivision::Frame::rotation() const
{
  Eigen::Matrix2d R;
  R << direction, Eigen::Vector2d(-direction.y(), direction.x());
  return R;
}

internal::Common_subdivision::Frame internal::Common_subdivision::halfedge_in_plane(
    const internal::Intrinsic_triangulation& triangles, int h)
{
  const int first = h - h % 3;
  const Eigen::Vector2d corners[] = {
      triangles.apex_in_plane(first), {0, 0}, {triangles.length(first), 0}};
  const Eigen::Vector2d from = corners[(h + 1) % 3], to = corners[(h + 2) % 3];
  return {from, (to - from).normalized()};
}

void internal::Common_subdivision::move(std::vector<Piece>& pieces, const Frame& from,
                                        const Frame& to)
{
  const Eigen::Matrix2d R = to.rotation() * from.rotation().transpose();
  for (Piece& piece : pieces) {
    for (Eigen::Vector2d& p : piece.polygon) p = to.origin + R * (p - from.origin);
    piece.to_space *= R.transpose();
  }
}

double internal::Common_subdivision::cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

double internal::Common_subdivision::area(const std::vector<Eigen::Vector2d>& polygon)
{
  double twice = 0;
  for (std::size_t s = 2; s < polygon.size(); ++s)
    twice += cross(polygon[s - 1] - polygon[0], polygon[s] - polygon[0]);
  return (std::max)(twice / 2, 0.);
}

std::vector<Eigen::Vector2d> internal::Common_subdivision::left_of(
    const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& p, const Eigen::Vector2d& q)
{
  std::vector<Eigen::Vector2d> left;
  for (std::size_t s = 0; s < polygon.size(); ++s) {
    const Eigen::Vector2d &x = polygon[s], &y = polygon[(s + 1) % polygon.size()];
    const double at_x = cross(q - p, x - p), at_y = cross(q - p, y - p);
    if (at_x >= 0) left.push_back(x);
    if ((at_x > 0 && at_y < 0) || (at_x < 0 && at_y > 0))
      left.push_back(x + at_x / (at_x - at_y) * (y - x));
  }
  return left;
}

std::vector<internal::Common_subdivision::Piece> internal::Common_subdivision::left_of(
    const std::vector<Piece>& pieces, const Eigen::Vector2d& p, const Eigen::Vector2d& q)
{
  std::vector<Piece> left;
  std::vector<double> areas;
  double total = 0;
  for (const Piece& piece : pieces) {
    std::vector<Eigen::Vector2d> polygon = left_of(piece.polygon, p, q);
    areas.push_back(area(polygon));
    total += areas.back();
    const double share = areas.back() / area(piece.polygon);
    left.push_back({std::move(polygon), share * piece.weight, piece.face, piece.to_space});
  }
  const double splinter = 1e-12 * total;
  std::size_t kept = 0;
  for (std::size_t s = 0; s < left.size(); ++s)
    if (areas[s] > splinter) std::swap(left[kept++], left[s]);
  left.resize(kept);
  return left;
}

// The longest edge determines the direction. A face of area zero has no normal; it is replaced by
// two of half the weight, one on each side of the edge, so that only the edge has an effect.
void internal::Common_subdivision::add_face(const Mesh_view& mesh,
                                            const internal::Intrinsic_triangulation& triangles,
                                            int f)
{
  int longest = 3 * f;
  for (int h = 3 * f; h < 3 * f + 3; ++h)
    if (triangles.length(h) > triangles.length(longest)) longest = h;
  const std::vector<Eigen::Vector2d> polygon = {
      {0, 0}, {triangles.length(3 * f), 0}, triangles.apex_in_plane(3 * f)};
  const double length = triangles.length(longest),
               negligible = relative_area_tolerance * length * length;
  const Eigen::Vector3d double_area = mesh.double_area_vector(f);
  const bool has_normal = !has_area_zero(mesh, f);
  Eigen::Vector3d edge = mesh.vector(longest).stableNormalized();
  if (!(edge.norm() > .5)) edge = Eigen::Vector3d::UnitX();  // the three points coincide
  const Eigen::Vector3d normal = (has_normal ? double_area : edge.unitOrthogonal()).normalized();
  const Eigen::Matrix2d turn = halfedge_in_plane(triangles, longest).rotation().transpose();
  for (const double side : {1., -1.}) {
    Eigen::Matrix<double, 3, 2> axes;
    axes << edge, side * normal.cross(edge);
    const double weight = has_normal ? double_area.norm() / 2 : negligible / 2;
    m_pieces[static_cast<std::size_t>(f)].push_back({polygon, weight, f, axes * turn});
    if (has_normal) break;
  }
}

}  // namespace Conformal_geometry_processing
