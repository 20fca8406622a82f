// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Ply_ranges.h"

#include <Conformal_geometry_processing/mesh/Surface_ref.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace conformal::mpi {

/// \brief The part of a surface that a process works on: its own vertices, all faces that
/// touch these, and the other corners of these faces, which are other processes' own.
///
/// Vertices have new numbers, in which those of a process are a range. In the mesh of the part,
/// own vertices come first, in their order, and the faces that this process counts: each face of
/// the surface is counted by one process, and so is each edge that `counts()`.
class Distributed_mesh {
 public:
  /// \brief Reads the file in parts and divides the surface by its graph (PT-Scotch), such that few
  /// edges run between processes. Collective.
  /// \param has_loops whether it may have handles, or several boundaries
  /// \throws Failure if the surface is not such a connected manifold
  explicit Distributed_mesh(const Ply_ranges& file, bool has_loops = false);

  const CGP::Mesh_view& mesh() const { return m_mesh; }
  int own_vertices() const { return m_ranges.size(); }
  int own_faces() const { return m_own_faces; }

  /// the new numbers of all vertices
  const Ranges& ranges() const { return m_ranges; }

  /// the new number of a vertex of the mesh of the part
  int number(int v) const
  {
    const int own = own_vertices();
    return v < own ? m_ranges.begin() + v : m_others[static_cast<std::size_t>(v - own)];
  }

  /// whether this process counts the edge: its end of lower number is its own
  bool counts(int edge) const
  {
    const auto [i, j] = m_mesh.ends(edge);
    return m_ranges.is_mine((std::min)(number(i), number(j)));
  }

  /// \brief Replaces the columns of other processes' vertices by what these have. Collective.
  /// \param values one column for each vertex of the mesh of the part
  void update(Eigen::MatrixXd& values) const;

  /// \brief Takes one column for each own vertex to the process that has it in an equal division of
  /// the vertices in the order of the file. Collective.
  Eigen::MatrixXd in_order_of_file(const Eigen::MatrixXd& own) const;

  /// the inverse of `in_order_of_file()`
  Eigen::MatrixXd from_order_of_file(const Eigen::MatrixXd& ordered) const;

  bool is_closed() const { return m_is_closed; }

  /// with which functions on the mesh of the part measure the whole surface, collectively
  CGP::internal::Surface_part part() const;

 private:
  std::vector<int> divide(const std::vector<std::array<int, 3>>& corners,
                          const Ranges& in_file) const;
  void take_vertices(const Ply_ranges& file, const Ranges& in_file, const std::vector<int>& parts);
  void take_faces(const std::vector<std::array<int, 3>>& corners, const Ranges& in_file);
  void require_surface(const std::string& path) const;
  void require_stars() const;
  void require_connected() const;
  void find_topology(bool may_have_loops);

  Ranges m_ranges;
  std::vector<int> m_number_in_file;     // of the own vertices
  std::vector<int> m_new_numbers;        // of the vertices in a range of the file
  std::vector<int> m_others;             // the new numbers of other processes' vertices, in order
  std::vector<std::vector<int>> m_sent;  // own vertices that each process needs
  CGP::Points m_own_positions;
  CGP::Mesh_view m_mesh;
  int m_own_faces = 0;
  bool m_is_closed = true;
};

}  // namespace conformal::mpi
