// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/flow/Bending_energy.h>
#include <Conformal_geometry_processing/linear_algebra/dense/Solver_status.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgFlow
/// \brief A step of a fairing
struct Fairing_step {
  Points f;               ///< positions of the vertices of the patch: of the last trial
  bool is_lower = false;  ///< it has less energy than before
};

/// a free vertex for each column, added to positions
inline Points moved(const Fairing_patch& patch, Points f, const Points& d, double t = 1)
{
  for (int k = 0; k < patch.size(); ++k) f.col(patch.free_vertex(k)) += t * d.col(k);
  return f;
}

inline void require_fairing_solver(Solver_status status)
{
  if (status != Solver_status::success) throw Solver_error("conformal_fairing", to_string(status));
}

}  // namespace Conformal_geometry_processing::internal
