// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SURFACES_SNAP_TO_CLASS_H
#define CONFORMAL_GEOMETRY_PROCESSING_SURFACES_SNAP_TO_CLASS_H

#include <Conformal_geometry_processing/conformal_class/Conformal_class.h>
#include <Conformal_geometry_processing/measure/length_cross_ratio.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <string>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgConformalClass
/// \brief The numbers that verify `snap_to_conformal_class()`.
struct [[nodiscard]] Class_snap_report {
  bool converged = false;
  int iterations = 0, factorizations = 0;
  /// changes of log length cross-ratios from the reference, in the end of the positions as written
  Length_cross_ratio_change initial_length_cross_ratio, length_cross_ratio;
  double displacement = 0;  ///< root mean square over the vertices, by the diagonal of the mesh

  /// whether the surface is in the class; if not, nothing was written
  explicit operator bool() const { return converged; }
};

/// \ingroup PkgConformalClass
/// Requires an oriented manifold, in one component or more, without edges of length zero
void require_edge_lengths(const Mesh_view& mesh, const std::string& function);

/// \ingroup PkgConformalClass
/// \brief moves positions, 3 x |V|, into the conformal class of the reference; computes in a frame
/// of unit size.
/// \pre `require_edge_lengths()` of both
/// \throw Solver_error if a factorization fails
Class_snap_report snap_to_class(const Mesh_view& reference, Points& positions,
                                const Snap_options& options);

}  // namespace internal

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/surfaces/snap_to_class_impl.h>
#endif

#endif
