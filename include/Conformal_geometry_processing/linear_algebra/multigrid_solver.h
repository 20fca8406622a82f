// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_MULTIGRID_SOLVER_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_MULTIGRID_SOLVER_H

/// \file linear_algebra/multigrid_solver.h
/// \brief Smoothed aggregation for quaternionic and real matrices, with low memory.

#include <Conformal_geometry_processing/linear_algebra/multigrid/Multigrid_solver.h>

#endif
