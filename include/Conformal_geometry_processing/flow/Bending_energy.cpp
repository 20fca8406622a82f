// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Bending_energy.h>

#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace Conformal_geometry_processing {

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
