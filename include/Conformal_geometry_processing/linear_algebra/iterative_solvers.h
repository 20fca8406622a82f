// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

/// \file linear_algebra/iterative_solvers.h
/// \brief Conjugate gradients.

#include <Conformal_geometry_processing/linear_algebra/krylov/conjugate_gradients.h>
