// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/dense/block_operators.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {
namespace internal {

/// \brief Some vectors V together with K V and N V, which an eigensolver for K x = N x theta
/// combines linearly, so that K and N are not applied again to combinations.
struct Ritz_panel {
  Block<Quaternion<double>> v, kv, nv;
  Coefficients coefficients = Coefficients::quaternions;

  Eigen::Index size() const { return v.cols(); }

  /// A^H B, reduced to the type of the coefficients
  Block<Quaternion<double>> gram(const Block<Quaternion<double>>& A,
                                 const Block<Quaternion<double>>& B) const;

  std::array<Block<Quaternion<double>>*, 3> parts() { return {&v, &kv, &nv}; }

  /// the Rayleigh quotients of the columns
  Vector<double> values() const;

  /// Sets the columns of r to K x - N x theta, with theta the Rayleigh quotient of x
  void residual(Block<Quaternion<double>>& r) const;
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// Computes K p.v and N p.v, in the memory of the panel
template <class K, class N>
void apply_operators(const K& apply_k, const N& apply_n, internal::Ritz_panel& p)
{
  apply_operator(apply_k, p.v, p.kv);
  apply_operator(apply_n, p.v, p.nv);
}

/// \ingroup PkgLinearAlgebra
/// Makes a panel of v, K v and N v
template <class K, class N>
internal::Ritz_panel make_panel(
    const K& apply_k, const N& apply_n, Block<Quaternion<double>> v,
    internal::Coefficients coefficients = internal::Coefficients::quaternions)
{
  internal::Ritz_panel p{std::move(v), {}, {}, coefficients};
  apply_operators(apply_k, apply_n, p);
  return p;
}

/// \ingroup PkgLinearAlgebra
/// \brief Computes p = p C + q D, in place
void replace_by_combination(internal::Ritz_panel& p, const Block<Quaternion<double>>& C,
                            const internal::Ritz_panel& q, const Block<Quaternion<double>>& D);

namespace internal {

/// \brief Returns a basis of the span of some vectors V, as combinations V C with C^H G C = 1.
///
/// The Gram-Schmidt process on coefficients. Leaves out vectors that depend on the previous ones,
/// with a squared sine below 1e-11 to their span: such a direction consists mostly of rounding
/// errors and may lead to another eigenpair.
/// \param G the Gram matrix of V, d x d
/// \returns d x r, r <= d; columns are triangular up to those left out
Block<Quaternion<double>> orthonormal_combinations(const Block<Quaternion<double>>& G);

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Makes the columns of p N-orthonormal, without those that `orthonormal_combinations()`
/// leaves out.
void orthonormalize(internal::Ritz_panel& p);

/// \ingroup PkgLinearAlgebra
/// \brief Progress reported before every iteration.
struct Eigensolver_progress {
  int iteration;    ///< iterations done
  double value;     ///< current approximation of the smallest eigenvalue
  double estimate;  ///< the largest error estimate of the wanted vectors
  const Block<Quaternion<double>>* vectors = nullptr;  ///< the iterates, if provided
};

/// \ingroup PkgLinearAlgebra
/// \brief Stopping criteria of an eigensolver.
struct Eigensolver_options {
  int wanted = 1;            ///< how many of the smallest eigenpairs have to converge
  int max_iterations = 100;  ///< maximal number of iterations
  double tolerance = 1e-6;   ///< bound on `Eigensolver_result::estimates`
  /// Square root of a typical eigenvalue, sqrt(4 pi / area) on a surface; makes the error estimate
  /// dimensionless
  double scale = 1;
  /// Coefficients of linear combinations; `reals` if the vectors form a space over the reals only
  internal::Coefficients coefficients = internal::Coefficients::quaternions;
  /// Called after every iteration, if set, with the new iterates and the estimate of those before
  /// them. It may change the matrix K to which they lead, and returns whether it has; the
  /// eigenpairs are then those of the new matrix. Only `lobpcg()` calls it; other eigensolvers
  /// solve the problem as it was given.
  std::function<bool(const Eigensolver_progress&)> adapt;
};

namespace internal {

/// \brief Never cancels: the default for the `go_further` of eigensolvers.
struct Always_go_further {
  bool operator()(const Eigensolver_progress&) const { return true; }
};

/// Called after every iteration; returns false to cancel
using Go_further = std::function<bool(const Eigensolver_progress&)>;

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief The smallest eigenpairs of K x = N x theta, with error estimates.
///
/// `estimates` are sqrt(<r, T r>) / scale of the returned vectors, with r = K x - N x theta and T
/// approximately the inverse of K: the error of x in the energy norm of K. The error of theta is
/// about the square of it, so theta appears to converge long before x.
struct Eigensolver_result {
  Vector<double> values;              ///< ascending
  Block<Quaternion<double>> vectors;  ///< |V| x block size, X^H N X = 1
  Vector<double> estimates;           ///< one per vector
  int iterations = 0;
  int solves = 0;          ///< applications of T, to all columns at once
  bool converged = false;  ///< every wanted estimate is at most the tolerance
  bool stagnated = false;  ///< rounding errors keep the estimate above the tolerance
  bool cancelled = false;  ///< `go_further` returned false
  std::optional<double>
      gap;  ///< theta_2 - theta_1, if the block has at least two columns; otherwise the smallest
            ///< upper bound found, if any, which is rough for wide gaps
};

namespace internal {

/// \brief Monitors the convergence of an eigensolver: stores the best iterate and decides when to
/// stop.
///
/// At rounding level the iterates fluctuate; if three consecutive iterations reduce neither the
/// estimate nor the eigenvalue, the iteration has stagnated.
class Eigensolver_convergence {
 public:
  /// \param function the name of the function in error messages
  Eigensolver_convergence(std::string function, const Eigensolver_options& options,
                          const Block<Quaternion<double>>& x0);

