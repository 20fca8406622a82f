// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

/// \file eigensolvers.h
/// \brief Eigensolvers for quaternionic Hermitian matrices: smallest eigenpairs, and those nearest
/// to a shift.

#include <Quaternionic_linear_algebra/krylov/Lobpcg.h>
#include <Quaternionic_linear_algebra/krylov/inverse_power_method.h>
#include <Quaternionic_linear_algebra/krylov/krylov_schur.h>
#include <Quaternionic_linear_algebra/krylov/subspace_iteration.h>
