// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/linear_algebra/direct/minimum_vertex_cut.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgLinearAlgebra
/// \brief A part of a graph with positions, which nested dissection subdivides.
///
/// Stores copies with local indices, so that traversals access memory sequentially even if the
/// vertices of the mesh are badly numbered.
struct Graph_region {
  std::vector<int> vertices;                          ///< their indices in the whole graph
  Eigen::Matrix<float, Eigen::Dynamic, 3> positions;  ///< one row for each vertex
  std::vector<std::array<int, 2>> edges;              ///< between vertices of the region

  int size() const { return static_cast<int>(vertices.size()); }
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Returns the whole graph; positions are scaled to [-1, 1], where single precision suffices
/// to choose cuts.
internal::Graph_region graph_region(const Sparse_pattern& pattern,
                                    const Eigen::Matrix3Xd& positions);

/// \ingroup PkgLinearAlgebra
/// \brief Returns the left and the right side.
/// \pre no edge joins left and right
std::array<internal::Graph_region, 2> split(const internal::Graph_region& region,
                                            const std::vector<internal::Side>& sides);

}  // namespace Conformal_geometry_processing
