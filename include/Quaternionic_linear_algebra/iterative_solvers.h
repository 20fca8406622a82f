// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

/// \file iterative_solvers.h
/// \brief Conjugate gradients.

#include <Quaternionic_linear_algebra/krylov/conjugate_gradients.h>
