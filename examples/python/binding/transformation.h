// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "options.h"
#include "reports.h"
#include "watch.h"

#include <Conformal_geometry_processing/spin/Spin_transformation.h>

namespace conformal_python {

/// (positions, spins, report): what Python makes a result of. Positions and spins have no rows
/// where there are none.
inline py::tuple as_tuple(const CGP::Spin_result& result)
{
  return py::make_tuple(to_rows(result.positions), to_rows(result.lambda), as_dict(result.report));
}

}  // namespace conformal_python
