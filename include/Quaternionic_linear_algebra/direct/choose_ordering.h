// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/direct/Supernodal_structure.h>

#include <Eigen/Core>

#include <memory>

namespace Conformal_geometry_processing {
namespace internal {

/// \brief Cost model for the choice of an ordering. Only ratios of the times matter, which vary
/// little among machines.
struct Ordering_costs {
  /// Time of one operation of `Supernodal_structure::operations()` on quaternions: 16
  /// multiplications and additions at 160 Gflop/s
  double seconds_per_operation = 2 * 16 / 160e9;

  /// Time of `sweep_nested_dissection()` and of the symbolic analysis
  double seconds_per_vertex = 1e-6;

  /// Share of the operations that dissection saves where minimum degree performs badly
  double expected_saving = 0.45;

  /// Number of operations / n^1.5 of minimum degree (44 to 75 on spheres) up to which the mesh
  /// counts as a collection of limbs: their cuts are short, and dissection was observed to save
  /// less than its time, or nothing.
  double limbs = 20;
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Computes the structure of the factor for an automatically chosen ordering.
///
/// Minimum degree is tried first: it takes half of the time of dissection, and its analysis
/// yields the exact number of operations of a factorization. Dissection, which saves half of them
/// on large compact meshes, is tried only where it may save more than it takes, and the structure
/// with fewer operations is returned. On several threads dissection begins at the same time, and
/// ends where it is not wanted.
///
/// \param positions 3 x n, or null: without positions minimum degree is used
/// \param factorizations expected number of factorizations
std::shared_ptr<const internal::Supernodal_structure> choose_structure(
    const Sparse_pattern& pattern, const Eigen::Matrix3Xd* positions, int factorizations = 1,
    const internal::Ordering_costs& costs = {});

/// \ingroup PkgLinearAlgebra
/// \brief Returns the ordering of `choose_structure()`.
internal::Ordering choose_ordering(const Sparse_pattern& pattern, const Eigen::Matrix3Xd* positions,
                                   int factorizations = 1,
                                   const internal::Ordering_costs& costs = {});

}  // namespace Conformal_geometry_processing
