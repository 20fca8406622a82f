// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

// Matrices are allocated in the library and freed in programs, so both must use the same alignment,
// for any vector units they are compiled for. The targets of CMake define it accordingly.
static_assert(EIGEN_MAX_ALIGN_BYTES == 16 || EIGEN_MAX_ALIGN_BYTES == 0,
              "the compiled library wants EIGEN_MAX_ALIGN_BYTES=16: link its target, or define it "
              "for every file that includes Eigen");
static_assert(EIGEN_MALLOC_ALREADY_ALIGNED == 0 || EIGEN_MAX_ALIGN_BYTES == 0,
              "the compiled library wants EIGEN_MALLOC_ALREADY_ALIGNED=0: Eigen compiled for AVX "
              "never frees what it has allocated without");
