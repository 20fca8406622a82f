// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_ITERATIVE_SOLVERS_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_ITERATIVE_SOLVERS_H

/// \file linear_algebra/iterative_solvers.h
/// \brief Conjugate gradients.

#include <Conformal_geometry_processing/linear_algebra/krylov/conjugate_gradients.h>

#endif
