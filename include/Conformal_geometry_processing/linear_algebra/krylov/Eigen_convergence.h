// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_EIGEN_CONVERGENCE_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_EIGEN_CONVERGENCE_H

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Eigen_panel.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Eigen_result.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief watches an eigenvalue iteration: keeps the best iterate, and tells when to stop.
///
/// At the rounding floor the iterates wander; an iteration that neither lowers the estimate nor the
/// eigenvalue three times running has arrived there.
class Eigen_convergence {
 public:
  /// \param function the name to report errors under
  Eigen_convergence(std::string function, const Eigen_options& options,
                    const Block<Quaternion<double>>& x0)
      : m_function(std::move(function)), m_options(options)
  {
    if (options.wanted < 1 || options.wanted > x0.cols())
      throw Precondition_error(
          m_function, "cannot find " + std::to_string(options.wanted) + " eigenpairs with " +
                          std::to_string(x0.cols()) +
                          " initial vectors: wanted at least one vector for each");
  }

  /// the basis of the initial vectors, if there is one
  Eigen_panel initial(Eigen_panel x) const
  {
    const Eigen::Index columns = x.size();
    orthonormalize(x);
    if (x.size() != columns)
      throw Precondition_error(
          m_function, "the " + std::to_string(columns) + " initial vectors depend on each other");
    return x;
  }

  /// \brief takes note of the iterate x with residual r and T r; true if it is the last one.
  template <class GoFurther>
  bool is_last(const Eigen_panel& x, const Block<Quaternion<double>>& r,
               const Block<Quaternion<double>>& Tr, GoFurther&& go_further)
  {
    const Vector<double> estimates = error_estimates(x, r, Tr);
    const double estimate = estimates.head(m_options.wanted).maxCoeff();
    if (!std::isfinite(estimate))
      throw Solver_error(m_function, "iteration " + std::to_string(m_result.iterations) +
                                         " gives values that are not finite");
    note_progress(x, estimates, estimate);
    m_result.converged = estimate <= m_options.tolerance;
    if (m_result.converged) return true;
    m_result.stagnated = m_idle >= 3;
    if (m_result.stagnated || m_iterations >= m_options.max_iterations) return true;
    m_result.cancelled = !go_further(Eigen_progress{m_iterations, x.value(0), estimate, &x.v});
    return m_result.cancelled;
  }

  void count_iteration() { ++m_iterations; }
  void count_solve() { ++m_result.solves; }

  /// there is no direction left to search
  void stop() { m_result.stagnated = true; }

  /// there is a Ritz value after those of the iterates; one never below the eigenvalue it bounds
  void note_next_value(double value) { m_next = (std::min)(m_next, value); }

  /// the best iterate
  Eigen_result result()
  {
    m_result.iterations = m_iterations;
    if (m_result.values.size() == 1 && std::isfinite(m_next))
      m_result.gap = (std::max)(m_next - m_result.values[0], 0.);
    if (m_result.values.size() > 1) m_result.gap = m_result.values[1] - m_result.values[0];
    return std::move(m_result);
  }

 private:
  // Of T r only the part orthogonal to x counts; along x there are but rounding errors, which a
  // nearly singular K would blow up.
  Vector<double> error_estimates(const Eigen_panel& x, const Block<Quaternion<double>>& r,
                                 const Block<Quaternion<double>>& Tr) const
  {
    Vector<double> estimates(x.size());
    for (Eigen::Index j = 0; j < x.size(); ++j) {
      const Quaternion<double> along =
          reduced_to(x.coefficients, inner_product(x.nv.col(j), Tr.col(j)));
      const double squared =
          (inner_product(r.col(j), Tr.col(j)) - inner_product(r.col(j), x.v.col(j)) * along).w;
      estimates[j] = std::sqrt((std::max)(squared, 0.0)) / m_options.scale;
      if (std::isnan(squared)) estimates[j] = squared;
    }
    return estimates;
  }

  void note_progress(const Eigen_panel& x, const Vector<double>& estimates, double estimate)
  {
    const double value = x.value(0);
    const double rounding = 1e-14 * (std::max)(std::abs(value), m_options.scale * m_options.scale);
    const bool lower = value < m_lowest - rounding, better = estimate < m_best;
    m_idle = lower || better ? 0 : m_idle + 1;
    m_lowest = (std::min)(m_lowest, value);
    if (!better) return;
    m_best = estimate;
    m_result.vectors = x.v;
    m_result.estimates = estimates;
    m_result.values.resize(x.size());
    for (Eigen::Index j = 0; j < x.size(); ++j) m_result.values[j] = x.value(j);
  }

  std::string m_function;
  Eigen_options m_options;
  Eigen_result m_result;
  double m_best = std::numeric_limits<double>::infinity();
  double m_lowest = std::numeric_limits<double>::infinity();
  double m_next = std::numeric_limits<double>::infinity();
  int m_iterations = 0, m_idle = 0;
};

}  // namespace Conformal_geometry_processing

#endif
