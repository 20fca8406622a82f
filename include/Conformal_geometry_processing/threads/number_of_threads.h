// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/config.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgThreads
/// \brief Returns the maximal number of threads of a call of this library; the default is 1.
int number_of_threads();

/// \ingroup PkgThreads
/// \brief Sets the maximal number of threads of all later calls of this library in the process; 0
/// or less selects the number of hardware threads, and more than 1024 are 1024.
///
/// The setting is global if the library is compiled as a shared library; if it is linked
/// statically, or used header-only, each shared library of a program has its own setting.
///
/// Threads end with the call, and calls that are too small to benefit use one thread. Results are
/// bitwise the same for any number of threads. May be called from any thread.
void set_number_of_threads(int threads);

}  // namespace Conformal_geometry_processing