  /// Returns the basis of the initial vectors, if there is one
  Ritz_panel initial(Ritz_panel x) const;

  /// \brief Records the iterate x with residual r and T r; returns true if it is the last one.
  template <class GoFurther>
  bool is_last(const Ritz_panel& x, const Block<Quaternion<double>>& r,
               const Block<Quaternion<double>>& Tr, GoFurther&& go_further)
  {
    const Vector<double> values = x.values(), estimates = error_estimates(x, r, Tr);
    const double estimate = m_estimate = estimates.head(m_options.wanted).maxCoeff();
    m_value = values[0];
    if (!std::isfinite(estimate))
      throw Solver_error(m_function, "iteration " + std::to_string(m_result.iterations) +
                                         " gives values that are not finite");
    note_progress(x.v, values, estimates, estimate);
    m_result.converged = estimate <= m_options.tolerance;
    if (m_result.converged) return true;
    m_result.stagnated = m_idle >= 3;
    if (m_result.stagnated || m_iterations >= m_options.max_iterations) return true;
    m_result.cancelled = !go_further(Eigensolver_progress{m_iterations, m_value, estimate, &x.v});
    return m_result.cancelled;
  }

  void count_iteration() { ++m_iterations; }

  /// \brief Asks whether the matrix of x changes; if it does, the iterates so far do not count, as
  /// those of different matrices cannot be compared.
  /// \param vectors the iterates after the last ones that were recorded
  bool has_adapted(const Block<Quaternion<double>>& vectors);

  void count_solve() { ++m_result.solves; }

  /// No search directions are left
  void stop() { m_result.stagnated = true; }

  /// Records the Ritz value after those of the iterates; it is an upper bound of its eigenvalue
  void note_next_value(double value) { m_next = (std::min)(m_next, value); }

  /// Returns the best iterate
  Eigensolver_result result();

 private:
  Vector<double> error_estimates(const Ritz_panel& x, const Block<Quaternion<double>>& r,
                                 const Block<Quaternion<double>>& Tr) const;
  void note_progress(const Block<Quaternion<double>>& vectors, const Vector<double>& values,
                     const Vector<double>& estimates, double estimate);

  std::string m_function;
  Eigensolver_options m_options;
  Eigensolver_result m_result;
  double m_value = 0, m_estimate = 0;  // of the last iterate
  double m_best = std::numeric_limits<double>::infinity();
  double m_lowest = std::numeric_limits<double>::infinity();
  double m_next = std::numeric_limits<double>::infinity();
  int m_iterations = 0, m_idle = 0;
};

}  // namespace internal
}  // namespace Conformal_geometry_processing
