// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_CONFIG_H
#define CONFORMAL_GEOMETRY_PROCESSING_CONFIG_H

#include <Eigen/Core>

// Header-only mode. `X.h` declares, `X_impl.h` defines: the compiled library contains each
// definition once. With CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY (the target
// Conformal_geometry_processing::core_header_only) every X.h includes its X_impl.h, whose functions
// are then inline, and linking is not necessary.
#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#define CGP_INLINE inline
#else
#define CGP_INLINE
// Matrices are allocated in the library and freed in programs, so both must use the same alignment,
// for any vector units they are compiled for. The targets of CMake define it accordingly.
static_assert(EIGEN_MAX_ALIGN_BYTES == 16 || EIGEN_MAX_ALIGN_BYTES == 0,
              "the compiled library wants EIGEN_MAX_ALIGN_BYTES=16: link its target, or define it "
              "for every file that includes Eigen");
static_assert(EIGEN_MALLOC_ALREADY_ALIGNED == 0 || EIGEN_MAX_ALIGN_BYTES == 0,
              "the compiled library wants EIGEN_MALLOC_ALREADY_ALIGNED=0: Eigen compiled for AVX "
              "never frees what it has allocated without");
#endif

#endif
