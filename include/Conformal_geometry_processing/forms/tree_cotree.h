// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

/// A spanning tree of the faces by breadth-first search, which keeps the loops short, and the
/// leftover edges: those neither crossed by it nor contained in a spanning tree of the vertices.
/// The outside of a surface with boundary counts as one more face, so 2G + loops - 1 edges are left
/// over, and 2G without boundary.
class Tree_cotree {
 public:
  explicit Tree_cotree(const Mesh_view& mesh);

  /// the leftover edges, ascending
  const std::vector<int>& leftover_edges() const { return m_leftover; }

  /// the halfedges of the loop of faces that crosses the leftover edge k: calls visit(h, sign) with
  /// sign = 1 where the loop leaves face(h) through h, and with sign = -1 where it enters there.
  /// Edges traversed twice are reported with both signs.
  template <class Visitor>
  void for_each_crossing(int k, Visitor visit) const
  {
    const int h = *m_mesh.halfedges_begin(k);
    visit(h, 1);
    walk_to_root(beyond(h), 1, visit);
    walk_to_root(Mesh_view::face(h), -1, visit);
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  template <class Visitor>
  void walk_to_root(int f, int sign, Visitor visit) const
  {
    for (int h = m_exit[at(f)]; h >= 0; h = m_exit[at(f)]) {
      const bool is_outside = f == outside();
      visit(h, is_outside ? -sign : sign);
      f = is_outside ? Mesh_view::face(h) : beyond(h);
    }
  }

  int outside() const { return m_mesh.size_of_faces(); }

  /// the face on the other side of a halfedge
  int beyond(int h) const;

  /// the halfedges through which the neighbouring faces reach f
  template <class Visitor>
  void for_each_halfedge_around(int f, Visitor visit) const
  {
    if (f < outside())
      for (int h = 3 * f; h < 3 * f + 3; ++h) visit(h);
    else
      for (int h = 0; h < m_mesh.size_of_halfedges(); ++h)
        if (m_mesh.twin(h) < 0) visit(h);
  }

  void grow_cotree();
  void grow_tree();

  const Mesh_view& m_mesh;
  // |F| + 1 entries, the last for the outside: the halfedge towards the root, -1 at the root.
  // Boundary edges have one halfedge for both directions.
  std::vector<int> m_exit;
  std::vector<char> m_is_crossed;  // |E|: by the tree of the faces
  std::vector<int> m_leftover;
};

}  // namespace internal

/// \ingroup PkgForms
/// \brief closed 1-forms whose classes are a basis of the cohomology with integer coefficients: 2G
/// on a closed surface, 2G + loops - 1 with boundary. A matrix of |E| rows and integer entries,
/// mostly 0.
///
/// Tree-cotree decomposition: the edges that are neither crossed by a spanning tree of the faces
/// nor contained in a spanning tree of the vertices are as many. Each of them closes a loop in the
/// tree of faces, whose form is 1 on the edges that it crosses from left to right (seen along the
/// edge i -> j, i < j), and -1 on those crossed from right to left. The sum around a face is
/// exactly zero, because the loop leaves the face as often as it enters; the integral along a curve
/// is the number of its crossings with the loop. Loops may pass through the outside, as if all
/// holes were one face; the form then belongs to a path from boundary to boundary. Depends only on
/// the connectivity.
///
/// O(|V| + |F|) plus the lengths of the loops.
/// \pre `require_surface(mesh)` holds
Eigen::MatrixXd closed_generators(const Mesh_view& mesh);

namespace internal {

/// \ingroup PkgForms
/// \brief a loop from face to face that visits no face twice: the halfedges through which it leaves
/// the faces, in order.
using Face_loop = std::vector<int>;

}  // namespace internal

/// \ingroup PkgForms
/// \brief 2G loops of faces that generate the homology of a closed surface; the forms of
/// `closed_generators()` count crossings with these loops. Depends only on the connectivity.
///
/// O(|V| + |F|) plus the lengths of the loops.
/// \pre the surface is closed, and `require_surface(mesh)` holds
std::vector<internal::Face_loop> loops_of_faces(const Mesh_view& mesh);

/// \ingroup PkgForms
/// \brief the numbers of crossings between loops of faces, modulo 2: a symmetric matrix with zeros
/// on the diagonal, of odd determinant if the loops are a basis of the homology.
Eigen::MatrixXi crossings_modulo_2(const Mesh_view& mesh,
                                   const std::vector<internal::Face_loop>& loops);

}  // namespace Conformal_geometry_processing
