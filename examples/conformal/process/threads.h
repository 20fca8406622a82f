// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_PROCESS_THREADS_H
#define CONFORMAL_PROCESS_THREADS_H

namespace conformal {

/// \brief Sets the number of threads of the library, the BLAS and OpenMP.
///
/// Results of the library alone are bitwise independent of it; if the BLAS is used, for
/// `--solver cholmod`, the last bits may depend on it.
void set_threads(int count);

}  // namespace conformal

#endif
