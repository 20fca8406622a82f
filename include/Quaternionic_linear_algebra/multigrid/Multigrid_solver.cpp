// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/multigrid/Multigrid_solver.h>

#include <Quaternionic_linear_algebra/algebra/Quaternion.h>
#include <Quaternionic_linear_algebra/dense/Solver_status.h>
#include <Quaternionic_linear_algebra/direct/Ordering.h>
#include <Quaternionic_linear_algebra/krylov/conjugate_gradients.h>

#include <Eigen/Core>

#include <cstddef>
#include <numeric>
#include <utility>

namespace Conformal_geometry_processing {
namespace internal {

float to_single(double s)
{
  return static_cast<float>(s);
}

Quaternion<float> to_single(const Quaternion<double>& s)
{
  return {to_single(s.w), to_single(s.x), to_single(s.y), to_single(s.z)};
}

double to_double(float s)
{
  return static_cast<double>(s);
}

Quaternion<double> to_double(const Quaternion<float>& s)
{
  return {to_double(s.w), to_double(s.x), to_double(s.y), to_double(s.z)};
}

}  // namespace internal

template <class Scalar_>
Solver_status internal::Multigrid_solver<Scalar_>::analyze(const Sparse_pattern& pattern)
{
  return internal::guarded([&] {
    if (pattern.size() <= direct_size) return analyze(pattern, amd_ordering(pattern));
    internal::Ordering identity(static_cast<std::size_t>(pattern.size()));
    std::iota(identity.begin(), identity.end(), 0);
    return analyze(pattern, identity);
  });
}

template <class Scalar_>
Solver_status internal::Multigrid_solver<Scalar_>::analyze(const Sparse_pattern& pattern,
                                                           const internal::Ordering& order)
{
  return internal::guarded([&] {
    m_state = State::empty;
    m_cycle.release();
    if (pattern.size() == 0 || order.size() != static_cast<std::size_t>(pattern.size()) ||
        inverse_permutation(order).empty())
      return Solver_status::wrong_state;
    m_entries = pattern.size_of_entries();
    m_ordering = order;
    const Solver_status status =
        is_direct() ? m_direct.analyze(pattern, order) : Solver_status::success;
    if (status == Solver_status::success) m_state = State::analyzed;
    return status;
  });
}

template <class Scalar_>
Solver_status internal::Multigrid_solver<Scalar_>::analyze_with_positions(
    const Sparse_pattern& pattern, const Eigen::Matrix3Xd&)
{
  return analyze(pattern);
}

template <class Scalar_>
Solver_status internal::Multigrid_solver<Scalar_>::factorize(
    const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift)
{
  return internal::guarded([&] {
    if (m_state == State::empty || A.size() != size() ||
        A.pattern().size_of_entries() != m_entries ||
        (shift.size() != 0 && shift.size() != A.size()))
      return Solver_status::wrong_state;
    release();
    const Solver_status status = is_direct() ? m_direct.factorize(A, shift) : build(A, shift);
    if (status == Solver_status::success)
      m_state = State::factorized;
    else
      release();
    return status;
  });
}

template <class Scalar_>
void internal::Multigrid_solver<Scalar_>::release()
{
  if (m_state == State::factorized) m_state = State::analyzed;
  m_direct.release();
  m_cycle.release();
  m_remainder.release();
}

template <class Scalar_>
Solver_status internal::Multigrid_solver<Scalar_>::precondition(const Block<Scalar>& b,
                                                                Block<Scalar>& x) const
{
  return internal::guarded([&] {
    if (!is_ready(b)) return Solver_status::wrong_state;
    if (is_direct()) return m_direct.solve(b, x);
    x.resize(b.rows(), b.cols());
    Solver_status status = Solver_status::success;
    for (Eigen::Index c = 0; c < b.cols() && status == Solver_status::success; c += columns)
      status = m_cycle.apply([&](int i, double* to) { load(b, i, c, to); },
                             [&](int i, const double* from) { store(from, i, c, x); });
    return status;
  });
}

template <class Scalar_>
Solver_status internal::Multigrid_solver<Scalar_>::solve(const Block<Scalar>& b,
                                                         Block<Scalar>& x) const
{
  return internal::guarded([&] {
    if (!is_ready(b)) return Solver_status::wrong_state;
    return is_direct() ? m_direct.solve(b, x) : iterate(b, x);
  });
}

template <class Scalar_>
auto internal::Multigrid_solver<Scalar_>::cycle() const
    -> const internal::Multigrid_cycle<typename internal::Rounding_remainder<Scalar>::Entry>&
{
  return m_cycle;
}

template <class Scalar_>
Solver_statistics internal::Multigrid_solver<Scalar_>::statistics() const
{
  if (m_state == State::empty) return {};
  if (is_direct()) return m_direct.statistics();
  if (m_state == State::analyzed) return {m_entries, 0, 0};
  Solver_statistics s = m_cycle.statistics();
  s.bytes += m_remainder.bytes();
  return s;
}

template <class Scalar_>
bool internal::Multigrid_solver<Scalar_>::is_ready(const Block<Scalar>& b) const
{
  return m_state == State::factorized && b.rows() == size();
}

template <class Scalar_>
Solver_status internal::Multigrid_solver<Scalar_>::build(const Hermitian_sparse_matrix<Scalar>& A,
                                                         const Vector<FT>& shift)
{
  auto rounded = m_remainder.split(A, shift);
  if (!m_remainder.is_finite()) return Solver_status::numerical_issue;
  return m_cycle.build(std::move(rounded), m_options);
}

template <class Scalar_>
Solver_status internal::Multigrid_solver<Scalar_>::iterate(const Block<Scalar>& b,
                                                           Block<Scalar>& x) const
{
  Solver_status status = Solver_status::success;
  const auto multiply = [&](const Block<Scalar>& p) {
    Block<Scalar> y;
    m_remainder.multiply(m_cycle.levels().front().matrix(), p, y);
    return y;
  };
  const auto cycle = [&](const Block<Scalar>& r) {
    Block<Scalar> z = Block<Scalar>::Constant(r.rows(), r.cols(), Scalar{});
    if (status == Solver_status::success) status = precondition(r, z);
    return z;
  };
  Block<Scalar> solution;
  const auto result =
      conjugate_gradients(multiply, cycle, b, solution, {tolerance, max_iterations});
  if (status != Solver_status::success) return status;
  if (result.indefinite) return Solver_status::not_positive_definite;
  if (!result.converged) return Solver_status::numerical_issue;
  m_iterations = result.iterations;
  x = std::move(solution);
  return Solver_status::success;
}

// Loads vertex i of columns c, c + 1, ..., up to four numbers, padded with zeros.
template <class Scalar_>
void internal::Multigrid_solver<Scalar_>::load(const Block<Scalar>& b, int i, Eigen::Index c,
                                               double* to)
{
  constexpr int planes = internal::Scalar_planes<Scalar>::size;
  for (int k = 0; k < columns; ++k)
    internal::Scalar_planes<Scalar>::get(c + k < b.cols() ? b(i, c + k) : Scalar{},
                                         to + k * planes);
}

template <class Scalar_>
void internal::Multigrid_solver<Scalar_>::store(const double* from, int i, Eigen::Index c,
                                                Block<Scalar>& x)
{
  constexpr int planes = internal::Scalar_planes<Scalar>::size;
  for (int k = 0; k < columns && c + k < x.cols(); ++k)
    x(i, c + k) = internal::Scalar_planes<Scalar>::put(from + k * planes);
}

template class internal::Multigrid_solver<double>;
template class internal::Multigrid_solver<Quaternion<double>>;

}  // namespace Conformal_geometry_processing
