// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/conformal_class/Conformal_class.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/spin/Framed_surface.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <string>

namespace Conformal_geometry_processing {
struct Spin_result;
}

namespace Conformal_geometry_processing::internal {

/// Requires an oriented manifold, in one component or more, without edges of length zero
void require_edge_lengths(const Mesh_view& mesh, const std::string& function);

/// \brief moves positions, 3 x |V|, into the conformal class of the reference; computes in a frame
/// of unit size.
/// \param rim directions at the boundary that stay
/// \pre `require_edge_lengths()` of both
/// \throw Solver_error if a factorization fails
Class_snap_report snap_to_class(const Mesh_view& reference, Points& positions,
                                const Snap_options& options, Rim_directions rim = {});

/// \brief moves a transformed surface by as little as possible into the exact discrete conformal
/// class of the initial one: to its length cross-ratios, up to rounding.
///
/// Spins solve the Dirac equation up to the discretisation error, and so do the length
/// cross-ratios. Afterwards |lambda|^2 at the ends of an edge are factors of its length whose
/// geometric mean is exactly that by which it has changed; the directions of lambda are those of
/// the equation. Area and centroid stay those of the initial surface.
///
/// One or two factorizations of a real matrix with blocks of 4 x 4 numbers on the vertices.
/// \param domain the initial surface. With mollification, the class is that of its intrinsic
/// Delaunay triangulation, with the distances of vertices in space as lengths
/// \param boundary its condition: with directions, those at the edges of the boundary stay as they
/// are, see `Rim_directions`; a free boundary moves
/// \param result of a transformation that was not cancelled; receives positions, lambda, the
/// certificate, and `Spin_report::exact_class`. Where the class is not reached, only the last
/// \pre no edge of the surface has length zero
void move_to_class(const Framed_surface& domain, const Boundary_condition& boundary,
                   Spin_result& result);

}  // namespace Conformal_geometry_processing::internal
