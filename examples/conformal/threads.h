// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_THREADS_H
#define CONFORMAL_THREADS_H

namespace conformal {

/// \brief Lets the library, the BLAS and OpenMP use so many threads.
///
/// Results of the library alone are the same to the bit for any number; where the BLAS works, for
/// `--solver cholmod`, the last bits may depend on it.
void set_threads(int count);

}  // namespace conformal

#endif
