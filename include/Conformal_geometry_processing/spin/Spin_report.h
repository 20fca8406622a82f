// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_SPIN_REPORT_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_SPIN_REPORT_H

#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/spin/Dirac_solution.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// why a surface with what was prescribed at its boundary is not to be trusted
enum class Boundary_fault {
  none,
  not_realizable,  ///< no conformal surface has it: the singular value of D - rho stays away from 0
  does_not_close,  ///< the edges do not fit together
  degenerate       ///< lambda nearly vanishes somewhere
};

/// \relates Spin_report
const char* to_string(Boundary_fault fault);

/// \ingroup PkgSpin
/// \brief the result of a spin transformation in numbers, which are its proof. The curvature that
/// came is rho + gamma; if it was cancelled, nothing has been written.
struct [[nodiscard]] Spin_report : Dirac_evidence {
  int steps = 1;             ///< of a surface with handles, on which it stays closed
  double reached = 1;        ///< share of the way to rho that could be made, in [0, 1]
  double missing_share = 0;  ///< norm of the part of rho with which the surface would not have
                             ///< closed up, and that was left out, by that of rho
  double period_defect = 0;  ///< what was left of it, relative to the edges, sum of the steps

  /// of prescribed directions at a boundary, radians: of those of the new surface to the targets
  struct Direction_error {
    double mean = 0, max = 0;
  } direction_error;
  Boundary_fault boundary_fault = Boundary_fault::none;

  /// what the triangulation was made of on which robust operators worked; of several steps the
  /// most, and what was measured in the first
  struct Mollification {
    double share = 0;          ///< that was asked for; 0: none
    int thin_faces = 0;        ///< whose edges lacked length
    int longer_edges = 0;      ///< that were made longer: all or none
    double added_length = 0;   ///< to each of them, in the unit of the mesh
    int flipped_edges = 0;     ///< until all were Delaunay
    int measured_faces = 0;    ///< on which `conformality` is measured: the `well_shaped_faces()`
    double measured_area = 0;  ///< of those, as a share of all; at least 95 %
  } mollification;

  double closure_residual = 0;  ///< how far the new edges are from closing up, relative
  Conformality conformality;    ///< of the map from the old surface to the new one
  double min_spin_ratio = 0;  ///< min |lambda| / max |lambda|; near zero where the map degenerates

  /// wall clock seconds
  struct Seconds : Dirac_evidence::Seconds {
    double setup = 0;           ///< pattern, ordering, symbolic analysis: once per mesh
    double reconstruction = 0;  ///< the Laplacian's factorization too, the first time
    double certificate = 0;
  } seconds;

  /// whether the transformation was carried out: solved, every number of it finite, and what was
  /// asked for at a boundary possible
  explicit operator bool() const;
};

namespace internal {

void append(Spin_report::Mollification& all, const Spin_report::Mollification& next);

}  // namespace internal

/// \relates Spin_report
/// \brief the report of two transformations, one after the other, out of theirs: sums of what was
/// spent, and of evidence the worse. What is measured from end to end (conformality, spins) is left
/// to the caller.
void append(Spin_report& all, const Spin_report& next);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/Spin_report_impl.h>
#endif

#endif
