// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
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

Delaunay_view::Delaunay_view(const Mesh_view& mesh, double mollification,
                             const Eigen::MatrixXd& forms)
    : m_positions(mesh.positions()),
      m_size_of_faces(mesh.size_of_faces()),
      m_loops(Conformal_geometry_processing::boundary_loops(mesh))
{
  assert(forms.cols() == 0 || forms.rows() == mesh.size_of_edges());
  const internal::Mollified_lengths mollified = mollified_lengths(mesh, mollification);
  m_thin_faces = mollified.thin_faces;
  m_added_length = mollified.added;
  internal::Intrinsic_triangulation triangles(mesh, mollified.lengths);
  internal::Common_subdivision subdivision(mesh, triangles);
  internal::Transported_forms transported(mesh, forms);
  m_flips = flip_to_delaunay(triangles, [&](int h) {
    subdivision.before_flip(triangles, h);
    transported.before_flip(triangles, h);
  });
  const std::vector<int> caps = boundary_caps(triangles);
  const std::vector<int> edges = number_edges(triangles, caps, transported);
  for (int t = 0; t < triangles.size_of_faces(); ++t)
    add_face(triangles, t, caps[index(t)], edges, subdivision.pieces(t));
}

std::vector<int> Delaunay_view::number_edges(const internal::Intrinsic_triangulation& triangles,
                                             const std::vector<int>& caps,
                                             const internal::Transported_forms& forms)
{
  std::vector<int> edges(index(triangles.size_of_halfedges()), -1), halfedges;
  for (int h = 0; h < triangles.size_of_halfedges(); ++h) {
    const int twin = triangles.twin(h);
    const bool is_gone = twin < 0 && caps[index(h / 3)] == h;
    if (h < twin || is_gone) continue;
    const int i = triangles.from(h), j = triangles.to(h);
    edges[index(h)] = size_of_edges();
    if (twin >= 0) edges[index(twin)] = size_of_edges();
    m_ends.push_back({(std::min)(i, j), (std::max)(i, j)});
    halfedges.push_back(h);
  }
  m_forms.resize(size_of_edges(), forms.size());
  for (int k = 0; k < size_of_edges(); ++k) {
    const int h = halfedges[index(k)];
    m_forms.row(k) = (triangles.from(h) < triangles.to(h) ? 1 : -1) * forms.along(h);
  }
  return edges;
}

// The halves of a cap share its height, which joins the apex with itself and has no number. Both
// other edges of a half are the side of the cap, because the foot of the height is also the apex.
void Delaunay_view::add_face(const internal::Intrinsic_triangulation& triangles, int t, int cap,
                             const std::vector<int>& edges,
                             const std::vector<internal::Common_subdivision::Piece>& pieces)
{
  Eigen::Matrix<double, 2, 3> p;
  p << triangles.apex_in_plane(3 * t), Eigen::Vector2d::Zero(),
      Eigen::Vector2d(triangles.length(3 * t), 0);
  Sheet whole{};
  whole.vectors.setZero();  // the vectors of a sheet depend on its face
  for (int c = 0; c < 3; ++c) {
    whole.corners[index(c)] = triangles.apex(3 * t + c);
    whole.edges[index(c)] = edges[index(3 * t + c)];
  }
  whole.area = triangles.area(t);
  if (cap < 0) return add_triangle(whole, p, pieces);
  const int c = cap % 3, a = (c + 1) % 3, b = (c + 2) % 3;
  const int apex = whole.corners[index(c)], left_side = whole.edges[index(b)],
            right_side = whole.edges[index(a)];
  const Eigen::Vector2d tip = triangles.apex_in_plane(cap),
                        direction = (p.col(b) - p.col(a)).normalized(),
                        foot = p.col(a) + tip.x() * direction;
  Eigen::Matrix<double, 2, 3> left, right;
  left << p.col(a), foot, p.col(c);
  right << foot, p.col(b), p.col(c);
  Sheet half = whole;
  half.corners = {whole.corners[index(a)], apex, apex};
  half.edges = {-1, left_side, left_side};
  half.area = tip.x() * tip.y() / 2;
  add_triangle(half, left, pieces);
  half.corners = {apex, whole.corners[index(b)], apex};
  half.edges = {right_side, -1, right_side};
  half.area = (triangles.length(cap) - tip.x()) * tip.y() / 2;
  add_triangle(half, right, pieces);
}

void Delaunay_view::add_triangle(Sheet triangle, const Eigen::Matrix<double, 2, 3>& p,
                                 const std::vector<internal::Common_subdivision::Piece>& pieces)
{
  triangle.triangle = size_of_triangles();
  Eigen::Matrix<double, 2, 3> edges;
  edges << p.col(2) - p.col(1), p.col(0) - p.col(2), p.col(1) - p.col(0);
  double total = 0;
  for (const auto& piece : pieces) total += piece.weight;
  for (const auto& piece : pieces) {
    triangle.face = piece.face;
    triangle.share = piece.weight / total;
    triangle.vectors = piece.to_space * edges;
    m_sheets.push_back(triangle);
  }
}

}  // namespace Conformal_geometry_processing
