// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_KRYLOV_SCHUR_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_KRYLOV_SCHUR_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/linear_algebra/dense/hermitian_jacobi.h>
#include <Conformal_geometry_processing/linear_algebra/dense/quaternionic_householder.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/krylov_schur.h>
#include <Conformal_geometry_processing/threads/Thread_team.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

/// Sorts eigenpairs of the projection by decreasing modulus.
CGP_INLINE Hermitian_eigen_decomposition<Quaternion<double>> dominant_first(
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
CGP_INLINE Eigen::Index converged_pairs(const Vector<double>& values,
                                        const Vector<double>& residuals, double tolerance)
{
  Eigen::Index count = 0;
  while (count < values.size() && residuals[count] <= tolerance * std::abs(values[count])) ++count;
  return count;
}

/// Whether no eigenvalue has grown: random vectors have found nothing new beside those before.
CGP_INLINE bool has_nothing_new(const Vector<double>& values, const Vector<double>& before,
                                double tolerance)
{
  if (values.size() != before.size()) return false;
  const auto growth = values.array().abs() - before.array().abs();
  return (growth <= tolerance * values.array().abs()).all();
}

CGP_INLINE Vector<double> true_residuals(const Pencil& pencil, const Block<Quaternion<double>>& x,
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
  bool is_next_known = false;  // a few digits of the first one beside them, if there is one

  bool have_converged() const { return converged == found; }
  Vector<double> values() const { return all.values.head(found); }
};

CGP_INLINE Ritz_pairs ritz_pairs(const Krylov_space& space, const Krylov_options& options)
{
  const double few_digits = 1e-2;
  Ritz_pairs p;
  p.all = dominant_first(quaternionic_householder(space.projection()));
  const Vector<double>& values = p.all.values;
  p.found = (std::min)(values.size(), Eigen::Index(options.wanted));
  const Vector<double> residuals = space.residuals(p.all.vectors);
  p.converged = converged_pairs(p.values(), residuals, options.tolerance);
  p.is_next_known =
      !space.has_next() ||
      (p.found < values.size() && residuals[p.found] <= few_digits * std::abs(values[p.found]));
  return p;
}

/// Extends a space until it is full, or tells what is wanted.
class Krylov_growth {
 public:
  Krylov_growth(Krylov_space& space, const Krylov_options& options,
                const std::function<bool(const Krylov_progress&)>& go_further)
      : m_space(space), m_options(options), m_go_further(go_further)
  {
    progress.capacity = static_cast<int>(space.capacity());
  }

  /// \param before the values that had converged when random vectors were added, if they were. If
  /// they have stayed as they are, and the random vectors show the one that comes next, nothing is
  /// missing. An eigenvalue that is would have come first.
  Ritz_pairs run(const Vector<double>& before)
  {
    const Eigen::Index first_blocks = 3;
    Eigen::Index size_of_look = m_space.size() + first_blocks * m_space.size_of_next();
    for (;;) {
      const bool is_full = !m_space.has_next() || !m_space.has_room();
      if (!is_full) m_space.extend();
      is_cancelled = !tell();
      if (!is_full && !is_cancelled && m_space.size() < size_of_look) continue;
      Ritz_pairs p = ritz_pairs(m_space, m_options);
      const bool is_old = has_nothing_new(p.values(), before, m_options.tolerance);
      is_settled = p.converged == m_options.wanted && is_old && (p.is_next_known || is_full);
      progress.converged = static_cast<int>(p.converged);
      if (is_full || is_cancelled || is_settled || (p.have_converged() && !is_old)) return p;
      size_of_look = m_space.size() + (std::max)(m_space.size_of_next(), m_space.size() / 8);
    }
  }

  bool is_settled = false, is_cancelled = false;
  Krylov_progress progress;

 private:
  /// \return whether it may go further
  bool tell()
  {
    progress.vectors = static_cast<int>(m_space.size());
    return !m_go_further || m_go_further(progress);
  }

  Krylov_space& m_space;
  const Krylov_options& m_options;
  const std::function<bool(const Krylov_progress&)>& m_go_further;
};

}  // namespace internal

CGP_INLINE internal::Krylov_result krylov_schur(
    const internal::Pencil& pencil, Eigen::Index rows,
    const std::function<Block<Quaternion<double>>(Eigen::Index)>& noise,
    const internal::Krylov_options& options,
    const std::function<bool(const internal::Krylov_progress&)>& go_further,
    const internal::Krylov_result& known)
{
  const Eigen::Index wanted = options.wanted;
  if (wanted < 1) throw Precondition_error("krylov_schur", "at least one eigenpair must be wanted");
  const auto root = static_cast<Eigen::Index>(std::sqrt(static_cast<double>(wanted)));
  const Eigen::Index block = (std::max)(Eigen::Index(3), root), block_of_others = 2;
  const internal::Thread_team team;
  internal::Krylov_space space(pencil, rows, wanted + 12 * block);
  internal::Krylov_growth growth(space, options, go_further);
  internal::Krylov_result result;
  space.adopt(known.vectors, known.values);
  space.begin_with(noise(block));
  for (Vector<double> before;; ++result.restarts) {  // the values when all converged the last time
    growth.progress.restart = result.restarts;
    const internal::Ritz_pairs pairs = growth.run(before);
    result.converged = growth.is_settled;
    result.cancelled = growth.is_cancelled;
    if (result.converged || result.cancelled || result.restarts == options.max_restarts) {
      result.values = pairs.values();
      result.vectors = space.combination(pairs.all.vectors.leftCols(pairs.found));
      result.residuals = internal::true_residuals(pencil, result.vectors, result.values);
      return result;
    }
    const bool have_converged = pairs.have_converged();
    if (have_converged) before = pairs.values();
    const Eigen::Index most = (std::min)(wanted + block, space.size()),
                       kept = have_converged ? pairs.found : most;
    space.restart(pairs.all.vectors.leftCols(kept), pairs.all.values.head(kept));
    if (!have_converged && space.has_next()) continue;
    space.begin_with(noise(block_of_others));
    if (!space.has_next() && pairs.found < wanted)
      throw Precondition_error("krylov_schur", std::to_string(wanted) +
                                                   " eigenpairs are wanted, of a matrix with " +
                                                   std::to_string(pairs.found));
  }
}

}  // namespace Conformal_geometry_processing

#endif
