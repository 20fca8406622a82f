// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_THREADS_H
#define CONFORMAL_THREADS_H

namespace conformal {

/// Lets the BLAS and OpenMP use so many threads. The last bits of a result depend on the number.
void set_threads(int count);

}  // namespace conformal

#endif
