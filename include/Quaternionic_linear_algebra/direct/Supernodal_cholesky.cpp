// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/direct/Supernodal_cholesky.h>

#include <Quaternionic_linear_algebra/direct/Supernodal_factor.h>
#include <Quaternionic_linear_algebra/direct/Supernodal_substitution.h>
#include <Quaternionic_linear_algebra/direct/choose_ordering.h>
#include <Quaternionic_linear_algebra/threads/Thread_team.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace Conformal_geometry_processing {
namespace internal {

/// Powers of two by which rows and columns of A + diag(shift) are multiplied for a diagonal of
/// about 1, so that the rows of the factor, too, have the size 1 and one rounding suits all of them
template <class Scalar, class FT>
Vector<FT> unit_scale(const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift)
{
  Vector<FT> scale(A.size());
  for (int i = 0; i < A.size(); ++i) {
    const int diagonal = A.pattern().offsets[static_cast<std::size_t>(i)];
    const FT size =
        Scalar_traits<Scalar>::real(A.value(diagonal)) + (shift.size() > 0 ? shift[i] : FT(0));
    const int half = static_cast<int>(std::floor(std::ilogb(size) / 2.));
    scale[i] = size > 0 && std::isfinite(size) ? std::ldexp(FT(1), -half) : FT(1);
  }
  return scale;
}

}  // namespace internal

template <class Scalar>
Supernodal_cholesky<Scalar>::Supernodal_cholesky() = default;

template <class Scalar>
Supernodal_cholesky<Scalar>::~Supernodal_cholesky() = default;

template <class Scalar>
Solver_status Supernodal_cholesky<Scalar>::analyze(const Sparse_pattern& pattern)
{
  return internal::guarded([&] { return analyze(pattern, amd_ordering(pattern)); });
}

template <class Scalar>
Solver_status Supernodal_cholesky<Scalar>::analyze(const Sparse_pattern& pattern,
                                                   const internal::Ordering& order)
{
  return internal::guarded([&] {
    const bool fits = order.size() == static_cast<std::size_t>(pattern.size()) &&
                      !inverse_permutation(order).empty();
    const Solver_status status = analyze_with_structure(
        pattern, fits ? std::make_shared<internal::Supernodal_structure>(pattern, order) : nullptr);
    if (fits) m_ordering = order;
    return status;
  });
}

template <class Scalar>
Solver_status Supernodal_cholesky<Scalar>::analyze_with_positions(const Sparse_pattern& pattern,
                                                                  const Eigen::Matrix3Xd& positions)
{
  const int factorizations = 2;  // a spin transformation often needs a second one
  return internal::guarded([&] {
    const bool fits = pattern.size() > 0 && positions.cols() == pattern.size();
    return analyze_with_structure(
        pattern, fits ? choose_structure(pattern, &positions, factorizations) : nullptr);
  });
}

template <class Scalar>
Solver_status Supernodal_cholesky<Scalar>::analyze_with_structure(
    const Sparse_pattern& pattern, std::shared_ptr<const internal::Supernodal_structure> structure)
{
  return internal::guarded([&] {
    m_factor.reset();
    m_rough_factor.reset();
    m_structure.reset();
    m_state = State::no_factor;
    if (!structure || structure->size_of_columns() != pattern.size())
      return Solver_status::wrong_state;
    m_entries = pattern.size_of_entries();
    m_ordering = structure->order();
    m_structure = std::move(structure);
    m_factor = std::make_unique<Factor<FT>>(m_structure);
    return Solver_status::success;
  });
}

template <class Scalar>
bool Supernodal_cholesky<Scalar>::matches(const Hermitian_sparse_matrix<Scalar>& A,
                                          const Vector<FT>& shift) const
{
  return m_factor && A.size() == size() && A.pattern().size_of_entries() == m_entries &&
         (shift.size() == 0 || shift.size() == A.size());
}

