// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/krylov/krylov_schur.h>

#include <Quaternionic_linear_algebra/dense/hermitian_eigen_decomposition.h>
#include <Quaternionic_linear_algebra/threads/Thread_team.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

/// Sorts eigenpairs of the projection by decreasing modulus.
Hermitian_eigen_decomposition<Quaternion<double>> dominant_first(
    Hermitian_eigen_decomposition<Quaternion<double>> pairs)
{
  std::vector<Eigen::Index> order(static_cast<std::size_t>(pairs.values.size()));
  std::iota(order.begin(), order.end(), Eigen::Index(0));
  std::stable_sort(order.begin(), order.end(), [&](Eigen::Index i, Eigen::Index j) {
    return std::abs(pairs.values[i]) > std::abs(pairs.values[j]);
  });
  auto sorted = pairs;
  for (Eigen::Index i = 0; i < pairs.values.size(); ++i) {
    const Eigen::Index from = order[static_cast<std::size_t>(i)];
    sorted.values[i] = pairs.values[from];
    sorted.vectors.col(i) = pairs.vectors.col(from);
  }
  return sorted;
}

/// Number of leading pairs that have converged.
Eigen::Index converged_pairs(const Vector<double>& values, const Vector<double>& residuals,
                             double tolerance)
{
  Eigen::Index count = 0;
  while (count < values.size() && residuals[count] <= tolerance * std::abs(values[count])) ++count;
  return count;
}

/// Whether no eigenvalue has grown: random vectors have found nothing new beside those before.
bool has_nothing_new(const Vector<double>& values, const Vector<double>& before, double tolerance)
{
  if (values.size() != before.size()) return false;
  const auto growth = values.array().abs() - before.array().abs();
  return (growth <= tolerance * values.array().abs()).all();
}

Vector<double> true_residuals(const Pencil& pencil, const Block<Quaternion<double>>& x,
                              const Vector<double>& values)
{
  Block<Quaternion<double>> r = pencil.solve(pencil.K(x));
  for (Eigen::Index j = 0; j < x.cols(); ++j)
    add_multiple(r.col(j), x.col(j), Quaternion<double>{-values[j], 0, 0, 0});
  const Block<Quaternion<double>> Nr = pencil.N(r);
  Vector<double> norms(x.cols());
  for (Eigen::Index j = 0; j < x.cols(); ++j)
    norms[j] =
        std::sqrt((std::max)(inner_product(r.col(j), Nr.col(j)).w, 0.)) / std::abs(values[j]);
  return norms;
}

/// What a Krylov space tells of the wanted pairs
struct Ritz_pairs {
  Hermitian_eigen_decomposition<Quaternion<double>> all;  // of the projection, dominant first
  Eigen::Index found = 0;                                 // wanted ones that there are, and ...
  Eigen::Index converged = 0;                             // ... how many of these have converged
  bool is_next_beside = false;  // the next one is known well enough to tell that it is not wanted
  bool is_settled = false, is_cancelled = false;

  bool have_converged() const { return converged == found; }
  Vector<double> values() const { return all.values.head(found); }
};

// A vector between a missing copy of the last wanted pair and the pairs after it has a residual of
// their distance. Where that is large, a few digits of the next one do.
bool is_next_beside(const Vector<double>& values, const Vector<double>& residuals,
                    Eigen::Index found, double tolerance)
{
  const double few_digits = 1e-2, share_of_gap = 0.3;
  if (found == values.size()) return false;
  const double next = std::abs(values[found]), gap = std::abs(values[found - 1]) - next,
               enough = (std::min)(few_digits * next, share_of_gap * gap);
  return residuals[found] <= (std::max)(enough, tolerance * next);
}

Ritz_pairs ritz_pairs(const Krylov_space& space, const Krylov_options& options)
{
  Ritz_pairs p;
  p.all = dominant_first(hermitian_eigen_decomposition(space.projection()));
  p.found = (std::min)(p.all.values.size(), Eigen::Index(options.wanted));
  const Vector<double> residuals = space.residuals(p.all.vectors);
  p.converged = converged_pairs(p.values(), residuals, options.tolerance);
  p.is_next_beside =
      !space.has_next() || is_next_beside(p.all.values, residuals, p.found, options.tolerance);
  return p;
}

