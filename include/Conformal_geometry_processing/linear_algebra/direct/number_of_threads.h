// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_NUMBER_OF_THREADS_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_NUMBER_OF_THREADS_H

#include <Conformal_geometry_processing/config.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief how many threads a call of this library may use; 1 if nobody has asked for more.
int number_of_threads();

/// \ingroup PkgLinearAlgebra
/// \brief lets every later call of this library, in the whole process, use up to `threads` threads;
/// 0 or less stands for as many as the machine has.
///
/// The setting is one for the process where the compiled library is shared; where it is linked
/// statically, or used header-only, each shared library of a program has its own.
///
/// Threads live no longer than the call, and calls too small to gain from them use none. Results
/// are the same to the bit for any number of threads. May be called from any thread.
void set_number_of_threads(int threads);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/linear_algebra/direct/number_of_threads_impl.h>
#endif

#endif
