// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_LAGGED_SOLVER_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_LAGGED_SOLVER_TEMPLATES_H

#include <Conformal_geometry_processing/linear_algebra/dense/Solver_status.h>
#include <Conformal_geometry_processing/linear_algebra/dense/block_operators.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Lagged_solver.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace Conformal_geometry_processing {

template <class Solver_>
Solver_status internal::Lagged_solver<Solver_>::analyze(const Sparse_pattern& pattern)
{
  return adopt(pattern, m_solver.analyze(pattern));
}

template <class Solver_>
Solver_status internal::Lagged_solver<Solver_>::analyze(const Sparse_pattern& pattern,
                                                        const internal::Ordering& order)
{
  return adopt(pattern, m_solver.analyze(pattern, order));
}

template <class Solver_>
Solver_status internal::Lagged_solver<Solver_>::analyze_with_positions(
    const Sparse_pattern& pattern, const Eigen::Matrix3Xd& positions)
{
  return adopt(pattern, m_solver.analyze_with_positions(pattern, positions));
}

template <class Solver_>
Solver_status internal::Lagged_solver<Solver_>::factorize(const Hermitian_sparse_matrix<Scalar>& A,
                                                          const Vector<FT>& shift)
{
  return internal::guarded([&] {
    const int n = static_cast<int>(ordering().size());
    if (n == 0 || A.size() != n || A.pattern().size_of_entries() != m_entries ||
        (shift.size() != 0 && shift.size() != n))
      return Solver_status::wrong_state;
    m_is_ready = m_is_current = false;
    m_A = A;
    m_shift = shift;
    if (!add_shift()) return Solver_status::numerical_issue;
    const bool is_worn = m_rule.begin_step();
    if (is_worn || !m_has_factor || !has_positive_diagonal()) return renew();
    m_is_ready = true;
    return Solver_status::success;
  });
}

template <class Solver_>
Solver_status internal::Lagged_solver<Solver_>::solve(const Block<Scalar>& b,
                                                      Block<Scalar>& x) const
{
  return internal::guarded([&] {
    if (!m_is_ready || b.rows() != m_A.size()) return Solver_status::wrong_state;
    m_iterations = 0;
    if (!m_is_current) {
      if (iterate(b, x)) return Solver_status::success;
      const Solver_status status = renew_in_the_midst();
      if (status != Solver_status::success) return status;
    }
    return m_solver.solve(b, x);
  });
}

template <class Solver_>
Solver_status internal::Lagged_solver<Solver_>::precondition(const Block<Scalar>& b,
                                                             Block<Scalar>& x) const
{
  return internal::guarded([&] {
    if (!m_is_ready || b.rows() != m_A.size()) return Solver_status::wrong_state;
    if (!m_is_current && m_rule.budget() <= 0) {
      const Solver_status status = renew_preconditioner();
      if (status != Solver_status::success) return status;
    }
    m_rule.add(work_per_preconditioned_pass * passes(b));
    return apply_inverse(m_solver, b, x);
  });
}

template <class Solver_>
void internal::Lagged_solver<Solver_>::release()
{
  release_factor(m_solver);
  m_has_factor = m_is_ready = m_is_current = false;
}

template <class Solver_>
Solver_statistics internal::Lagged_solver<Solver_>::statistics() const
{
  Solver_statistics s = m_solver.statistics();
  if (s.factor_entries > 0) s.bytes += static_cast<double>(sizeof(Scalar)) * m_entries;
  return s;
}

template <class Solver_>
double internal::Lagged_solver<Solver_>::passes(const Block<Scalar>& b)
{
  return std::ceil(static_cast<double>(b.cols()) * planes / 4);
}

template <class Solver_>
Solver_status internal::Lagged_solver<Solver_>::adopt(const Sparse_pattern& pattern,
                                                      Solver_status status)
{
  m_entries = pattern.size_of_entries();
  m_has_factor = m_is_ready = m_is_current = false;
  m_factorizations = m_iterations = 0;
  m_rule = {};
  return status;
}

// Returns false if a value is not finite.
template <class Solver_>
bool internal::Lagged_solver<Solver_>::add_shift()
{
  bool is_finite = true;
  for (Eigen::Index j = 0; j < m_shift.size(); ++j)
    m_A.value(diagonal_position(j)) += internal::Scalar_traits<Scalar>::from_real(m_shift[j]);
  for (int k = 0; k < m_entries; ++k) {
    FT c[planes];
    internal::Scalar_planes<Scalar>::get(m_A.value(k), c);
    for (const FT number : c) is_finite = is_finite && std::isfinite(number);
  }
  return is_finite;
}

template <class Solver_>
int internal::Lagged_solver<Solver_>::diagonal_position(Eigen::Index j) const
{
  return m_A.pattern().offsets[static_cast<std::size_t>(j)];
}

// A diagonal entry that is not positive shows without iterations that the matrix is not definite.
template <class Solver_>
bool internal::Lagged_solver<Solver_>::has_positive_diagonal() const
{
  for (int j = 0; j < m_A.size(); ++j)
    if (!(m_A.diagonal(j) > 0)) return false;
  return true;
}

template <class Solver_>
Solver_status internal::Lagged_solver<Solver_>::renew(const Vector<FT>& more) const
{
  m_has_factor = m_is_ready = m_is_current = false;
  ++m_factorizations;
  const Solver_status status = m_solver.factorize(m_A, more);
  if (status != Solver_status::success) return status;
  m_has_factor = m_is_ready = true;
  m_is_current = more.size() == 0;
  m_rule.set_price(factorization_price(m_solver.statistics(), planes));
  m_rule.renewed();
  return status;
}

template <class Solver_>
Solver_status internal::Lagged_solver<Solver_>::renew_in_the_midst() const
{
  const Solver_status status = renew();
  m_rule.renewed_in_the_midst();
  return status;
}

// A shift that guards against rounding may turn out too small. factorize() would have failed, and
// the caller would have retried with a larger shift; as a preconditioner, a factor with a larger
// shift is still valid.
template <class Solver_>
Solver_status internal::Lagged_solver<Solver_>::renew_preconditioner() const
{
  const Solver_status status = renew_in_the_midst();
  if (status != Solver_status::not_positive_definite || m_shift.size() == 0) return status;
  return renew(9 * m_shift);
}

// Conjugate gradients, as long as they are cheaper than a factorization and a direct solve.
template <class Solver_>
bool internal::Lagged_solver<Solver_>::iterate(const Block<Scalar>& b, Block<Scalar>& x) const
{
  const double direct = passes(b), work = work_per_pass * direct;
  const auto precondition = [&](const Block<Scalar>& r, Block<Scalar>& z) {
    if (apply_inverse(m_solver, r, z) != Solver_status::success)
      z = r * std::numeric_limits<FT>::quiet_NaN();
  };
  internal::Conjugate_gradients_options options;
  options.tolerance = static_cast<double>(m_tolerance);
  options.max_iterations = work == 0 ? 0 : static_cast<int>((m_rule.budget() + direct) / work);
  Block<Scalar> solution;
  const auto result = conjugate_gradients(block_operator(m_A), precondition, b, solution, options);
  m_iterations = result.iterations;
  m_rule.add(work * result.iterations - direct);
  if (result.converged) x = std::move(solution);
  return result.converged;
}

}  // namespace Conformal_geometry_processing

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
namespace Conformal_geometry_processing {

extern template class internal::Lagged_solver<Supernodal_cholesky<double>>;
extern template class internal::Lagged_solver<Supernodal_cholesky<Quaternion<double>>>;

}  // namespace Conformal_geometry_processing
#endif

#endif
