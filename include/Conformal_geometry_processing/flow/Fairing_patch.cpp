// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Fairing_patch.h>

#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Conformal_geometry_processing {

internal::Fairing_patch::Fairing_patch(const Mesh_view& mesh, const std::vector<char>& is_in_region,
                                       const std::string& function)
{
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  const std::vector<char> is_free = find_free(mesh, is_in_region);
  std::vector<char> bends = is_free, is_in_patch(is_in_region.size(), 0);
  for (const auto& [i, j] : mesh.ends())
    if (is_free[at(i)] || is_free[at(j)]) bends[at(i)] = bends[at(j)] = 1;
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    for (const int v : mesh.corners(f))
      if (bends[at(v)]) is_in_patch[at(f)] = 1;
  m_part = selected_faces(mesh, is_in_patch);
  for (const int f : m_part.faces) m_is_in_region.push_back(is_in_region[at(f)]);
  for (std::size_t v = 0; v < m_part.vertices.size(); ++v) {
    const std::size_t whole = at(m_part.vertices[v]);
    m_bends.push_back(bends[whole]);
    m_unknowns.push_back(is_free[whole] ? size() : -1);
    if (is_free[whole]) m_free.push_back(static_cast<int>(v));
  }
  if (m_free.empty())
    throw Precondition_error(
        function,
        "no vertex of the region can move: each has a face outside of the "
        "region, or at the boundary of the mesh; enlarge or refine the region");
  require_rim(function);
  require_areas(function);
}

std::vector<char> internal::Fairing_patch::find_free(const Mesh_view& mesh,
                                                     std::vector<char> is_in_region) const
{
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  const std::vector<char> is_at_boundary = boundary_vertices(mesh);
  std::vector<char> is_free(is_at_boundary.size(), 0), is_held = is_free;
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    bool moves = is_in_region[at(f)] != 0;
    for (const int v : mesh.corners(f)) moves = moves && !is_at_boundary[at(v)];
    for (const int v : mesh.corners(f)) (moves ? is_free : is_held)[at(v)] = 1;
  }
  for (std::size_t v = 0; v < is_free.size(); ++v)
    if (is_held[v]) is_free[v] = 0;
  return is_free;
}

bool internal::Fairing_patch::moves(int f) const
{
  const auto& corners = mesh().corners(f);
  return std::any_of(corners.begin(), corners.end(), [this](int v) { return is_free(v); });
}

void internal::Fairing_patch::require_rim(const std::string& function) const
{
  const std::vector<int> component = connected_components(mesh());
  std::vector<char> has_rim(component.size(), 0);
  for (std::size_t v = 0; v < component.size(); ++v)
    if (m_unknowns[v] < 0) has_rim[static_cast<std::size_t>(component[v])] = 1;
  for (const int v : m_free)
    if (!has_rim[static_cast<std::size_t>(component[static_cast<std::size_t>(v)])])
      throw Precondition_error(function,
                               "the region is the whole component of " +
                                   name_of_vertex(vertices()[static_cast<std::size_t>(v)]) +
                                   ", which has no boundary; leave faces around it that stay");
}

void internal::Fairing_patch::require_areas(const std::string& function) const
{
  refuse_if_any(
      mesh().size_of_faces(), [this](int f) { return has_area_zero(mesh(), f); },
      [this](int f) { return "face " + std::to_string(m_part.faces[static_cast<std::size_t>(f)]); },
      function, "#face of area zero in or around the region",
      "their angles are needed; refine or repair the region");
}

namespace internal {

/// sums of the normals of some faces at each vertex, weighted by angles
template <class Is_counted>
Points summed_normals(const Mesh_view& mesh, Is_counted is_counted)
{
  Points sum = Points::Zero(3, mesh.size_of_vertices());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    if (!is_counted(f)) continue;
    const Eigen::Vector3d N = mesh.double_area_vector(f).normalized();
    for (int c = 0; c < 3; ++c)
      sum.col(mesh.corners(f)[static_cast<std::size_t>(c)]) += corner_angle(mesh.sheet(f), c) * N;
  }
  return sum;
}

}  // namespace internal

internal::Normal_jump internal::normal_jump(const Fairing_patch& patch, const Points& f)
{
  const Mesh_view mesh(f, patch.mesh().corners());
  const Points inner = summed_normals(mesh, [&](int k) { return patch.moves(k); }),
               outer = summed_normals(mesh, [&](int k) { return !patch.is_in_region(k); });
  Normal_jump jump;
  double sum = 0;
  int count = 0;
  for (int v = 0; v < mesh.size_of_vertices(); ++v) {
    if (inner.col(v).isZero(0) || outer.col(v).isZero(0)) continue;
    const Eigen::Vector3d a = inner.col(v), b = outer.col(v);
    const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
    jump.max = (std::max)(jump.max, angle);
    sum += angle * angle, ++count;
  }
  if (count > 0) jump.rms = std::sqrt(sum / count);
  return jump;
}

internal::Bending_energy::Bending_energy(const Fairing_patch& patch, const Points& f)
    : m_patch(patch), m_mesh(patch.mesh()), m_curvature(Points::Zero(3, f.cols()))
{
  m_mesh.set_positions(f);
  m_weights = cotan_weights(m_mesh);
  m_areas = voronoi_areas(m_mesh);
  for (int k = 0; k < m_mesh.size_of_edges(); ++k) {
    const auto [i, j] = m_mesh.ends(k);
    const Eigen::Vector3d flux = m_weights[k] * (f.col(j) - f.col(i));
    m_curvature.col(i) -= flux;
    m_curvature.col(j) += flux;
  }
  for (int v = 0; v < f.cols(); ++v) {
    m_curvature.col(v) *= patch.bends(v) ? 1 / m_areas[v] : 0;
    m_value += m_areas[v] * m_curvature.col(v).squaredNorm() / 4;
  }
}