template <class Scalar>
Solver_status Supernodal_cholesky<Scalar>::factorize(const Hermitian_sparse_matrix<Scalar>& A,
                                                     const Vector<FT>& shift)
{
  return internal::guarded([&] {
    if (!matches(A, shift)) return Solver_status::wrong_state;
    if (m_rough_factor) m_rough_factor->release();
    return factorize(A, shift, *m_factor, State::factor);
  });
}

template <class Scalar>
Solver_status Supernodal_cholesky<Scalar>::factorize_preconditioner(
    const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift)
{
  if (std::is_same_v<FT, float>) return factorize(A, shift);
  return internal::guarded([&] {
    if (!matches(A, shift)) return Solver_status::wrong_state;
    m_state = State::no_factor;  // also if memory is short
    m_factor->release();
    if (!m_rough_factor) m_rough_factor = std::make_unique<Factor<float>>(m_structure, true);
    const Solver_status rough = factorize(A, shift, *m_rough_factor, State::rough_factor);
    if (rough != Solver_status::not_positive_definite) return rough;
    return factorize(A, shift);
  });
}

template <class Scalar>
template <class Number>
Solver_status Supernodal_cholesky<Scalar>::factorize(const Hermitian_sparse_matrix<Scalar>& A,
                                                     const Vector<FT>& shift,
                                                     Factor<Number>& factor, State state)
{
  m_state = State::no_factor;
  if (!internal::is_finite(A) || !shift.allFinite()) return Solver_status::numerical_issue;
  m_scale = state == State::rough_factor ? internal::unit_scale(A, shift) : Vector<FT>();
  m_bad_vertex = factor.factorize(A, shift, m_scale);
  if (m_bad_vertex >= 0) return Solver_status::not_positive_definite;
  m_state = state;
  return Solver_status::success;
}

template <class Scalar>
void Supernodal_cholesky<Scalar>::release()
{
  m_state = State::no_factor;
  if (m_factor) m_factor->release();
  if (m_rough_factor) m_rough_factor->release();
}

template <class Scalar>
Solver_status Supernodal_cholesky<Scalar>::solve(const Block<Scalar>& b, Block<Scalar>& x) const
{
  return m_state == State::factor ? solve(*m_factor, b, x) : Solver_status::wrong_state;
}

template <class Scalar>
Solver_status Supernodal_cholesky<Scalar>::precondition(const Block<Scalar>& b,
                                                        Block<Scalar>& x) const
{
  return m_state == State::rough_factor ? solve(*m_rough_factor, b, x) : solve(b, x);
}

template <class Scalar>
template <class Number>
Solver_status Supernodal_cholesky<Scalar>::solve(const Factor<Number>& factor,
                                                 const Block<Scalar>& b, Block<Scalar>& x) const
{
  // Right-hand sides per pass, in numbers: memory-bound, so twice as many cost little more.
  constexpr int narrow = 4, wide = 8, planes = internal::Scalar_planes<Scalar>::size;
  return internal::guarded([&] {
    if (b.rows() != size()) return Solver_status::wrong_state;
    // In a single pass, the solution is written directly to an x of the right size.
    const bool is_direct =
        b.cols() <= wide / planes && x.rows() == b.rows() && x.cols() == b.cols();
    Block<Scalar> other;
    if (!is_direct) other.resize(b.rows(), b.cols());
    Block<Scalar>& solution = is_direct ? x : other;
    const Eigen::Index rest = b.cols() % (wide / planes),
                       first = b.cols() - (rest <= narrow / planes ? rest : 0);
    constexpr int least = planes == 1 ? 1 : narrow;
    const bool is_solved = substitute<wide>(factor, b, 0, first, solution) &&
                           (rest == 1 ? substitute<least>(factor, b, first, b.cols(), solution)
                                      : substitute<narrow>(factor, b, first, b.cols(), solution));
    if (!is_solved) return Solver_status::numerical_issue;
    if (!is_direct) x = std::move(other);
    return Solver_status::success;
  });
}

