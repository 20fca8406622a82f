// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

/// \file multigrid_solver.h
/// \brief Smoothed aggregation for quaternionic and real matrices, with low memory.

#include <Quaternionic_linear_algebra/multigrid/Multigrid_solver.h>
