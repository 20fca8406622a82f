// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/requirements.h>

#include <Conformal_geometry_processing/mesh/topology.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

std::string name_of_face(const Mesh_view& mesh, int f)
{
  const auto& v = mesh.corners(f);
  return "face " + std::to_string(f) + " (vertices " + std::to_string(v[0]) + ", " +
         std::to_string(v[1]) + ", " + std::to_string(v[2]) + ")";
}

std::string name_of_edge(const Mesh_view& mesh, int k)
{
  return "edge " + std::to_string(mesh.ends(k)[0]) + "-" + std::to_string(mesh.ends(k)[1]);
}

std::string counted(int count, std::string what)
{
  const std::size_t mark = what.find('#'), end = (std::min)(what.find(' ', mark), what.size());
  if (count != 1) {
    const bool ends_in_x = what[end - 1] == 'x';
    what.replace(ends_in_x ? end - 2 : end, ends_in_x ? 2 : 0, ends_in_x ? "ices" : "s");
  }
  return std::to_string(count) + " " + what.erase(mark, 1);
}

std::string name_of_vertex(int v)
{
  return "vertex " + std::to_string(v);
}

// Scales by the longest edge where squares of squares might overflow or underflow.
bool has_area_zero(Eigen::Matrix3d edges)
{
  const double longest = edges.cwiseAbs().maxCoeff();
  if (!(longest > 0)) return true;
  if (!(longest > 1e-60 && longest < 1e60)) edges /= longest;
  const double longest_squared = edges.colwise().squaredNorm().maxCoeff();
  const double least_area = 2 * relative_area_tolerance * longest_squared;
  return !(edges.col(0).cross(edges.col(1)).squaredNorm() > least_area * least_area);
}

Defect non_finite_vertices(const Mesh_view& mesh)
{
  return find_defect(Defect::Kind::vertex_out_of_range, mesh.size_of_vertices(),
                     [&](int v) { return !mesh.position(v).allFinite(); });
}

Defect non_manifold_edges(const Mesh_view& mesh)
{
  return find_defect(Defect::Kind::non_manifold_edge, mesh.size_of_edges(),
                     [&](int k) { return mesh.halfedges_end(k) - mesh.halfedges_begin(k) > 2; });
}

Defect edges_of_opposed_faces(const Mesh_view& mesh)
{
  return find_defect(Defect::Kind::edge_of_opposed_faces, mesh.size_of_edges(), [&](int k) {
    const int* h = mesh.halfedges_begin(k);
    return mesh.halfedges_end(k) - h == 2 && mesh.from(h[0]) == mesh.from(h[1]);
  });
}

Defect non_manifold_vertices(const Mesh_view& mesh)
{
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  std::vector<int> corners(at(mesh.size_of_vertices()), 0), start(corners.size(), -1);
  for (int h = 0; h < mesh.size_of_halfedges(); ++h) {
    const int v = mesh.from(h);
    ++corners[at(v)];
    if (start[at(v)] < 0 || mesh.twin(h) < 0) start[at(v)] = h;
  }
  // Walks counter-clockwise from `start`, the halfedge out of v without a face on its right if
  // there is one: the fan is complete if the walk visits as many faces as v has corners.
  return find_defect(Defect::Kind::non_manifold_vertex, mesh.size_of_vertices(), [&](int v) {
    int met = 0;
    for (int h = start[at(v)]; h >= 0;) {
      ++met;
      h = mesh.twin(Mesh_view::previous_in_face(h));
      if (h == start[at(v)]) break;
    }
    return met != corners[at(v)];
  });
}

Defect faces_of_area_zero(const Mesh_view& mesh)
{
  return find_defect(Defect::Kind::face_of_area_zero, mesh.size_of_faces(),
                     [&](int f) { return has_area_zero(mesh, f); });
}

Defect further_components(const Mesh_view& mesh)
{
  // Components are numbered in the order of their first vertices.
  const std::vector<int> component = connected_components(mesh);
  Defect defect{Defect::Kind::further_component};
  for (int v = 0; v < mesh.size_of_vertices(); ++v)
    if (component[static_cast<std::size_t>(v)] == defect.count + 1 && defect.count++ == 0)
      defect.first = v;
  return defect;
}

Defect boundary_edges(const Mesh_view& mesh)
{
  return find_defect(Defect::Kind::boundary_edge, mesh.size_of_edges(),
                     [&](int k) { return mesh.halfedges_end(k) - mesh.halfedges_begin(k) == 1; });
}

/// Returns the name of element i of the kind
inline std::string name_of(Defect::Kind kind, const Mesh_view& mesh, int i)
{
  using Kind = Defect::Kind;
  switch (kind) {
    case Kind::face_of_area_zero:
      return name_of_face(mesh, i);
    case Kind::non_manifold_edge:
    case Kind::edge_of_opposed_faces:
    case Kind::boundary_edge:
      return name_of_edge(mesh, i);
    default:
      return name_of_vertex(i);
  }
}

/// Throws if there is a defect
/// \param what see `counted()`
inline void refuse(const Defect& defect, const Mesh_view& mesh, const std::string& function,
                   const std::string& what, const std::string& advice)
{
  if (defect)
    throw Precondition_error(function, counted(defect.count, what) + ", the first is " +
                                           name_of(defect.kind, mesh, defect.first) + "; " +
                                           advice);
}

/// The relative height of a face: height over longest edge
struct Face_height {
  double relative, twice_area;
  int face;

  bool operator<(const Face_height& other) const
  {
    return std::pair(relative, face) < std::pair(other.relative, other.face);
  }
};

