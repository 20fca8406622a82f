// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_VERTEX_GRAPH_H
#define CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_VERTEX_GRAPH_H

#include <Conformal_geometry_processing/algebra/Sparse_pattern.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <memory>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// \brief the pattern of every Hermitian matrix on the vertices of a mesh: |V| diagonal entries
/// and one for each edge.
///
/// Edges are sorted by their ends (i, j), i < j, and column i holds (i, i) before its edges, so the
/// entry (j, i) of edge k has position k + i + 1 and assembly needs no table.
std::shared_ptr<const Sparse_pattern> vertex_graph(const Mesh_view& mesh);

/// the position of the diagonal entry (i, i) in `vertex_graph(mesh)`
int diagonal_position(const Sparse_pattern& pattern, int i);

/// the position of the entry (j, i), i < j, of edge k in `vertex_graph(mesh)`
int edge_position(const Mesh_view& mesh, int k);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/operators/vertex_graph_impl.h>
#endif

#endif
