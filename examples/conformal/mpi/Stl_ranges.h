// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Ply_ranges.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace conformal::mpi {

/// \brief A binary STL file as the PLY file that it would be: corners at the same place, which may
/// be in the parts of different processes, are one vertex, and vertices have the numbers that
/// `read_stl()` gives them.
class Stl_ranges final : public Ply_ranges {
 public:
  /// \brief Collective. \throws Read_error; Failure if the file is of another kind, if a coordinate
  /// is not finite, or a facet has two equal corners
  explicit Stl_ranges(const std::string& path);

 private:
  struct Table;

  Stl_ranges(const std::string& path, Table table);
  void read(std::size_t begin, std::vector<std::byte>& bytes) const override;

  /// what follows byte `begin` of the PLY file
  struct Block {
    std::size_t begin;
    std::vector<std::byte> bytes;
  };
  Block m_vertices, m_faces;  // of the equal ranges of this process
};

/// \brief The surface of a PLY or STL file. Collective. \throws as their constructors do
std::unique_ptr<const Ply_ranges> surface_ranges(const std::string& path);

}  // namespace conformal::mpi
