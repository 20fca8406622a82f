// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// weights of the residuals of a `Dirac_misfit`, numbers without a unit
struct Misfit_weights {
  double sheets = 0.2;
  double vertices = 0;  ///< 0: `default_vertex_weight()`
  double factor = 1;    ///< of both

  double sum() const { return sheets + vertices; }
};

}  // namespace Conformal_geometry_processing::internal
