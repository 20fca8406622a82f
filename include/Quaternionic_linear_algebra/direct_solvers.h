// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

/// \file direct_solvers.h
/// \brief Sparse Cholesky factorizations of real, complex and quaternionic matrices, and solvers
/// for singular systems, for systems with prescribed values, and for those in which some
/// quaternionic unknowns are restricted to planes.

#include <Quaternionic_linear_algebra/direct/Default_solver_traits.h>
#include <Quaternionic_linear_algebra/direct/Dirichlet_solver.h>
#include <Quaternionic_linear_algebra/direct/Grounded_solver.h>
#include <Quaternionic_linear_algebra/direct/Ordering.h>
#include <Quaternionic_linear_algebra/direct/Supernodal_cholesky.h>
#include <Quaternionic_linear_algebra/reduced/Reduced_hermitian_solver.h>
