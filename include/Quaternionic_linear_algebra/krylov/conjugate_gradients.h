// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Quaternion.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>
#include <Quaternionic_linear_algebra/dense/block_operators.h>
#include <Quaternionic_linear_algebra/threads/Thread_team.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

struct Conjugate_gradients_options {
  double tolerance = 1e-9;   ///< of the error relative to the solution, in the energy norm
  int max_iterations = 100;  ///< each costs one K and one T
  int leading_columns = 0;   ///< the run ends when these are close, the others as they are; 0: all
  std::function<bool()> go_further = {};  ///< called after each iteration: false ends the run
  double negligible = 0;                  ///< energy of errors that need not become smaller
  /// of inner products, where each process has a part of the vectors; empty: they are whole
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> sum_of_parts = {};
};

template <class FT>
struct Conjugate_gradients_result {
  bool converged = false;
  bool indefinite = false;  ///< a direction of curvature <= 0 of K or T was found
  int iterations = 0;
  Vector<FT> estimates;  ///< of the relative errors in the energy norm, one for each column
};

// The state of one run. Columns with an estimate below their tolerance are not updated.
template <class Scalar, class K, class T>
class Conjugate_gradients {
 public:
  using FT = typename Scalar_traits<Scalar>::FT;
  using Vectors = Block<Scalar>;

  Conjugate_gradients(const K& apply_k, const T& precondition, const Vectors& b,
                      const Conjugate_gradients_options& options)
      : m_apply_k(apply_k),
        m_precondition(precondition),
        m_leading(options.leading_columns > 0 ? options.leading_columns : b.cols()),
        m_sum_of_parts(options.sum_of_parts),
        m_x(Vectors::Constant(b.rows(), b.cols(), Scalar{})),
        m_r(b),
        m_sizes(products(m_r, m_r))
  {
    apply_operator(precondition, m_r, m_p);
    m_first = m_now = m_before = products(m_r, m_p);
    m_tolerances = tolerances(options);
    m_result.estimates = Vector<FT>::Ones(b.cols());
    for (Eigen::Index c = 0; c < b.cols(); ++c)
      if (m_sizes[c] == 0)
        m_result.estimates[c] = 0;
      else
        require_positive(m_first[c]);
  }

  // Takes one step along p. Returns false if the iteration is over.
  bool step()
  {
    if (is_over()) return false;
    Vectors& kp = m_image;
    apply_to_open(m_apply_k, m_p, kp);
    const Vector<FT> curvatures = products(m_p, kp);
    for (Eigen::Index c = 0; c < m_x.cols(); ++c)
      if (is_open(c) && require_positive(curvatures[c])) move(c, m_now[c] / curvatures[c], kp);
    ++m_result.iterations;
    return !is_over();
  }

  // Computes the next direction from a preconditioned residual.
  void turn()
  {
    Vectors& z = m_image;
    apply_to_open(m_precondition, m_r, z);
    const Vector<FT> energies = products(m_r, z);
    for (Eigen::Index c = 0; c < m_x.cols(); ++c) {
      if (!is_open(c) || !require_positive(energies[c])) continue;
      m_result.estimates[c] = std::sqrt(energies[c] / m_first[c]);
      m_p.col(c) = z.col(c) + m_p.col(c) * (energies[c] / m_now[c]);
      m_before[c] = m_now[c];
      m_now[c] = energies[c];
    }
  }

  Conjugate_gradients_result<FT> finish(Vectors& x)
  {
    m_result.converged = !m_failed && is_close();
    x = std::move(m_x);
    return std::move(m_result);
  }

 private:
  template <class A, class B>
  Vector<FT> products(const A& a, const B& b) const
  {
    Vector<FT> p(a.cols());
    for (Eigen::Index c = 0; c < a.cols(); ++c)
      p[c] = Scalar_traits<Scalar>::real(inner_product(a.col(c), b.col(c)));
    if (m_sum_of_parts) p = m_sum_of_parts(p.template cast<double>()).template cast<FT>();
    return p;
  }