template <class Scalar>
Solver_statistics Supernodal_cholesky<Scalar>::statistics() const
{
  constexpr int planes = internal::Scalar_planes<Scalar>::size;
  Solver_statistics s;
  if (!m_factor) return s;
  s.factor_entries = m_factor->structure().stored_entries();
  s.flops = m_factor->structure().operations() * planes * planes;
  s.bytes = static_cast<double>(m_state == State::rough_factor ? m_rough_factor->bytes()
                                                               : m_factor->bytes());
  return s;
}

// Solves for the columns begin <= c < end; returns false if the solution is not finite.
template <class Scalar>
template <int numbers, class Number>
bool Supernodal_cholesky<Scalar>::substitute(const Factor<Number>& factor, const Block<Scalar>& b,
                                             Eigen::Index begin, Eigen::Index end,
                                             Block<Scalar>& x) const
{
  if (begin == end) return true;
  internal::Supernodal_substitution<Scalar, Number, numbers> substitution(factor);
  constexpr int columns = internal::Supernodal_substitution<Scalar, Number, numbers>::columns;
  internal::Aligned_array<Number> packed;
  packed.resize(static_cast<std::int64_t>(size()) * numbers);
  for (Eigen::Index c = begin; c < end; c += columns) {
    std::array<FT, columns> units;
    for (int i = 0; i < columns; ++i)
      units[static_cast<std::size_t>(i)] =
          std::is_same_v<Number, FT> || c + i >= end
              ? 1
              : internal::power_of_two<Scalar>(size(), [&](std::ptrdiff_t k) {
                  return b(k, c + i) * scale(static_cast<int>(k));
                });
    pack(b, c, columns, units.data(), packed.data());
    substitution.solve(packed.data());
    if (!internal::is_finite(packed)) return false;
    unpack(packed.data(), c, columns, units.data(), x);
  }
  return true;
}

// Packs columns of b, from c on, in elimination order, as multiples of their units; columns beyond
// the last one are zero.
template <class Scalar>
template <class Number>
void Supernodal_cholesky<Scalar>::pack(const Block<Scalar>& b, Eigen::Index c, int columns,
                                       const FT* units, Number* to) const
{
  constexpr int planes = internal::Scalar_planes<Scalar>::size;
  internal::for_each_index(size(), pack_at_least, [&](int place) {
    const int k = m_structure->order()[static_cast<std::size_t>(place)];
    Number* const at = to + std::int64_t(place) * columns * planes;
    for (int i = 0; i < columns; ++i) {
      FT s[planes] = {};
      if (c + i < b.cols()) internal::Scalar_planes<Scalar>::get(b(k, c + i), s);
      for (int q = 0; q < planes; ++q)
        at[i * planes + q] = static_cast<Number>(s[q] * scale(k) / units[i]);
    }
  });
}

template <class Scalar>
template <class Number>
void Supernodal_cholesky<Scalar>::unpack(const Number* from, Eigen::Index c, int columns,
                                         const FT* units, Block<Scalar>& x) const
{
  constexpr int planes = internal::Scalar_planes<Scalar>::size;
  const Eigen::Index end = (std::min)(c + columns, x.cols());
  internal::for_each_index(size(), pack_at_least, [&](int place) {
    const int k = m_structure->order()[static_cast<std::size_t>(place)];
    const Number* const at = from + std::int64_t(place) * columns * planes;
    for (Eigen::Index i = 0; c + i < end; ++i) {
      FT s[planes];
      for (int q = 0; q < planes; ++q) s[q] = units[i] * scale(k) * at[i * planes + q];
      x(k, c + i) = internal::Scalar_planes<Scalar>::put(s);
    }
  });
}

template class Supernodal_cholesky<double>;
template class Supernodal_cholesky<std::complex<double>>;
template class Supernodal_cholesky<Quaternion<double>>;
template class Supernodal_cholesky<float>;
template class Supernodal_cholesky<Quaternion<float>>;

}  // namespace Conformal_geometry_processing
