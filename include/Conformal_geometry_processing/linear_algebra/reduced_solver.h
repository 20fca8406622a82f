// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_REDUCED_SOLVER_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_REDUCED_SOLVER_H

/// \file linear_algebra/reduced_solver.h
/// \brief Solvers for systems in which some quaternionic unknowns are restricted to planes.

#include <Conformal_geometry_processing/linear_algebra/reduced/Reduced_hermitian_solver.h>
#include <Conformal_geometry_processing/linear_algebra/reduced/reduced_operators.h>

#endif
