// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Fairing_patch.h>

#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

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

}  // namespace Conformal_geometry_processing
