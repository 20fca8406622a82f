// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Distributed_mesh.h"

#include <vector>

namespace conformal::mpi {

/// \brief The vertices along the borders of the parts: those with a neighbour on a process before
/// their own. No edge between two parts is left without them.
struct Border_vertices {
  /// Collective
  explicit Border_vertices(const Distributed_mesh& mesh);

  Ranges ranges;             ///< their numbers, of which those of a process are a range
  std::vector<int> numbers;  ///< of the vertices of the mesh of the part; -1 where it is none
  int others_before = 0;     ///< the vertices of processes before, the first of the others
};

}  // namespace conformal::mpi
