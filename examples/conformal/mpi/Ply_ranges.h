// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "collective.h"

#include "conformal/io/ply/Ply_header.h"

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace conformal::mpi {

namespace CGP = Conformal_geometry_processing;

/// a property with one number for each vertex of the range of this process
struct Column {
  std::string name;
  std::vector<double> values;
};

/// \brief A binary PLY file with triangles, of which every process reads and writes ranges:
/// vertices come first and have numbers only, and every face has the same number of bytes.
class Ply_ranges {
 public:
  /// reads the header. \throws Read_error; Failure if the file is of another kind
  explicit Ply_ranges(std::string path);
  virtual ~Ply_ranges() = default;

  int vertices() const { return static_cast<int>(m_vertex.count); }
  int faces() const { return static_cast<int>(m_face.count); }

  /// \throws Read_error; Failure if a coordinate is not finite
  CGP::Points positions(int first, int last) const;

  /// \throws Read_error; Failure if a face is not a triangle, or has a corner that is not a vertex
  std::vector<std::array<int, 3>> corners(int first, int last) const;

  /// what `write()` leaves out: elements but vertices and faces, and normals
  std::vector<std::string> left_out() const;

  /// \brief Writes the file with other positions, 3 x size of the range, and columns beside the
  /// properties that it has; it gets its name when it is complete. Collective. \throws Failure
  void write(const std::string& path, const Ranges& ranges, const CGP::Points& positions,
             const std::vector<Column>& columns) const;

 protected:
  /// one that is nowhere, whose bytes others know
  Ply_ranges(std::string path, Ply_header header);

  /// the bytes from some place on, as many as there are in `bytes`. \throws Read_error
  virtual void read(std::size_t begin, std::vector<std::byte>& bytes) const;

  /// where the row of a vertex or face begins
  std::size_t vertex_row(int v) const { return m_vertex.at(v); }
  std::size_t face_row(int f) const { return m_face.at(f); }

 private:
  /// rows of equal length in the file
  struct Rows {
    std::size_t count = 0, begin = 0, stride = 0;

    std::size_t at(int row) const { return begin + static_cast<std::size_t>(row) * stride; }
  };
  /// a property in a row
  struct Place {
    std::string name;
    Value_type type;
    std::size_t offset;
  };

  void place_vertices(const Element& element);
  void place_faces(const Element& element);
  [[noreturn]] void refuse(const std::string& what) const;

  /// calls visit(row, bytes) for each row of the range
  void for_each_row(const Rows& rows, int first, int last,
                    const std::function<void(int, const std::byte*)>& visit) const;

  /// the properties of vertices that are carried over
  std::vector<Place> kept(const std::vector<Column>& columns) const;
  std::string header(const std::vector<Place>& kept, const std::vector<Column>& columns) const;

  std::string m_path;
  Ply_header m_header;
  Rows m_vertex, m_face;
  std::vector<Place> m_places;  // of the numbers of a vertex
  std::array<Place, 3> m_xyz;   // among them
  std::size_t m_corners = 0;    // where the list of corners is in the row of a face
};

}  // namespace conformal::mpi
