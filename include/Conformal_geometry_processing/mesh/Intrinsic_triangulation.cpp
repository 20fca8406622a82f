// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Intrinsic_triangulation.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Conformal_geometry_processing {

Eigen::VectorXd edge_lengths(const Mesh_view& mesh)
{
  Eigen::VectorXd lengths(mesh.size_of_edges());
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    lengths[k] = (mesh.position(mesh.ends(k)[1]) - mesh.position(mesh.ends(k)[0])).stableNorm();
  return lengths;
}

internal::Mollified_lengths mollified_lengths(const Mesh_view& mesh, double share)
{
  internal::Mollified_lengths result;
  result.lengths = edge_lengths(mesh);
  const double slack = share * result.lengths.mean();
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    Eigen::Vector3d l;
    for (int c = 0; c < 3; ++c) l[c] = result.lengths[mesh.edge(3 * f + c)];
    const double missing = slack + 2 * l.maxCoeff() - l.sum();
    result.thin_faces += missing > 0;
    result.added = (std::max)(result.added, missing);
  }
  result.lengths.array() += result.added;
  return result;
}

internal::Intrinsic_triangulation::Intrinsic_triangulation(const Mesh_view& mesh,
                                                           const Eigen::VectorXd& lengths)
    : m_corners(index(mesh.size_of_halfedges())),
      m_twins(index(mesh.size_of_halfedges())),
      m_lengths(index(mesh.size_of_halfedges()))
{
  for (int h = 0; h < mesh.size_of_halfedges(); ++h) {
    m_corners[index(h)] = mesh.corners(h / 3)[index(h % 3)];
    m_twins[index(h)] = mesh.twin(h);
    m_lengths[index(h)] = lengths[mesh.edge(h)];
  }
}

double internal::Intrinsic_triangulation::area(int f) const
{
  std::array<double, 3> l = {length(3 * f), length(3 * f + 1), length(3 * f + 2)};
  std::sort(l.begin(), l.end());
  const auto [c, b, a] = l;
  // Of two products, for one of four lengths would overflow or underflow.
  return std::sqrt((a + (b + c)) * (a + (b - c))) *
         std::sqrt((std::max)((c - (a - b)) * (c + (a - b)), 0.)) / 4;
}

Eigen::Vector2d internal::Intrinsic_triangulation::apex_in_plane(int h) const
{
  const double l = length(h), a = length(Mesh_view::next_in_face(h)),
               b = length(Mesh_view::previous_in_face(h));
  return {(l + (b - a) * (b + a) / l) / 2, 2 * area(h / 3) / l};
}

double internal::Intrinsic_triangulation::angle(int h) const
{
  const double l = length(h), a = length(Mesh_view::next_in_face(h)),
               b = length(Mesh_view::previous_in_face(h));
  return std::atan2(4 * area(h / 3), a * a + (b - l) * (b + l));
}

double internal::Intrinsic_triangulation::cotangent(int h) const
{
  const double l = length(h), a = length(Mesh_view::next_in_face(h)),
               b = length(Mesh_view::previous_in_face(h));
  return (a * a + (b - l) * (b + l)) / (4 * area(h / 3));
}

double internal::Intrinsic_triangulation::length_of_flipped(int h) const
{
  const Eigen::Vector2d k = apex_in_plane(h), l = apex_in_plane(twin(h));
  return std::hypot(k.x() - (length(h) - l.x()), k.y() + l.y());
}

void internal::Intrinsic_triangulation::flip(int h)
{
  const int t = twin(h), a = h / 3, b = t / 3;
  const double diagonal = length_of_flipped(h);
  const int i = from(h), j = to(h), k = apex(h), l = apex(t);
  // the four sides: i l, k i of the new face a, and j k, l j of the new face b
  const std::array<int, 4> before = {Mesh_view::next_in_face(t), Mesh_view::previous_in_face(h),
                                     Mesh_view::next_in_face(h), Mesh_view::previous_in_face(t)};
  const std::array<int, 4> after = {3 * a, 3 * a + 2, 3 * b, 3 * b + 2};
  std::array<int, 4> twins;
  std::array<double, 4> lengths;
  for (std::size_t s = 0; s < 4; ++s) {
    const auto side = std::find(before.begin(), before.end(), twin(before[s]));  // glued together
    twins[s] = side == before.end() ? twin(before[s])
                                    : after[static_cast<std::size_t>(side - before.begin())];
    lengths[s] = length(before[s]);
  }
  for (std::size_t s = 0; s < 4; ++s) glue(after[s], twins[s], lengths[s]);
  glue(3 * a + 1, 3 * b + 1, diagonal);
  m_lengths[index(3 * b + 1)] = diagonal;
  const std::array<int, 3> at_a = {k, i, l}, at_b = {l, j, k};
  std::copy(at_a.begin(), at_a.end(), m_corners.begin() + 3 * a);
  std::copy(at_b.begin(), at_b.end(), m_corners.begin() + 3 * b);
}

void internal::Intrinsic_triangulation::glue(int h, int twin, double length)
{
  m_lengths[index(h)] = length;
  m_twins[index(h)] = twin;
  if (twin >= 0) m_twins[index(twin)] = h;
}

bool is_delaunay(const internal::Intrinsic_triangulation& triangles, int h)
{
  const double pi = std::acos(-1.), tolerance = 1e-10;
  const int t = triangles.twin(h);
  // Written so that what is not a number is never flipped.
  return t < 0 || !(triangles.angle(h) + triangles.angle(t) > pi + tolerance);
}

int flip_to_delaunay(internal::Intrinsic_triangulation& triangles)
{
  return flip_to_delaunay(triangles, [](int) {});
}

}  // namespace Conformal_geometry_processing
