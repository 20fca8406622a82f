// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_SUPERNODAL_CHOLESKY_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_SUPERNODAL_CHOLESKY_H

#include <Conformal_geometry_processing/linear_algebra/dense/Solver_status.h>
#include <Conformal_geometry_processing/linear_algebra/dense/guarded.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Supernodal_substitution.h>
#include <Conformal_geometry_processing/linear_algebra/direct/amd_ordering.h>
#include <Conformal_geometry_processing/linear_algebra/direct/choose_ordering.h>

#include <Eigen/Core>

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief sparse Cholesky factorization L L^H of Hermitian positive definite matrices whose entries
/// are real, complex or *quaternions*, without expanding them.
///
/// A quaternionic matrix of size n costs 16 times the operations and 4 times the memory of a real
/// one, where the real matrix of size 4n costs 64 and 16 times as much. Ordering and symbolic
/// analysis see the n x n graph only. Multifrontal, with dense kernels of its own for the vector
/// registers of the target; needs no BLAS. The memory of the factor is kept for the next one. Uses
/// up to `number_of_threads()` threads, with the same results to the bit.
///
/// \tparam Scalar_ `double`, `std::complex<double>`, `Quaternion<double>`, or of `float`
/// \tparam Real the numbers of the factor: `float` halves the memory, for a factor that is used as
/// a preconditioner
/// \cgalModels{SparseHermitianSolver}
template <class Scalar_, class Real = typename Scalar_traits<Scalar_>::FT>
class Supernodal_cholesky {
 public:
  using Scalar = Scalar_;
  using FT = typename Scalar_traits<Scalar>::FT;

  Supernodal_cholesky() = default;
  Supernodal_cholesky(const Supernodal_cholesky&) = delete;
  Supernodal_cholesky& operator=(const Supernodal_cholesky&) = delete;

  /// with the ordering of approximate minimum degree
  Solver_status analyze(const Sparse_pattern& pattern)
  {
    return internal::guarded([&] { return analyze(pattern, amd_ordering(pattern)); });
  }

  Solver_status analyze(const Sparse_pattern& pattern, const Ordering& order)
  {
    return internal::guarded([&] {
      const bool fits = order.size() == static_cast<std::size_t>(pattern.size()) &&
                        !inverse_permutation(order).empty();
      const Solver_status status =
          adopt(pattern, fits ? std::make_shared<Supernodal_structure>(pattern, order) : nullptr);
      if (fits) m_ordering = order;
      return status;
    });
  }

  /// with an ordering chosen among minimum degree and dissection in space (`choose_structure()`)
  /// \param positions 3 x n, where the vertices are
  Solver_status analyze_with_positions(const Sparse_pattern& pattern,
                                       const Eigen::Matrix3Xd& positions)
  {
    const int factorizations = 2;  // a spin transformation often needs a second one
    return internal::guarded([&] {
      const bool fits = pattern.size() > 0 && positions.cols() == pattern.size();
      return adopt(pattern, fits ? choose_structure(pattern, &positions, factorizations) : nullptr);
    });
  }

  /// with the structure of another solver for the same pattern, which is shared
  template <class OtherScalar, class OtherReal>
  Solver_status analyze_like(const Sparse_pattern& pattern,
                             const Supernodal_cholesky<OtherScalar, OtherReal>& other)
  {
    return internal::guarded([&] { return adopt(pattern, other.structure()); });
  }

  const Ordering& ordering() const { return m_ordering; }

  /// what depends on the pattern alone; null before `analyze()`
  const std::shared_ptr<const Supernodal_structure>& structure() const { return m_structure; }

  Solver_status factorize(const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift)
  {
    return internal::guarded([&] {
      if (!m_factor || A.size() != size() || A.pattern().size_of_entries() != m_entries ||
          (shift.size() != 0 && shift.size() != A.size()))
        return Solver_status::wrong_state;
      m_is_factorized = false;
      if (!is_finite(A) || !shift.allFinite()) return Solver_status::numerical_issue;
      m_bad_vertex = m_factor->factorize(A, shift);
      m_is_factorized = m_bad_vertex < 0;
      return m_is_factorized ? Solver_status::success : Solver_status::not_positive_definite;
    });
  }

  /// \brief gives the memory of the factor back, which takes a new one as after `analyze()`; the
  /// structure stays.
  void release()
  {
    m_is_factorized = false;
    if (m_factor) m_factor->release();
  }

  /// the vertex whose pivot was not positive in the last factorization, -1 if there was none
  int bad_vertex() const { return m_bad_vertex; }

  Solver_status solve(const Block<Scalar>& b, Block<Scalar>& x) const
  {
    return internal::guarded([&] {
      if (!m_is_factorized || b.rows() != size()) return Solver_status::wrong_state;
      // Solved in one go, x of the right size takes the solution itself.
      const bool is_direct =
          b.cols() <= columns_of<wide> && x.rows() == b.rows() && x.cols() == b.cols();
      Block<Scalar> other;
      if (!is_direct) other.resize(b.rows(), b.cols());
      Block<Scalar>& solution = is_direct ? x : other;
      const Eigen::Index rest = b.cols() % columns_of<wide>,
                         first = b.cols() - (rest <= columns_of<narrow> ? rest : 0);
      if (!substitute<wide>(b, 0, first, solution) ||
          !substitute<narrow>(b, first, b.cols(), solution))
        return Solver_status::numerical_issue;
      if (!is_direct) x = std::move(other);
      return Solver_status::success;
    });
  }

