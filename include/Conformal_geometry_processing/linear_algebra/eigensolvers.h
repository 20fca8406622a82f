// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

/// \file linear_algebra/eigensolvers.h
/// \brief Eigensolvers for quaternionic Hermitian matrices: smallest eigenpairs, and those nearest
/// to a shift.

#include <Conformal_geometry_processing/linear_algebra/krylov/Lobpcg.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/inverse_power_method.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/krylov_schur.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/subspace_iteration.h>
