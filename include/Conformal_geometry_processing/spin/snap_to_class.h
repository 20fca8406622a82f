// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/conformal_class/Conformal_class.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/spin/Class_snap_report.h>

#include <string>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgConformalClass
/// Requires an oriented manifold, in one component or more, without edges of length zero
void require_edge_lengths(const Mesh_view& mesh, const std::string& function);

/// \ingroup PkgConformalClass
/// \brief moves positions, 3 x |V|, into the conformal class of the reference; computes in a frame
/// of unit size.
/// \param rim directions at the boundary that stay
/// \pre `require_edge_lengths()` of both
/// \throw Solver_error if a factorization fails
Class_snap_report snap_to_class(const Mesh_view& reference, Points& positions,
                                const Snap_options& options, Rim_directions rim = {});

}  // namespace Conformal_geometry_processing::internal
