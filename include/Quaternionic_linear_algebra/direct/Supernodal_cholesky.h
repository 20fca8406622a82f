// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/dense/Solver_status.h>
#include <Quaternionic_linear_algebra/direct/Ordering.h>

#include <Eigen/Core>

#include <memory>

namespace Conformal_geometry_processing {
namespace internal {

class Supernodal_structure;

template <class Scalar, class Real>
class Supernodal_factor;

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Sparse Cholesky factorization L L^H of Hermitian positive definite matrices whose entries
/// are real, complex or *quaternions*, without expanding them.
///
/// A quaternionic matrix of size n costs 16 times the operations and 4 times the memory of a real
/// one; the equivalent real matrix of size 4n costs 64 and 16 times as much. Ordering and symbolic
/// analysis use the n x n graph. Multifrontal, with dense kernels for the vector registers of the
/// machine (`vector_unit()`); needs no BLAS. The memory of the factor is reused by the next
/// factorization. Uses up to `number_of_threads()` threads; the results are bitwise independent of
/// their number.
///
/// A factor that serves as a preconditioner only (`factorize_preconditioner()`) is computed in
/// single precision, and most of it is stored in 16 bits, where that suffices.
///
/// \tparam Scalar_ `double`, `std::complex<double>`, `Quaternion<double>`, `float` or
/// `Quaternion<float>`, the instances in the compiled library.
/// \cgalModels{SparseHermitianSolver}
template <class Scalar_>
class Supernodal_cholesky {
 public:
  using Scalar = Scalar_;
  using FT = typename internal::Scalar_traits<Scalar>::FT;

  Supernodal_cholesky();
  ~Supernodal_cholesky();
  Supernodal_cholesky(const Supernodal_cholesky&) = delete;
  Supernodal_cholesky& operator=(const Supernodal_cholesky&) = delete;

  /// Uses an approximate minimum degree ordering
  Solver_status analyze(const Sparse_pattern& pattern);

  /// Uses the given ordering of the vertices
  Solver_status analyze(const Sparse_pattern& pattern, const internal::Ordering& order);

  /// Chooses between minimum degree and geometric nested dissection (`choose_structure()`)
  /// \param positions 3 x n, the positions of the vertices
  Solver_status analyze_with_positions(const Sparse_pattern& pattern,
                                       const Eigen::Matrix3Xd& positions);

  /// Shares a structure for the same pattern
  Solver_status analyze_with_structure(
      const Sparse_pattern& pattern,
      std::shared_ptr<const internal::Supernodal_structure> structure);

  /// Shares the structure of another solver for the same pattern
  template <class OtherScalar>
  Solver_status analyze_like(const Sparse_pattern& pattern,
                             const Supernodal_cholesky<OtherScalar>& other)
  {
    return analyze_with_structure(pattern, other.structure());
  }

  const internal::Ordering& ordering() const { return m_ordering; }

  /// Symbolic factorization, which depends on the pattern only; null before `analyze()`
  const std::shared_ptr<const internal::Supernodal_structure>& structure() const
  {
    return m_structure;
  }

  Solver_status factorize(const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift);

  /// \brief Factorizes A + diag(shift) for `precondition()` only: to four digits, or like
  /// `factorize()` where a pivot in single precision is not positive.
  Solver_status factorize_preconditioner(const Hermitian_sparse_matrix<Scalar>& A,
                                         const Vector<FT>& shift);

  /// \brief Releases the memory of the factor; the structure stays. The next factorization
  /// allocates it anew.
  void release();

  /// The vertex whose pivot was not positive in the last factorization, -1 if there was none
  int bad_vertex() const { return m_bad_vertex; }

  /// \pre `factorize()` was the last factorization, otherwise the status is
  /// `Solver_status::wrong_state`
  Solver_status solve(const Block<Scalar>& b, Block<Scalar>& x) const;

  /// solves with the last factor of either precision
  Solver_status precondition(const Block<Scalar>& b, Block<Scalar>& x) const;

  Solver_statistics statistics() const;

 private:
  template <class Number>
  using Factor = internal::Supernodal_factor<Scalar, Number>;

  static constexpr int pack_at_least = 4096;  // entries, for each thread

  /// what the last factorization has left
  enum class State { no_factor, factor, rough_factor };

  int size() const { return static_cast<int>(m_ordering.size()); }
  bool matches(const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift) const;

  template <class Number>
  Solver_status factorize(const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift,
                          Factor<Number>& factor, State state);
  template <class Number>
  Solver_status solve(const Factor<Number>& factor, const Block<Scalar>& b, Block<Scalar>& x) const;
  template <int numbers, class Number>
  bool substitute(const Factor<Number>& factor, const Block<Scalar>& b, Eigen::Index begin,
                  Eigen::Index end, Block<Scalar>& x) const;
  template <class Number>
  void pack(const Block<Scalar>& b, Eigen::Index c, int columns, const FT* units, Number* to) const;
  template <class Number>
  void unpack(const Number* from, Eigen::Index c, int columns, const FT* units,
              Block<Scalar>& x) const;

  FT scale(int k) const { return m_scale.size() > 0 ? m_scale[k] : FT(1); }

  internal::Ordering m_ordering;
  int m_entries = 0;
  std::shared_ptr<const internal::Supernodal_structure> m_structure;
  std::unique_ptr<Factor<FT>> m_factor;
  std::unique_ptr<Factor<float>> m_rough_factor;  // null before the first one
  Vector<FT> m_scale;                             // of the last factorization, if it was rough
  State m_state = State::no_factor;
  int m_bad_vertex = -1;
};

/// \ingroup PkgLinearAlgebra
/// \brief The library's own solvers, for real and quaternionic matrices.
/// \cgalModels{SparseHermitianSolverTraits}
struct Supernodal_solver_traits {
  template <class Scalar>
  using Solver = Supernodal_cholesky<Scalar>;
};

}  // namespace Conformal_geometry_processing
