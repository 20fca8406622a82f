// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/multigrid/Multigrid_cycle.h>

#include <Eigen/Core>

#include <cmath>
#include <type_traits>

namespace Conformal_geometry_processing {
namespace internal {

float to_single(double s);
Quaternion<float> to_single(const Quaternion<double>& s);
double to_double(float s);
Quaternion<double> to_double(const Quaternion<float>& s);

/// \ingroup PkgLinearAlgebra
/// \brief The remainder of a matrix after rounding to single precision.
///
/// The rounded matrix is used by preconditioners; its sum with the remainder, also in single
/// precision, represents the matrix to 14 digits. Both take half of the memory that a copy in
/// double precision beside the rounded matrix would take.
///
/// \tparam Scalar `double` or `Quaternion<double>`
template <class Scalar>
class Rounding_remainder {
 public:
  using FT = typename Scalar_traits<Scalar>::FT;
  using Entry = std::conditional_t<std::is_same_v<Scalar, double>, float, Quaternion<float>>;
  using Rounded = Hermitian_sparse_matrix<Entry>;

  /// \brief Returns A + diag(shift), rounded, on the shared pattern of A; stores the remainder.
  /// \param shift one number per row, or empty
  Rounded split(const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift)
  {
    Rounded rounded(A.shared_pattern());
    m_values.resize(A.pattern().size_of_entries());
    m_is_finite = true;
    const int* const offsets = A.pattern().offsets.data();
    for (int j = 0; j < A.size(); ++j)
      for (int k = offsets[j]; k < offsets[j + 1]; ++k) {
        Scalar a = A.value(k);
        if (k == offsets[j] && shift.size() > 0) a += Scalar_traits<Scalar>::from_real(shift[j]);
        rounded.value(k) = internal::to_single(a);
        const Scalar rest = a - internal::to_double(rounded.value(k));
        m_values[k] = internal::to_single(rest);
        m_is_finite = m_is_finite && std::isfinite(sum_of_components(rest));
      }
    return rounded;
  }

  /// Returns whether all values of the last matrix, and their roundings, were finite
  bool is_finite() const { return m_is_finite; }

  /// Computes y = A x in the memory of y, where `rounded` was returned by `split(A)`
  void multiply(const Rounded& rounded, const Block<Scalar>& x, Block<Scalar>& y) const
  {
    y.resize(x.rows(), x.cols());
    const int* const offsets = rounded.pattern().offsets.data();
    const int* const rows = rounded.pattern().indices.data();
    // Backward, so that y_i is assigned before the columns left of i add to it.
    for (Eigen::Index c = 0; c < x.cols(); ++c)
      for (int j = rounded.size() - 1; j >= 0; --j) {
        Scalar sum = value(rounded, offsets[j]) * x(j, c);
        for (int k = offsets[j] + 1; k < offsets[j + 1]; ++k) {
          const Scalar a = value(rounded, k);
          sum += conjugate(a) * x(rows[k], c);
          y(rows[k], c) += a * x(j, c);
        }
        y(j, c) = sum;
      }
  }

  double bytes() const { return static_cast<double>(sizeof(Entry)) * double(m_values.size()); }

  /// Releases the memory
  void release() { m_values.resize(0); }

 private:
  static double sum_of_components(double s) { return s; }
  static double sum_of_components(const Quaternion<double>& s) { return s.w + s.x + s.y + s.z; }

  Scalar value(const Rounded& rounded, int k) const
  {
    return internal::to_double(rounded.value(k)) + internal::to_double(m_values[k]);
  }

  Vector<Entry> m_values;  // parallel to those of the rounded matrix
  bool m_is_finite = true;
};

/// \ingroup PkgLinearAlgebra
/// \brief Solves by smoothed aggregation multigrid; for large meshes, where the factor of a direct
/// solver takes too much time or memory.
///
/// One V-cycle, the preconditioner, costs two passes over the matrix in single precision, and a
/// sixth of that on the coarser levels. `solve()` runs conjugate gradients with it, in double
/// precision. The number of iterations depends on the aspect ratios of the triangles but not on
/// their number: 10 to 30 on smooth meshes, several times as many on difficult scans.
///
/// Matrices of at most `direct_size` rows are factorized, and solved up to rounding. For larger
/// ones positive definiteness is only partially checked: on the diagonals of all levels, in the
/// factor of the coarsest one, and by the curvatures in conjugate gradients.
///
/// Stores the matrix as two parts in single precision (`Rounding_remainder`), and shares the
/// pattern. Memory: 240 bytes per vertex of a triangle mesh for quaternionic matrices, 110 for real
/// ones.
///
/// \tparam Scalar_ `double` or `Quaternion<double>`
/// \cgalModels{SparseHermitianSolver}
template <class Scalar_>
class Multigrid_solver {
 public:
  using Scalar = Scalar_;
  using FT = typename Scalar_traits<Scalar>::FT;

