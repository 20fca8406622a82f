// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_CHOOSE_ORDERING_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_CHOOSE_ORDERING_H

#include <Conformal_geometry_processing/linear_algebra/direct/Supernodal_structure.h>

#include <Eigen/Core>

#include <memory>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgLinearAlgebra
/// \brief Cost model for the choice of an ordering. Only ratios of the times matter, which vary
/// little among machines.
struct Ordering_costs {
  /// Time of one operation of `Supernodal_structure::operations()` on quaternions: 16
  /// multiplications and additions at 40 Gflop/s
  double seconds_per_operation = 16 / 40e9;

  /// Time of `sweep_nested_dissection()` and of the symbolic analysis
  double seconds_per_vertex = 1.4e-6;

  /// Time of minimum degree ordering and of the symbolic analysis
  double seconds_per_vertex_by_degree = 0.4e-6;

  /// Share of the operations saved by the better ordering if the other one performs badly
  double expected_saving = 0.45;

  /// Number of vertices from which on dissection is tried first
  int large = 12000;

  /// Range of operations / n^1.5 of dissection (32 on a sphere) in which minimum degree has not
  /// been observed to be better. Smaller values indicate collections of long limbs; larger ones
  /// indicate graphs that are not surfaces, or misleading positions.
  double compact = 18, not_a_surface = 60;
};

// The structures that `choose_structure()` compares.
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
/// \brief Computes the structure of the factor for an automatically chosen ordering.
///
/// On small meshes minimum degree is tried first: it takes a quarter of the time of the
/// alternatives, its analysis yields the exact number of operations of a factorization, and it is
/// often as good as dissection. On large meshes dissection is tried first, which saves half the
/// operations of a compact mesh. The other ordering is tried only if it may save more than the
/// trial costs, and the structure with fewer operations is returned.
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

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/linear_algebra/direct/choose_ordering_impl.h>
#endif

#endif
