// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "select_faces.h"

#include <array>
#include <vector>

namespace conformal {

/// \brief The faces of a file as triangles that can be removed and flipped, and whose edges can be
/// collapsed; they need not be a manifold.
///
/// A corner stores its vertex and its rows of the texture coordinates and of the normals (-1:
/// none). A triangle stores the face of the file whose properties it has.
class Triangle_soup {
 public:
  struct Corner {
    int vertex, texture, normal;
  };
  struct Triangle {
    std::array<Corner, 3> corners;
    int face;
    bool is_alive;
  };

  /// the file is written to by `flip()`, which may need new texture coordinates, and `faces()`
  explicit Triangle_soup(Surface_file& file);

  int size() const { return static_cast<int>(m_triangles.size()); }
  const Triangle& operator[](int t) const { return m_triangles[static_cast<std::size_t>(t)]; }
  int vertex(int t, int k) const
  {
    return (*this)[t].corners[static_cast<std::size_t>(k % 3)].vertex;
  }

  const Point& point(int v) const { return m_file.points[static_cast<std::size_t>(v)]; }

  /// the triangles at a vertex, and those at an edge
  const std::vector<int>& around(int v) const { return m_around[static_cast<std::size_t>(v)]; }
  std::vector<int> around(int v, int w) const;

  /// a triangle with these corners, whatever their order, or -1
  int find(const std::array<int, 3>& v) const;

  /// the one triangle that shares the edge opposite corner k of t and agrees with t, or -1
  int neighbor(int t, int k) const;

  /// the corner of a triangle that is neither v nor w
  int opposite(int t, int v, int w) const;

  void remove(int t);

  /// \brief Gives t and g, its neighbour opposite corner k, the other diagonal of their
  /// quadrilateral. Both get the face of g.
  ///
  /// Where t and g have different values along their common edge (a seam), the corner k gets those
  /// of g, interpolated along the edge; else it keeps its own.
  void flip(int t, int k, int g);

  /// \brief Puts w in the place of v, and removes the triangles that have both. A corner that moves
  /// to w gets the values that w has in one of these triangles, if v has its own there. A triangle
  /// that is then there twice is removed.
  void collapse(int v, int w);

  /// The resulting faces of the file; unchanged if none of their triangles was changed
  Selected_faces faces() const;

 private:
  Triangle& triangle(int t) { return m_triangles[static_cast<std::size_t>(t)]; }
  void replace(int t, const Triangle& by);
  void leave(int t);
  int corner_at(int t, int v) const;
  Corner moved(const Corner& corner, int w, const std::vector<int>& between) const;
  void mark_changed(int t) { m_is_changed[static_cast<std::size_t>((*this)[t].face)] = 1; }

  Surface_file& m_file;
  std::vector<Triangle> m_triangles;
  std::vector<std::vector<int>> m_around;  // triangles of each vertex
  std::vector<char> m_is_changed;          // per face of the file
};

}  // namespace conformal