// With y = L f / A: 2 dW = <y, L df> + <y, dL f> - sum |y_v|^2 dA_v / 2.
Points internal::Bending_energy::gradient() const
{
  Points gradient = Points::Zero(3, m_curvature.cols());
  for (int k = 0; k < m_mesh.size_of_edges(); ++k) {
    const auto [i, j] = m_mesh.ends(k);
    const Eigen::Vector3d flux = m_weights[k] * (m_curvature.col(j) - m_curvature.col(i));
    gradient.col(i) -= flux;
    gradient.col(j) += flux;
  }
  for (int f = 0; f < m_mesh.size_of_faces(); ++f)
    if (m_patch.moves(f)) add_face(f, gradient);
  for (int v = 0; v < gradient.cols(); ++v) gradient.col(v) *= m_patch.is_free(v) ? .5 : 0;
  return gradient;
}

// On a face, <y, L f> is sum q_c cot_c with q_c = <dy, df> / 2 along the edge e_c opposite corner
// c, and -sum |y_v|^2 A_v / 2 is -sum s_c |e_c|^2 cot_c / 16, with s_c = |y|^2 summed over the ends
// of e_c; in an obtuse face, -sum |y_v|^2 r_v A / 2 with the shares r_v = 1/2 or 1/4 of its area A.
// cot_c = <a, b> / 2A with the edges a, b from corner c; A changes by N x e_c / 2 with corner c.
void internal::Bending_energy::add_face(int f, Points& gradient) const
{
  const Sheet sheet = m_mesh.sheet(f);
  const auto y = [&](int k) { return m_curvature.col(sheet.corners[static_cast<std::size_t>(k)]); };
  const auto to = [&](int k) { return gradient.col(sheet.corners[static_cast<std::size_t>(k)]); };
  const Eigen::Vector3d cot(cotangent(sheet, 0), cotangent(sheet, 1), cotangent(sheet, 2));
  const bool is_obtuse = cot.minCoeff() < 0;
  double by_area = 0;
  for (int c = 0; c < 3; ++c) {
    const int p = (c + 1) % 3, r = (c + 2) % 3;
    const Eigen::Vector3d e = sheet.vectors.col(c), a = sheet.vectors.col(r),
                          b = -sheet.vectors.col(p);
    const double s = is_obtuse ? 0 : (y(p).squaredNorm() + y(r).squaredNorm()) / 16;
    const double q = (y(r) - y(p)).dot(e) / 2 - s * e.squaredNorm(), k = q / (2 * sheet.area);
    to(p) += k * b + 2 * s * cot[c] * e;
    to(r) += k * a - 2 * s * cot[c] * e;
    to(c) -= k * (a + b);
    by_area -= q * cot[c] / sheet.area;
    if (is_obtuse) by_area -= y(c).squaredNorm() * (cot[c] < 0 ? .25 : .125);
  }
  const Eigen::Vector3d N = m_mesh.double_area_vector(f) / (2 * sheet.area);
  for (int c = 0; c < 3; ++c) to(c) += by_area / 2 * N.cross(Eigen::Vector3d(sheet.vectors.col(c)));
}

internal::Bending_matrix::Bending_matrix(const Fairing_patch& patch)
{
  const Mesh_view& mesh = patch.mesh();
  std::vector<std::vector<int>> edges(static_cast<std::size_t>(mesh.size_of_vertices()));
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    for (const int v : mesh.ends(k)) edges[static_cast<std::size_t>(v)].push_back(k);
  for (int v = 0; v < mesh.size_of_vertices(); ++v)
    if (patch.bends(v)) add_row(patch, v, edges[static_cast<std::size_t>(v)]);
  find_pattern(patch.size());
}

void internal::Bending_matrix::add_row(const Fairing_patch& patch, int v,
                                       const std::vector<int>& edges)
{
  m_middles.push_back(v);
  if (patch.is_free(v)) m_entries.push_back({patch.unknown(v), edges});
  for (const int k : edges) {
    const int other = patch.mesh().ends(k)[0] + patch.mesh().ends(k)[1] - v;
    if (patch.is_free(other)) m_entries.push_back({patch.unknown(other), {k}});
  }
  m_offsets.push_back(m_entries.size());
}

double internal::Bending_matrix::coefficient(std::size_t p, const Bending_energy& energy) const
{
  const std::vector<int>& edges = m_entries[p].edges;
  if (edges.size() == 1) return -energy.weights()[edges.front()];
  double sum = 0;
  for (const int k : edges) sum += energy.weights()[k];
  return sum;
}

void internal::Bending_matrix::find_pattern(int size)
{
  std::vector<std::vector<int>> columns(static_cast<std::size_t>(size));
  const auto for_each_pair = [this](auto visit) {
    for (std::size_t s = 0; s + 1 < m_offsets.size(); ++s)
      for (std::size_t p = m_offsets[s]; p < m_offsets[s + 1]; ++p)
        for (std::size_t q = m_offsets[s]; q <= p; ++q)
          visit(std::minmax(m_entries[p].unknown, m_entries[q].unknown));
  };
  for_each_pair([&](const std::pair<int, int>& ends) {
    columns[static_cast<std::size_t>(ends.first)].push_back(ends.second);
  });
  m_pattern = sparse_pattern(std::move(columns));
  for_each_pair([&](const std::pair<int, int>& ends) {
    m_places.push_back(m_pattern->find(ends.second, ends.first));
  });
}

}  // namespace Conformal_geometry_processing
