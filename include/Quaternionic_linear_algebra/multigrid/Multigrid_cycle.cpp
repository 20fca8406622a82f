// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/multigrid/Multigrid_cycle.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace Conformal_geometry_processing {

template <class Entry>
Solver_status internal::Multigrid_cycle<Entry>::build(Matrix A,
                                                      const internal::Multigrid_options& options)
{
  release();
  do {
    if (!has_positive_diagonal(A)) return Solver_status::not_positive_definite;
    internal::Prolongation P = make_prolongation(A, options);
    Matrix coarse = galerkin_product(A, P);
    m_levels.emplace_back(std::move(A), std::move(P));
    A = std::move(coarse);
  } while (A.size() > options.coarsest_size);
  return factorize_coarsest(A);
}

template <class Entry>
void internal::Multigrid_cycle<Entry>::release()
{
  m_levels.clear();
  m_coarsest.release();
  m_solution.resize(0, columns);
  m_coarse.resize(0);
}

template <class Entry>
Solver_statistics internal::Multigrid_cycle<Entry>::statistics() const
{
  Solver_statistics s;
  if (coarsest_size() > 0) s = m_coarsest.statistics();
  s.bytes += sizeof(float) * 2. * static_cast<double>(m_coarse.size());
  for (const Level& level : m_levels) {
    const double entries = level.matrix().pattern().size_of_entries();
    const double weights = static_cast<double>(level.prolongation().columns.size());
    s.factor_entries += level.matrix().pattern().size_of_entries();
    s.bytes += static_cast<double>(level.bytes());
    // Every entry is multiplied by the weights of its row and its column.
    s.flops +=
        2 * internal::Scalar_planes<Entry>::size * entries * std::pow(weights / level.size(), 2);
  }
  return s;
}

template <class Entry>
bool internal::Multigrid_cycle<Entry>::has_positive_diagonal(const Matrix& A)
{
  bool is_positive = true;
  for (int i = 0; i < A.size(); ++i) is_positive = is_positive && A.diagonal(i) > 0;
  return is_positive;
}

template <class Entry>
internal::Prolongation internal::Multigrid_cycle<Entry>::make_prolongation(
    const Matrix& A, const internal::Multigrid_options& options)
{
  const internal::Connection_graph graph = strong_connections(A, options.strength);
  return smoothed_prolongation(graph, aggregate(graph), options.smoothing);
}

template <class Entry>
Solver_status internal::Multigrid_cycle<Entry>::factorize_coarsest(const Matrix& A)
{
  m_solution.resize(A.size(), columns);
  m_coarse.resize(std::int64_t(4) * A.size());
  if (A.size() == 0) return Solver_status::success;
  Solver_status status = m_coarsest.analyze(A.pattern());
  if (status == Solver_status::success) status = m_coarsest.factorize(A, {});
  if (status != Solver_status::not_positive_definite) return status;
  // If A is nearly singular, rounding may destroy its definiteness. Increasing the diagonal by a
  // relative 1e-6 restores it and hardly affects the preconditioner.
  Vector<float> more(A.size());
  for (int i = 0; i < A.size(); ++i) more[i] = 1e-6f * A.diagonal(i);
  return m_coarsest.factorize(A, more);
}

// The four numbers of vertex I one level below l.
template <class Entry>
float* internal::Multigrid_cycle<Entry>::below(std::size_t l, int I)
{
  return l + 1 < m_levels.size() ? m_levels[l + 1].vector(I)
                                 : m_coarse.data() + std::ptrdiff_t(4) * I;
}

template <class Entry>
Solver_status internal::Multigrid_cycle<Entry>::descend(std::size_t l)
{
  using Register = Lanes::Register;
  Level& level = m_levels[l];
  level.smooth_first();
  for (int I = 0; I < level.prolongation().coarse_size; ++I) Lanes::store(below(l, I), Register{});
  level.restrict_residual([&](int I, const Register& part) {
    Register sum;
    Lanes::load(below(l, I), sum);
    sum += part;
    Lanes::store(below(l, I), sum);
  });
  const Solver_status status = l + 1 < m_levels.size() ? descend(l + 1) : solve_coarsest();
  level.correct_and_smooth([&](int I) { return below(l, I); });
  return status;
}

template <class Entry>
Solver_status internal::Multigrid_cycle<Entry>::solve_coarsest()
{
  const int size = coarsest_size();
  if (size == 0) return Solver_status::success;
  for (int I = 0; I < size; ++I)
    for (int q = 0; q < 4; ++q) component(m_solution, I, q) = below(m_levels.size(), I)[q];
  const Solver_status status = m_coarsest.solve(m_solution, m_solution);
  for (int I = 0; I < size; ++I)
    for (int q = 0; q < 4; ++q) below(m_levels.size(), I)[q] = component(m_solution, I, q);
  return status;
}

template class internal::Multigrid_cycle<float>;
template class internal::Multigrid_cycle<Quaternion<float>>;

}  // namespace Conformal_geometry_processing
