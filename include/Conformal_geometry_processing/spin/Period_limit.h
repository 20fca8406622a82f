// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <optional>

namespace Conformal_geometry_processing::internal {

/// \brief the largest period defect of a transformation that counts as closed.
///
/// A defect shears the surface by about as much. By default it may be a quarter of the distortion
/// that the step has anyway, mean Q - 1: that is the discretisation error, O(h) and in proportion
/// to rho, so that the defect neither stops the convergence under refinement nor costs steps that
/// no one would notice. Never more than 2 % of the edges, because on bad meshes Q is large, nor
/// less than .2 %, which shears by less than one sees: maps in the plane have hardly any
/// distortion.
struct Period_limit {
  std::optional<double> maximum;  ///< relative to the edges; see above
  double tolerance = 0;           ///< of the spins: smaller defects are errors of the solver

  /// \param report of the transformation
  double operator()(const Spin_report& report) const;
};

}  // namespace Conformal_geometry_processing::internal
