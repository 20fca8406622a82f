// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/direct/Supernodal_substitution.h>

#include <Quaternionic_linear_algebra/vector_units/kernel_arithmetic.h>

#include <algorithm>
#include <cstdint>

namespace Conformal_geometry_processing {

static_assert(max_supernode_width <= max_panel_width);

template <class Scalar, class Real, int numbers>
internal::Supernodal_substitution<Scalar, Real, numbers>::Supernodal_substitution(
    const Factor& factor)
    : m_factor(factor),
      S(factor.structure()),
      m_kernels(numbers == 1   ? factor.kernels().single
                : numbers == 4 ? factor.kernels().narrow
                               : factor.kernels().wide),
      m_threads(Factor::threads(static_cast<double>(factor.panel_bytes()) / 5e9))  // read twice
{
  const auto size = [&](int s) { return static_cast<std::int64_t>(S.height(s)) * numbers; };
  m_places = m_threads > 1 ? internal::Contribution_stack(S, factor.tasks(), size)
                           : internal::Contribution_stack(S, size);
  m_updates.resize(m_places.size());
}

template <class Scalar, class Real, int numbers>
void internal::Supernodal_substitution<Scalar, Real, numbers>::solve(Real* x)
{
  if (m_threads == 1) {
    forward(0, S.size(), x);
    backward(0, S.size(), x);
    return;
  }
  using Task = internal::Elimination_tasks::Task;
  m_factor.tasks().run(
      m_threads, [&](const Task& t, internal::Task_pool&) { forward(t.begin, t.end, x); },
      [&](const Task& t, internal::Task_pool&) { backward(t.begin, t.end, x); });
}

template <class Scalar, class Real, int numbers>
void internal::Supernodal_substitution<Scalar, Real, numbers>::forward(Real* x)
{
  const auto up = [&](const internal::Elimination_tasks::Task& t, internal::Task_pool&) {
    forward(t.begin, t.end, x);
  };
  if (m_threads > 1)
    m_factor.tasks().run(m_threads, up);
  else
    forward(0, S.size(), x);
  for (int s = 0; s < S.size(); ++s)
    if (S.parent(s) < 0)
      for (int i = 0; i < S.height(s); ++i)
        for (int n = 0; n < numbers; ++n)
          x[std::int64_t(S.rows(s)[i]) * numbers + n] +=
              m_updates.data()[m_places[s] + std::int64_t(i) * numbers + n];
}

template <class Scalar, class Real, int numbers>
void internal::Supernodal_substitution<Scalar, Real, numbers>::backward(Real* x) const
{
  const auto nothing = [](const internal::Elimination_tasks::Task&, internal::Task_pool&) {};
  const auto down = [&](const internal::Elimination_tasks::Task& t, internal::Task_pool&) {
    backward(t.begin, t.end, x);
  };
  if (m_threads > 1) return m_factor.tasks().run(m_threads, nothing, down);
  backward(0, S.size(), x);
}

template <class Scalar, class Real, int numbers>
void internal::Supernodal_substitution<Scalar, Real, numbers>::forward(int begin, int end, Real* x)
{
  for (int s = begin; s < end; ++s) forward(s, x);
}

template <class Scalar, class Real, int numbers>
void internal::Supernodal_substitution<Scalar, Real, numbers>::backward(int begin, int end,
                                                                        Real* x) const
{
  for (int s = end - 1; s >= begin; --s) backward(s, x);
}

// Adds the contributions of the children to the rows of the front and to those below.
template <class Scalar, class Real, int numbers>
void internal::Supernodal_substitution<Scalar, Real, numbers>::forward(int s, Real* x)
{
  Real* const own = m_updates.data() + m_places[s];
  std::fill_n(own, std::int64_t(S.height(s)) * numbers, Real(0));
  for (const int* c = S.children_begin(s); c != S.children_end(s); ++c)
    m_kernels.add_child({m_updates.data() + m_places[*c], S.height(*c), S.relative_rows(*c)},
                        S.width(s), rows_of(s, x), own);
  m_kernels.forward(m_factor.front(s), rows_of(s, x), own);
}

template <class Scalar, class Real, int numbers>
void internal::Supernodal_substitution<Scalar, Real, numbers>::backward(int s, Real* x) const
{
  if (s > 0) prefetch_panel(s - 1);
  m_kernels.backward(m_factor.front(s), rows_of(s, x), x);
}

template <class Scalar, class Real, int numbers>
Real* internal::Supernodal_substitution<Scalar, Real, numbers>::rows_of(int s, Real* x) const
{
  return x + static_cast<std::int64_t>(S.first(s)) * numbers;
}

// Prefetches the beginning of a panel, because panels are traversed against the memory order.
template <class Scalar, class Real, int numbers>
void internal::Supernodal_substitution<Scalar, Real, numbers>::prefetch_panel(int s) const
{
  const internal::Factored_front<Real> front = m_factor.front(s);
  const auto prefetch = [](const auto* from, std::int64_t size) {
    constexpr int line = 64 / static_cast<int>(sizeof *from);
    for (std::int64_t i = 0; i < (std::min)(size, std::int64_t(64) * line); i += line)
      CGP_PREFETCH(from + i);
  };
  const std::int64_t all = m_factor.layout().panel_size(front.columns, front.rows_below);
  if (front.rounded)
    prefetch(front.rounded, all);
  else
    prefetch(front.panel, all);
  CGP_PREFETCH(S.rows(s));
}

#define CGP_DEFINE(Scalar, Real)                                     \
  template class internal::Supernodal_substitution<Scalar, Real, 4>; \
  template class internal::Supernodal_substitution<Scalar, Real, 8>;
CGP_FOR_SUPERNODAL_INSTANCES(CGP_DEFINE)
#undef CGP_DEFINE
#define CGP_DEFINE(Scalar, Real) template class internal::Supernodal_substitution<Scalar, Real, 1>;
CGP_FOR_REAL_SUPERNODAL_INSTANCES(CGP_DEFINE)
#undef CGP_DEFINE

}  // namespace Conformal_geometry_processing
