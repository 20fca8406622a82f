// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Quaternion.h>
#include <Quaternionic_linear_algebra/direct/Supernodal_factor.h>
#include <Quaternionic_linear_algebra/direct/Supernodal_structure.h>

namespace Conformal_geometry_processing::internal {

/// \brief Solves L L^H x = b for right-hand sides with four or eight numbers per row: four or eight
/// real ones, half as many complex ones, or a quarter of that in quaternions. These fill the vector
/// registers equally well.
///
/// The substitution is memory-bound, so eight numbers take little longer than four. The solution of
/// a right-hand side is bitwise independent of the other right-hand sides and their number.
///
/// In the forward substitution, each front passes the sums for the rows below to its parent, as in
/// the factorization; in the backward substitution, it reads the rows below. Subtrees are
/// therefore tasks for several threads, with bitwise the same results.
///
/// The vector is stored as [row][right-hand side][component], with rows in elimination order.
///
/// \tparam numbers_ per row: 4 or 8, or 1 for scalars of one
template <class Scalar, class Real, int numbers_ = 4>
class Supernodal_substitution {
  using Factor = Supernodal_factor<Scalar, Real>;

 public:
  static constexpr int numbers = numbers_;                               ///< per row
  static constexpr int columns = numbers / Scalar_planes<Scalar>::size;  ///< right-hand sides
  static_assert(numbers == 4 || numbers == 8 || (numbers == 1 && columns == 1));

  /// \throw std::bad_alloc
  explicit Supernodal_substitution(const Factor& factor);

  /// Overwrites b, `numbers` * |V| numbers, by x
  void solve(Real* x);

  /// \brief First half: computes L^-1 b on eliminated rows and the right-hand side of the kept
  /// rows.
  void forward(Real* x);

  /// \brief Second half: expects the solution on the kept rows.
  void backward(Real* x) const;

 private:
  void forward(int begin, int end, Real* x);
  void backward(int begin, int end, Real* x) const;
  void forward(int s, Real* x);
  void backward(int s, Real* x) const;
  Real* rows_of(int s, Real* x) const;
  void prefetch_panel(int s) const;

  const Factor& m_factor;
  const Supernodal_structure& S;
  Front_substitution<Real> m_kernels;
  int m_threads;
  Contribution_stack m_places;
  Aligned_array<Real> m_updates;
};

}  // namespace Conformal_geometry_processing::internal
