// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

/// \file reduced_solver.h
/// \brief Solvers for systems in which some quaternionic unknowns are restricted to planes.

#include <Quaternionic_linear_algebra/reduced/Reduced_hermitian_solver.h>
