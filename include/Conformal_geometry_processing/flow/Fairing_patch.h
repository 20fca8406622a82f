// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_component.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <cstddef>
#include <string>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \brief A region of a surface that is to be replaced, with as much of its surroundings as
/// determines the normals at its rim.
///
/// A vertex is free if all faces around it belong to the region, and none of them touches the
/// boundary of the mesh: there, the first row of faces stays, because it carries the normals. The
/// surface bends at the free vertices and at their neighbours; those that are not free are the rim.
/// The patch consists of the faces around all of these, so each of them has its complete ring.
class Fairing_patch {
 public:
  /// \param mesh with finite positions and manifold
  /// \param is_in_region one entry for each face
  /// \throw Precondition_error if there is no free vertex, a component of the surface has no rim,
  /// or a face of the patch has area zero
  Fairing_patch(const Mesh_view& mesh, const std::vector<char>& is_in_region,
                const std::string& function);

  /// the faces around all vertices where the surface bends
  const Mesh_view& mesh() const { return m_part.mesh; }

  /// the indices of the vertices of the patch in the whole mesh
  const std::vector<int>& vertices() const { return m_part.vertices; }

  /// the number of free vertices
  int size() const { return static_cast<int>(m_free.size()); }

  /// the free vertex k, in the patch
  int free_vertex(int k) const { return m_free[static_cast<std::size_t>(k)]; }

  const std::vector<int>& free_vertices() const { return m_free; }

  /// which free vertex v is; -1 if it is held
  int unknown(int v) const { return m_unknowns[static_cast<std::size_t>(v)]; }
  const std::vector<int>& unknowns() const { return m_unknowns; }

  bool is_free(int v) const { return unknown(v) >= 0; }

  /// whether v or a neighbour is free
  bool bends(int v) const { return m_bends[static_cast<std::size_t>(v)] != 0; }

  /// whether face f moves: one of its corners is free
  bool moves(int f) const;

  /// whether face f of the patch belongs to the region
  bool is_in_region(int f) const { return m_is_in_region[static_cast<std::size_t>(f)] != 0; }

 private:
  std::vector<char> find_free(const Mesh_view& mesh, std::vector<char> is_in_region) const;
  void require_rim(const std::string& function) const;
  void require_areas(const std::string& function) const;

  Mesh_component m_part;
  std::vector<int> m_free, m_unknowns;
  std::vector<char> m_bends, m_is_in_region;
};

/// \brief The largest, and the root mean square, angle between the normals of a surface inside and
/// outside of a region, at its rim, in radians.
///
/// At each vertex of the rim, angle-weighted normals of the faces that move, and of those outside
/// of the region. Of smooth surfaces they differ by O(h), as the edges are long.
struct Normal_jump {
  double max = 0, rms = 0;
};

/// \param f positions of the vertices of the patch
Normal_jump normal_jump(const Fairing_patch& patch, const Points& f);

}  // namespace Conformal_geometry_processing::internal
