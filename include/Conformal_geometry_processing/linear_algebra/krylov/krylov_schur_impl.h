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

/// \brief Adds blocks as long as there is room. \return whether it may go further
CGP_INLINE bool fill(Krylov_space& space,
                     const std::function<bool(const Krylov_progress&)>& go_further,
                     Krylov_progress progress)
{
  while (space.has_next() && space.has_room()) {
    space.extend();
    progress.vectors = static_cast<int>(space.size());
    if (go_further && !go_further(progress)) return false;
  }
  return true;
}

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
  const auto block =
      static_cast<Eigen::Index>(std::ceil(std::sqrt(static_cast<double>(wanted)))) + 2;
  const internal::Thread_team team;
  internal::Krylov_space space(pencil, rows, wanted + 9 * block);
  internal::Krylov_result result;
  space.adopt(known.vectors, known.values);
  space.begin_with(noise(block));
  internal::Krylov_progress progress{0, 0, 0, static_cast<int>(space.capacity())};
  for (Vector<double> before;; ++result.restarts) {  // the values when all converged the last time
    progress.restart = result.restarts;
    result.cancelled = !internal::fill(space, go_further, progress);
    const auto pairs = internal::dominant_first(quaternionic_householder(space.projection()));
    const Eigen::Index found = (std::min)(pairs.values.size(), wanted);
    const Eigen::Index converged = internal::converged_pairs(
        pairs.values.head(found), space.residuals(pairs.vectors.leftCols(found)),
        options.tolerance);
    const bool have_all_converged = converged == found;
    result.converged = converged == wanted && internal::has_nothing_new(pairs.values.head(found),
                                                                        before, options.tolerance);
    progress.converged = static_cast<int>(converged);
    progress.vectors = static_cast<int>(space.size());
    result.cancelled = result.cancelled || (go_further && !go_further(progress));
    if (result.converged || result.cancelled || result.restarts == options.max_restarts) {
      result.values = pairs.values.head(found);
      result.vectors = space.combination(pairs.vectors.leftCols(found));
      result.residuals = internal::true_residuals(pencil, result.vectors, result.values);
      return result;
    }
    if (have_all_converged) before = pairs.values.head(found);
    const Eigen::Index kept = have_all_converged ? found : (std::min)(wanted + block, space.size());
    space.restart(pairs.vectors.leftCols(kept), pairs.values.head(kept));
    if (!have_all_converged && space.has_next()) continue;
    space.begin_with(noise(block));
    if (!space.has_next() && found < wanted)
      throw Precondition_error("krylov_schur", std::to_string(wanted) +
                                                   " eigenpairs are wanted, of a matrix with " +
                                                   std::to_string(found));
  }
}

}  // namespace Conformal_geometry_processing

#endif