  // The other columns of the images have no meaning.
  template <class Operator>
  void apply_to_open(const Operator& apply, const Vectors& vectors, Vectors& images) const
  {
    std::vector<Eigen::Index> open;
    for (Eigen::Index c = 0; c < vectors.cols(); ++c)
      if (is_open(c)) open.push_back(c);
    if (static_cast<Eigen::Index>(open.size()) == vectors.cols())
      return apply_operator(apply, vectors, images);
    Vectors of_open;
    apply_operator(apply, Vectors(vectors(Eigen::all, open)), of_open);
    images = vectors;
    images(Eigen::all, open) = of_open;
  }

  // At most .9, or no step would be taken.
  Vector<FT> tolerances(const Conjugate_gradients_options& options) const
  {
    const FT most(0.9), given = static_cast<FT>(options.tolerance),
                        negligible = static_cast<FT>(options.negligible);
    Vector<FT> relative = Vector<FT>::Constant(m_first.size(), given);
    for (Eigen::Index c = 0; c < relative.size(); ++c)
      if (negligible > 0 && m_first[c] > 0)
        relative[c] = (std::max)(given, (std::min)(most, std::sqrt(negligible / m_first[c])));
    return relative;
  }

  bool is_open(Eigen::Index c) const { return m_result.estimates[c] > m_tolerances[c]; }
  bool is_close() const
  {
    return (m_result.estimates.array() <= m_tolerances.array()).head(m_leading).all();
  }
  bool is_over() const { return m_failed || is_close(); }

  bool require_positive(FT curvature)
  {
    const bool is_positive = curvature > 0 && std::isfinite(curvature);
    m_failed = m_failed || !is_positive;
    m_result.indefinite = m_result.indefinite || curvature <= 0;
    return is_positive;
  }

  // r^H T r estimates the error before the step. Without another T, the gain of the step is
  // estimated from |r|, which is insensitive to low-frequency errors; it is therefore bounded by
  // the gain of the previous step, which is known in the right norm.
  void move(Eigen::Index c, FT length, const Vectors& kp)
  {
    m_x.col(c) += m_p.col(c) * length;
    m_r.col(c) -= kp.col(c) * length;
    const FT size = products(m_r.col(c), m_r.col(c))[0];
    const FT gain = (std::max)(size / m_sizes[c], m_now[c] / m_before[c]);
    m_result.estimates[c] = size == 0 ? FT(0) : std::sqrt(m_now[c] / m_first[c] * gain);
    m_sizes[c] = size;
  }

  const K& m_apply_k;
  const T& m_precondition;
  Vector<FT> m_tolerances;  // of the estimates
  Eigen::Index m_leading;
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> m_sum_of_parts;
  Vectors m_x, m_r, m_p;
  Vectors m_image;                      // K p, then T r
  Vector<FT> m_sizes;                   // r^H r
  Vector<FT> m_first, m_now, m_before;  // r^H T r at the start, now, and one step before
  bool m_failed = false;
  Conjugate_gradients_result<FT> m_result;
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Solves K x = b for all columns of b by preconditioned conjugate gradients, from x = 0.
///
/// The columns advance together, so that K and T act on blocks, but each has its own coefficients,
/// which are real for complex and quaternionic matrices as well. Deterministic. The errors are
/// measured by r^H T r, which is the square of the energy norm of the error if T is the inverse of
/// K; otherwise the estimate is wrong by at most the square root of the condition number of T K. If
/// T is the exact inverse of a nearby matrix, i iterations cost i K and i T.
///
/// \param apply_k, precondition callables that map a `Block<Scalar>` to one of the same shape, see
///   `apply_operator()`: K Hermitian positive definite, T an approximation of its inverse,
///   Hermitian positive definite
/// \param x receives the last iterate, converged or not. The run ends if K or T turns out not to be
///   definite, or a value is not finite.
template <class K, class T, class Scalar>
internal::Conjugate_gradients_result<typename internal::Scalar_traits<Scalar>::FT>
conjugate_gradients(const K& apply_k, const T& precondition, const Block<Scalar>& b,
                    Block<Scalar>& x, const internal::Conjugate_gradients_options& options = {})
{
  const internal::Thread_team team;
  internal::Conjugate_gradients<Scalar, K, T> run(apply_k, precondition, b, options);
  for (int i = 0; i < options.max_iterations && run.step(); ++i) {
    if (options.go_further && !options.go_further()) break;
    run.turn();
  }
  return run.finish(x);
}

}  // namespace Conformal_geometry_processing