Face_height face_height(const Mesh_view& mesh, int f)
{
  const double twice_area = mesh.double_area_vector(f).norm();
  double longest = 0;  // squared
  for (int h = 3 * f; h < 3 * f + 3; ++h)
    longest = (std::max)(longest, mesh.vector(h).squaredNorm());
  return {longest > 0 ? twice_area / longest : 0, twice_area, f};
}

}  // namespace internal

void require_not_empty(const Mesh_view& mesh, const std::string& function)
{
  if (mesh.size_of_faces() == 0) throw Precondition_error(function, "the mesh has no faces");
}

void require_finite_positions(const Mesh_view& mesh, const std::string& function)
{
  internal::refuse(internal::non_finite_vertices(mesh), mesh, function,
                   "#vertex with a coordinate that is not finite", "finite coordinates are needed");
}

void require_no_isolated_vertices(const Mesh_view& mesh, const std::string& function)
{
  std::vector<char> is_used(static_cast<std::size_t>(mesh.size_of_vertices()), 0);
  for (const auto& face : mesh.corners())
    for (int v : face) is_used[static_cast<std::size_t>(v)] = 1;
  internal::refuse_if_any(
      mesh.size_of_vertices(), [&](int v) { return !is_used[static_cast<std::size_t>(v)]; },
      internal::name_of_vertex, function, "#vertex without a face", "remove them first");
}

void require_distinct_corners(const Mesh_view& mesh, const std::string& function)
{
  internal::refuse_if_any(
      mesh.size_of_faces(),
      [&](int f) {
        const auto& v = mesh.corners(f);
        return v[0] == v[1] || v[1] == v[2] || v[2] == v[0];
      },
      [&](int f) { return internal::name_of_face(mesh, f); }, function,
      "#face with a repeated vertex", "remove them first");
}

void require_manifold_edges(const Mesh_view& mesh, const std::string& function)
{
  internal::refuse(internal::non_manifold_edges(mesh), mesh, function,
                   "non-manifold #edge (more than two faces)", "a manifold is needed");
  internal::refuse(internal::edges_of_opposed_faces(mesh), mesh, function,
                   "#edge whose two faces are oriented against each other",
                   "a consistent orientation is needed");
}

void require_manifold_vertices(const Mesh_view& mesh, const std::string& function)
{
  internal::refuse(internal::non_manifold_vertices(mesh), mesh, function,
                   "non-manifold #vertex (several fans of faces)", "a manifold is needed");
}

bool has_area_zero(const Mesh_view& mesh, int f)
{
  Eigen::Matrix3d edges;
  for (int c = 0; c < 3; ++c) edges.col(c) = mesh.vector(3 * f + c);
  return internal::has_area_zero(edges);
}

void require_positive_areas(const Mesh_view& mesh, const std::string& function)
{
  internal::refuse(internal::faces_of_area_zero(mesh), mesh, function, "#face of area zero",
                   "remove or repair them first");
}

void require_some_area(const Mesh_view& mesh, const std::string& function)
{
  if (internal::faces_of_area_zero(mesh).count == mesh.size_of_faces())
    throw Precondition_error(function, "all faces have area zero; a surface is needed");
}

void require_connected(const Mesh_view& mesh, const std::string& function)
{
  const internal::Defect further = internal::further_components(mesh);
  if (further)
    throw Precondition_error(function, "the mesh has " + std::to_string(further.count + 1) +
                                           " components, the second begins at vertex " +
                                           std::to_string(further.first) +
                                           "; one component is needed, transform each alone");
}

void require_closed(const Mesh_view& mesh, const std::string& function)
{
  internal::refuse(internal::boundary_edges(mesh), mesh, function, "boundary #edge",
                   "a closed surface is needed");
}

void require_genus_zero(const Mesh_view& mesh, const std::string& function)
{
  const int chi = mesh.size_of_vertices() - mesh.size_of_edges() + mesh.size_of_faces();
  if (chi != 2)
    throw Precondition_error(function, "the surface has genus " + std::to_string(1 - chi / 2) +
                                           "; genus zero is needed");
}

void require_manifold_components(const Mesh_view& mesh, const std::string& function)
{
  require_not_empty(mesh, function);
  require_finite_positions(mesh, function);
  require_distinct_corners(mesh, function);
  require_no_isolated_vertices(mesh, function);
  require_manifold_edges(mesh, function);
  require_manifold_vertices(mesh, function);
}

void require_manifold(const Mesh_view& mesh, const std::string& function)
{
  require_manifold_components(mesh, function);
  require_connected(mesh, function);
}

void require_surface(const Mesh_view& mesh, const std::string& function)
{
  require_manifold(mesh, function);
  require_positive_areas(mesh, function);
}

internal::Well_shaped_faces well_shaped_faces(const Mesh_view& mesh)
{
  const double least_height = 0.05, greatest_share = 0.05;
  std::vector<internal::Face_height> thin;
  double all = 0, left_out = 0;
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const internal::Face_height face = internal::face_height(mesh, f);
    all += face.twice_area;
    if (!(face.relative > least_height)) thin.push_back(face);
  }
  std::sort(thin.begin(), thin.end());
  std::vector<bool> is_sound(static_cast<std::size_t>(mesh.size_of_faces()), true);
  for (const internal::Face_height& face : thin) {
    if (left_out + face.twice_area > greatest_share * all) break;
    left_out += face.twice_area;
    is_sound[static_cast<std::size_t>(face.face)] = false;
  }
  Mesh_view::Corners corners;
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    if (is_sound[static_cast<std::size_t>(f)]) corners.push_back(mesh.corners(f));
  return {{mesh.positions(), std::move(corners)}, 1 - left_out / all};
}

}  // namespace Conformal_geometry_processing