  /// Matrices of at most this size are factorized directly
  static constexpr int direct_size = 500;

  /// Relative error of `solve()` in the energy norm
  static constexpr double tolerance = 1e-10;

  /// Maximal number of iterations of `solve()`
  static constexpr int max_iterations = 500;

  explicit Multigrid_solver(const Multigrid_options& options = {}) : m_options(options) {}
  Multigrid_solver(const Multigrid_solver&) = delete;
  Multigrid_solver& operator=(const Multigrid_solver&) = delete;

  /// Keeps the order of the rows, except for matrices that will be factorized directly
  Solver_status analyze(const Sparse_pattern& pattern);

  /// \param order is returned by `ordering()`; large matrices are processed in the order of their
  /// rows
  Solver_status analyze(const Sparse_pattern& pattern, const Ordering& order);

  /// Ignores the positions
  Solver_status analyze_with_positions(const Sparse_pattern& pattern, const Eigen::Matrix3Xd&);

  /// Copies the ordering
  template <class OtherSolver>
  Solver_status analyze_like(const Sparse_pattern& pattern, const OtherSolver& other)
  {
    return analyze(pattern, other.ordering());
  }

  const Ordering& ordering() const { return m_ordering; }

  /// Rebuilds the levels, because aggregates depend on the values
  Solver_status factorize(const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift);

  /// Releases the memory of the levels; the analysis stays
  void release();

  /// \brief Computes x = T b for every column, where T is one V-cycle: a fixed Hermitian positive
  /// definite approximation of the inverse of the factorized matrix.
  /// \param x may be b; its memory is reused if it has the right size
  Solver_status precondition(const Block<Scalar>& b, Block<Scalar>& x) const;

  /// \returns `numerical_issue` also if `max_iterations` do not reach the `tolerance`
  Solver_status solve(const Block<Scalar>& b, Block<Scalar>& x) const;

  /// Number of iterations of the last successful `solve()`; zero if it was direct
  int iterations() const { return m_iterations; }

  /// The levels; empty if the solver is direct
  const Multigrid_cycle<typename Rounding_remainder<Scalar>::Entry>& cycle() const;

  /// \brief Counts the entries of all levels and of the factor of the coarsest one.
  ///
  /// The levels depend on the values; before `factorize()` only the entries of the matrix are
  /// known.
  Solver_statistics statistics() const;

 private:
  static constexpr int columns = 4 / Scalar_planes<Scalar>::size;
  enum class State { empty, analyzed, factorized };

  int size() const { return static_cast<int>(m_ordering.size()); }
  bool is_direct() const { return size() <= direct_size; }
  bool is_ready(const Block<Scalar>& b) const;
  Solver_status build(const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift);
  Solver_status iterate(const Block<Scalar>& b, Block<Scalar>& x) const;
  static void load(const Block<Scalar>& b, int i, Eigen::Index c, double* to);
  static void store(const double* from, int i, Eigen::Index c, Block<Scalar>& x);

  Multigrid_options m_options;
  State m_state = State::empty;
  Ordering m_ordering;
  int m_entries = 0;
  Supernodal_cholesky<Scalar> m_direct;
  Rounding_remainder<Scalar> m_remainder;
  // Mutable work vectors of the cycle, which are not part of the visible state.
  mutable Multigrid_cycle<typename Rounding_remainder<Scalar>::Entry> m_cycle;
  mutable int m_iterations = 0;
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Multigrid for real and quaternionic matrices.
/// \cgalModels{SparseHermitianSolverTraits}
struct Multigrid_solver_traits {
  template <class Scalar>
  using Solver = internal::Multigrid_solver<Scalar>;
};

}  // namespace Conformal_geometry_processing
