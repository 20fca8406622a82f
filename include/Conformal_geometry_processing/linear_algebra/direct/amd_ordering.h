// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_AMD_ORDERING_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_AMD_ORDERING_H

#include <Conformal_geometry_processing/algebra/Sparse_pattern.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Ordering.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// Computes an approximate minimum degree ordering (Amestoy, Davis and Duff 1996) with Eigen
internal::Ordering amd_ordering(const Sparse_pattern& pattern);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/linear_algebra/direct/amd_ordering_impl.h>
#endif

#endif