/// Extends a space until it is full, or tells what is wanted.
class Krylov_growth {
 public:
  Krylov_growth(Krylov_space& space, const Krylov_options& options,
                const std::function<bool(const Krylov_progress&)>& go_further)
      : m_space(space), m_options(options), m_go_further(go_further)
  {
    m_progress.capacity = static_cast<int>(space.capacity());
  }

  /// \param before the values that had converged when random vectors were added, if they were. It
  /// is settled that nothing is missing if they stay, and the random vectors, in which a larger one
  /// would come first, have shown the next one.
  Ritz_pairs run(int restart, const Vector<double>& before)
  {
    const Eigen::Index first_blocks = 3;
    m_progress.restart = restart;
    Eigen::Index size_of_look = m_space.size() + first_blocks * m_space.size_of_next();
    for (;;) {
      const bool is_cancelled = !extend();
      if (can_grow() && !is_cancelled && m_space.size() < size_of_look) continue;
      Ritz_pairs p = ritz_pairs(m_space, m_options);
      const bool is_old = has_nothing_new(p.values(), before, m_options.tolerance);
      p.is_cancelled = is_cancelled;
      p.is_settled = !is_cancelled && p.converged == m_options.wanted && is_old &&
                     (p.is_next_beside || !can_grow());
      m_progress.converged = static_cast<int>(p.converged);
      if (!can_grow() || is_cancelled || p.is_settled || (p.have_converged() && !is_old)) return p;
      size_of_look = m_space.size() + (std::max)(m_space.size_of_next(), m_space.size() / 8);
    }
  }

 private:
  bool can_grow() const { return m_space.has_next() && m_space.has_room(); }

  /// \return whether it may go further
  bool extend()
  {
    if (!can_grow()) return true;
    m_space.extend();
    m_progress.vectors = static_cast<int>(m_space.size());
    return !m_go_further || m_go_further(m_progress);
  }

  Krylov_space& m_space;
  const Krylov_options& m_options;
  const std::function<bool(const Krylov_progress&)>& m_go_further;
  Krylov_progress m_progress;
};

Krylov_result result_of(const Krylov_space& space, const Pencil& pencil, const Ritz_pairs& pairs)
{
  Krylov_result r;
  r.values = pairs.values();
  r.vectors = space.combination(pairs.all.vectors.leftCols(pairs.found));
  r.residuals = true_residuals(pencil, r.vectors, r.values);
  r.converged = pairs.is_settled;
  r.cancelled = pairs.is_cancelled;
  return r;
}

}  // namespace internal

internal::Krylov_result krylov_schur(
    const internal::Pencil& pencil, Eigen::Index rows,
    const std::function<Block<Quaternion<double>>(Eigen::Index)>& noise,
    const internal::Krylov_options& options,
    const std::function<bool(const internal::Krylov_progress&)>& go_further,
    const internal::Krylov_result& known)
{
  const Eigen::Index wanted = options.wanted;
  if (wanted < 1) throw Precondition_error("krylov_schur", "at least one eigenpair must be wanted");
  const auto root = static_cast<Eigen::Index>(std::sqrt(static_cast<double>(wanted)));
  const Eigen::Index block = (std::max)(Eigen::Index(3), root - 1);
  const Eigen::Index few = 2;  // random vectors that look for what is missing: mostly nothing is
  const internal::Thread_team team;
  internal::Krylov_space space(pencil, rows, wanted + 12 * block);
  internal::Krylov_growth growth(space, options, go_further);
  space.adopt(known.vectors, known.values);
  space.begin_with(noise(block));
  Vector<double> before;  // the values when all converged the last time
  for (int restarts = 0;; ++restarts) {
    const internal::Ritz_pairs pairs = growth.run(restarts, before);
    if (pairs.is_settled || pairs.is_cancelled || restarts == options.max_restarts) {
      internal::Krylov_result result = internal::result_of(space, pencil, pairs);
      result.restarts = restarts;
      return result;
    }
    const bool have_converged = pairs.have_converged();
    if (have_converged) before = pairs.values();
    const Eigen::Index kept =
        have_converged ? pairs.found : (std::min)(wanted + block, space.size());
    space.restart(pairs.all.vectors.leftCols(kept), pairs.all.values.head(kept));
    if (!have_converged && space.has_next()) continue;
    space.begin_with(noise(few));
    if (!space.has_next() && pairs.found < wanted)
      throw Precondition_error("krylov_schur", std::to_string(wanted) +
                                                   " eigenpairs are wanted, of a matrix with " +
                                                   std::to_string(pairs.found));
  }
}

}  // namespace Conformal_geometry_processing
