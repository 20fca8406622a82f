// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_CHOOSE_ORDERING_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_CHOOSE_ORDERING_H

#include <Conformal_geometry_processing/linear_algebra/direct/Supernodal_structure.h>

#include <Eigen/Core>

#include <memory>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief what the choice of an ordering reckons with. Only ratios of the times matter, which
/// differ little among machines.
struct Ordering_costs {
  /// of one operation of `Supernodal_structure::operations()` on quaternions: 16 multiplications
  /// and additions at 40 Gflop/s
  double seconds_per_operation = 16 / 40e9;

  /// of `sweep_nested_dissection()` and the analysis of what it finds
  double seconds_per_vertex = 1.4e-6;

  /// the same of minimum degree
  double seconds_per_vertex_by_degree = 0.4e-6;

  /// the share of the operations that the better ordering saves where the other does badly
  double expected_saving = 0.45;

  /// the number of vertices from where on dissection comes first
  int large = 12000;

  /// the range of operations / n^1.5 of dissection (32 on a sphere) where minimum degree has not
  /// been seen to do better. Below it are collections of long limbs, above it no surfaces, or
  /// positions that mislead.
  double compact = 18, not_a_surface = 60;
};

namespace internal {

// The structures that `choose_structure()` weighs against each other.
class Structure_choice {
  using Structure = std::shared_ptr<const Supernodal_structure>;

 public:
  Structure_choice(const Sparse_pattern& pattern, int factorizations, const Ordering_costs& costs);
  Structure by_degree() const;
  Structure by_dissection(const Eigen::Matrix3Xd& positions) const;
  bool may_save(const Structure& other, double seconds_per_vertex) const;
  bool is_compact_surface(const Structure& by_dissection) const;
  static Structure better(Structure a, Structure b);

 private:
  const Sparse_pattern& m_pattern;
  const Ordering_costs& m_costs;
  const int m_factorizations;
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief the structure of the factor for an ordering chosen automatically.
///
/// On small meshes minimum degree comes first: it takes a quarter of the time of anything else, its
/// analysis tells exactly how many operations a factorization will take, and it is often as good as
/// dissection. On large ones dissection comes first, which saves half the operations of a compact
/// mesh. The other is tried only where it may save more than the trial costs, and the structure
/// with fewer operations is kept.
/// \param positions 3 x n, or null: without positions the answer is minimum degree
/// \param factorizations how many are expected to follow, each of the costs given
std::shared_ptr<const Supernodal_structure> choose_structure(const Sparse_pattern& pattern,
                                                             const Eigen::Matrix3Xd* positions,
                                                             int factorizations = 1,
                                                             const Ordering_costs& costs = {});

/// \ingroup PkgLinearAlgebra
/// \brief the ordering of `choose_structure()`.
Ordering choose_ordering(const Sparse_pattern& pattern, const Eigen::Matrix3Xd* positions,
                         int factorizations = 1, const Ordering_costs& costs = {});

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/linear_algebra/direct/choose_ordering_impl.h>
#endif

#endif
