// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Delaunay_view.h>

#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {

std::vector<int> boundary_caps(const internal::Intrinsic_triangulation& triangles)
{
  const double greatest_angle = 5 * std::acos(-1.) / 6;
  std::vector<int> caps(static_cast<std::size_t>(triangles.size_of_faces()), -1), waiting;
  for (int h = 0; h < triangles.size_of_halfedges(); ++h)
    if (triangles.twin(h) < 0) waiting.push_back(h);
  while (!waiting.empty()) {
    const int h = waiting.back();
    waiting.pop_back();
    int& cap = caps[static_cast<std::size_t>(h / 3)];
    if (cap >= 0 || !(triangles.angle(h) > greatest_angle)) continue;
    cap = h;
    for (const int side : {Mesh_view::next_in_face(h), Mesh_view::previous_in_face(h)})
      if (triangles.twin(side) >= 0) waiting.push_back(triangles.twin(side));
  }
  return caps;
}

internal::Transported_forms::Transported_forms(const Mesh_view& mesh, const Eigen::MatrixXd& forms)
    : m_values(mesh.size_of_halfedges(), forms.cols()), m_sides(4, forms.cols())
{
  for (int h = 0; forms.cols() > 0 && h < mesh.size_of_halfedges(); ++h)
    m_values.row(h) = (mesh.from(h) < mesh.to(h) ? 1 : -1) * forms.row(mesh.edge(h));
}

void internal::Transported_forms::before_flip(const internal::Intrinsic_triangulation& triangles,
                                              int h)
{
  if (size() == 0) return;
  const int t = triangles.twin(h), a = 3 * (h / 3), b = 3 * (t / 3);
  m_sides << along(Mesh_view::next_in_face(h)), along(Mesh_view::previous_in_face(h)),
      along(Mesh_view::next_in_face(t)), along(Mesh_view::previous_in_face(t));
  const auto jk = m_sides.row(0), ki = m_sides.row(1), il = m_sides.row(2), lj = m_sides.row(3);
  // the new faces (k, i, l) and (l, j, k)
  m_values.row(a) = il;
  m_values.row(a + 1) = -(ki + il);
  m_values.row(a + 2) = ki;
  m_values.row(b) = jk;
  m_values.row(b + 1) = ki + il;
  m_values.row(b + 2) = lj;
}

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

namespace internal {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

double area_of(const Plane_polygon& polygon)
{
  double twice = 0;
  for (std::size_t s = 2; s < polygon.size(); ++s)
    twice += cross(polygon[s - 1] - polygon[0], polygon[s] - polygon[0]);
  return (std::max)(twice / 2, 0.);
}

Plane_polygon clipped(const Plane_polygon& polygon, const Eigen::Vector2d& p,
                      const Eigen::Vector2d& q)
{
  Plane_polygon left;
  for (std::size_t s = 0; s < polygon.size(); ++s) {
    const Eigen::Vector2d &x = polygon[s], &y = polygon[(s + 1) % polygon.size()];
    const double at_x = cross(q - p, x - p), at_y = cross(q - p, y - p);
    if (at_x >= 0) left.push_back(x);
    if ((at_x > 0 && at_y < 0) || (at_x < 0 && at_y > 0))
      left.push_back(x + at_x / (at_x - at_y) * (y - x));
  }
  return left;
}

}  // namespace internal

std::vector<internal::Common_subdivision::Piece> internal::Common_subdivision::left_of(
    const std::vector<Piece>& pieces, const Eigen::Vector2d& p, const Eigen::Vector2d& q)
{
  std::vector<Piece> left;
  std::vector<double> areas;
  double total = 0;
  for (const Piece& piece : pieces) {
    Plane_polygon polygon = clipped(piece.polygon, p, q);
    areas.push_back(area_of(polygon));
    total += areas.back();
    const double share = areas.back() / area_of(piece.polygon);
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
  const Plane_polygon polygon = {
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