  Solver_statistics statistics() const
  {
    Solver_statistics s;
    if (!m_factor) return s;
    s.factor_entries = m_factor->structure().stored_entries();
    s.flops = m_factor->structure().operations() * planes * planes;
    s.bytes = static_cast<double>(m_factor->bytes());
    return s;
  }

 private:
  using Factor = Supernodal_factor<Scalar, Real>;
  static constexpr int planes = Scalar_planes<Scalar>::size;

  // Numbers per row: twice as many in one go cost little more, for the factor comes from memory.
  static constexpr int narrow = 4, wide = 8;
  template <int numbers>
  static constexpr int columns_of = Supernodal_substitution<Scalar, Real, numbers>::columns;

  Solver_status adopt(const Sparse_pattern& pattern,
                      std::shared_ptr<const Supernodal_structure> structure)
  {
    m_factor.reset();
    m_structure.reset();
    m_is_factorized = false;
    if (!structure || structure->size_of_columns() != pattern.size())
      return Solver_status::wrong_state;
    m_entries = pattern.size_of_entries();
    m_ordering = structure->order();
    m_structure = std::move(structure);
    m_factor.emplace(m_structure);
    return Solver_status::success;
  }

  int size() const { return static_cast<int>(m_ordering.size()); }

  static bool is_finite(const Hermitian_sparse_matrix<Scalar>& A)
  {
    bool is_finite = true;
    for (int k = 0; k < A.pattern().size_of_entries(); ++k) {
      FT c[planes];
      Scalar_planes<Scalar>::get(A.value(k), c);
      for (int q = 0; q < planes; ++q) is_finite = is_finite && std::isfinite(c[q]);
    }
    return is_finite;
  }

  // Solves for the columns begin <= c < end; false if the solution is not finite.
  template <int numbers>
  bool substitute(const Block<Scalar>& b, Eigen::Index begin, Eigen::Index end,
                  Block<Scalar>& x) const
  {
    if (begin == end) return true;
    Supernodal_substitution<Scalar, Real, numbers> substitution(*m_factor);
    Aligned_array<Real> packed;
    packed.resize(static_cast<std::int64_t>(size()) * numbers);
    for (Eigen::Index c = begin; c < end; c += columns_of<numbers>) {
      pack(b, c, columns_of<numbers>, packed.data());
      substitution.solve(packed.data());
      if (!is_finite(packed)) return false;
      unpack(packed.data(), c, columns_of<numbers>, x);
    }
    return true;
  }

  // So many columns of b, from c on, in the order of elimination; those that do not exist are zero.
  void pack(const Block<Scalar>& b, Eigen::Index c, int columns, Real* to) const
  {
    for (int k : m_factor->structure().order())
      for (int i = 0; i < columns; ++i, to += planes) {
        FT s[planes] = {};
        if (c + i < b.cols()) Scalar_planes<Scalar>::get(b(k, c + i), s);
        for (int q = 0; q < planes; ++q) to[q] = static_cast<Real>(s[q]);
      }
  }

  static bool is_finite(const Aligned_array<Real>& numbers)
  {
    bool is_finite = true;
    for (std::int64_t i = 0; i < numbers.size(); ++i)
      is_finite = is_finite && std::isfinite(numbers.data()[i]);
    return is_finite;
  }

  void unpack(const Real* from, Eigen::Index c, int columns, Block<Scalar>& x) const
  {
    for (int k : m_factor->structure().order())
      for (int i = 0; i < columns; ++i, from += planes) {
        if (c + i >= x.cols()) continue;
        FT s[planes];
        for (int q = 0; q < planes; ++q) s[q] = from[q];
        x(k, c + i) = Scalar_planes<Scalar>::put(s);
      }
  }

  Ordering m_ordering;
  int m_entries = 0;
  std::shared_ptr<const Supernodal_structure> m_structure;
  std::optional<Factor> m_factor;
  bool m_is_factorized = false;
  int m_bad_vertex = -1;
};

/// \ingroup PkgLinearAlgebra
/// \brief the library's own solvers, for real and quaternionic matrices; header-only.
/// \cgalModels{SparseHermitianSolverTraits}
struct Supernodal_solver_traits {
  template <class Scalar>
  using Solver = Supernodal_cholesky<Scalar>;
};

/// \ingroup PkgLinearAlgebra
/// \brief the same with the quaternionic factor in single precision: half the memory and about two
/// thirds of the time, for algorithms that use it as a preconditioner only.
///
/// The eigenvalue solver does, and works in double precision itself: its vectors are as exact, for
/// an iteration or two more. Real matrices keep their double precision.
/// \cgalModels{SparseHermitianSolverTraits}
struct Mixed_supernodal_solver_traits {
  template <class Scalar>
  using Solver =
      Supernodal_cholesky<Scalar,
                          std::conditional_t<std::is_floating_point_v<Scalar>, Scalar, float>>;
};

}  // namespace Conformal_geometry_processing

#endif
