// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MESH_DELAUNAY_VIEW_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_MESH_DELAUNAY_VIEW_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/mesh/Delaunay_view.h>
#include <Conformal_geometry_processing/mesh/boundary_caps.h>
#include <Conformal_geometry_processing/mesh/intrinsic_delaunay.h>
#include <Conformal_geometry_processing/mesh/mollified_lengths.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {

CGP_INLINE Delaunay_view::Delaunay_view(const Mesh_view& mesh, double mollification,
                                        const Eigen::MatrixXd& forms)
    : m_positions(mesh.positions()),
      m_size_of_faces(mesh.size_of_faces()),
      m_loops(Conformal_geometry_processing::boundary_loops(mesh))
{
  assert(forms.cols() == 0 || forms.rows() == mesh.size_of_edges());
  const Mollified_lengths mollified = mollified_lengths(mesh, mollification);
  m_thin_faces = mollified.thin_faces;
  m_added_length = mollified.added;
  Intrinsic_triangulation triangles(mesh, mollified.lengths);
  Common_subdivision subdivision(mesh, triangles);
  Transported_forms transported(mesh, forms);
  m_flips = flip_to_delaunay(triangles, [&](int h) {
    subdivision.before_flip(triangles, h);
    transported.before_flip(triangles, h);
  });
  const std::vector<int> caps = boundary_caps(triangles);
  for (int t = 0; t < triangles.size_of_faces(); ++t)
    add_face(triangles, t, caps[index(t)], subdivision.pieces(t));
  add_edges(triangles, caps, transported);
}

CGP_INLINE void Delaunay_view::add_face(const Intrinsic_triangulation& triangles, int t, int cap,
                                        const std::vector<Common_subdivision::Piece>& pieces)
{
  Eigen::Matrix<double, 2, 3> p;
  p << triangles.apex_in_plane(3 * t), Eigen::Vector2d::Zero(),
      Eigen::Vector2d(triangles.length(3 * t), 0);
  const std::array<int, 3> v = {triangles.apex(3 * t), triangles.apex(3 * t + 1),
                                triangles.apex(3 * t + 2)};
  if (cap < 0) {
    const Eigen::Vector3d cotangents(triangles.cotangent(3 * t), triangles.cotangent(3 * t + 1),
                                     triangles.cotangent(3 * t + 2));
    return add_triangle(v, p, triangles.area(t), cotangents, pieces);
  }
  const int c = cap % 3, a = (c + 1) % 3, b = (c + 2) % 3;
  const Eigen::Vector2d apex = triangles.apex_in_plane(cap),
                        direction = (p.col(b) - p.col(a)).normalized(),
                        foot = p.col(a) + apex.x() * direction;
  const double x = apex.x(), y = apex.y(), rest = triangles.length(cap) - x;
  Eigen::Matrix<double, 2, 3> left, right;
  left << p.col(a), foot, p.col(c);
  right << foot, p.col(b), p.col(c);
  add_triangle({v[index(a)], v[index(c)], v[index(c)]}, left, x * y / 2, {x / y, 0, y / x}, pieces);
  add_triangle({v[index(c)], v[index(b)], v[index(c)]}, right, rest * y / 2,
               {0, rest / y, y / rest}, pieces);
}

CGP_INLINE void Delaunay_view::add_triangle(const std::array<int, 3>& corners,
                                            const Eigen::Matrix<double, 2, 3>& p, double area,
                                            const Eigen::Vector3d& cotangents,
                                            const std::vector<Common_subdivision::Piece>& pieces)
{
  const int t = size_of_triangles();
  m_corners.push_back(corners);
  m_areas.push_back(area);
  m_cotangents.insert(m_cotangents.end(), cotangents.begin(), cotangents.end());
  Eigen::Matrix<double, 2, 3> edges;
  edges << p.col(2) - p.col(1), p.col(0) - p.col(2), p.col(1) - p.col(0);
  double total = 0;
  for (const auto& piece : pieces) total += piece.weight;
  for (const auto& piece : pieces)
    m_sheets.push_back({t, piece.face, piece.weight / total, piece.to_space * edges});
}

CGP_INLINE double Delaunay_view::half_weight(const Intrinsic_triangulation& triangles, int h,
                                             int cap)
{
  if (cap < 0) return triangles.cotangent(h) / 2;
  if (h == cap) return 0;
  const Eigen::Vector2d apex = triangles.apex_in_plane(cap);
  const bool is_left = h == Mesh_view::previous_in_face(cap);  // from the apex to `from(cap)`
  return apex.y() / (is_left ? apex.x() : triangles.length(cap) - apex.x()) / 2;
}

CGP_INLINE void Delaunay_view::add_edges(const Intrinsic_triangulation& triangles,
                                         const std::vector<int>& caps,
                                         const Transported_forms& forms)
{
  std::vector<int> halfedges;
  for (int h = 0; h < triangles.size_of_halfedges(); ++h) {
    const bool is_gone = triangles.twin(h) < 0 && caps[index(h / 3)] == h;
    if (h > triangles.twin(h) && !is_gone) halfedges.push_back(h);
  }
  const auto size = static_cast<Eigen::Index>(halfedges.size());
  m_weights.resize(size);
  m_forms.resize(size, forms.size());
  for (Eigen::Index k = 0; k < size; ++k) {
    const int h = halfedges[static_cast<std::size_t>(k)], t = triangles.twin(h);
    const int i = triangles.from(h), j = triangles.to(h);
    m_ends.push_back({(std::min)(i, j), (std::max)(i, j)});
    m_weights[k] = half_weight(triangles, h, caps[index(h / 3)]) +
                   (t < 0 ? 0 : half_weight(triangles, t, caps[index(t / 3)]));
    m_forms.row(k) = (i < j ? 1 : -1) * forms.along(h);
  }
}

}  // namespace Conformal_geometry_processing

#endif
