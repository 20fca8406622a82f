// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

namespace conformal {

/// \brief Sets the number of threads of the library, the BLAS and OpenMP.
///
/// Results of the library alone are bitwise independent of it; if the BLAS is used, for
/// `--advanced solver=cholmod`, the last bits may depend on it.
void set_threads(int count);

}  // namespace conformal
