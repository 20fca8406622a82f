// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>
#include <Quaternionic_linear_algebra/dense/Solver_status.h>
#include <Quaternionic_linear_algebra/exceptions.h>
#include <Quaternionic_linear_algebra/threads/Thread_team.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief Computes y = A x, where `apply` is A, for all columns of x at once.
///
/// \param apply a callable (x, y) that writes y in place, like the operators below, or x -> y
template <class Operator, class Scalar>
void apply_operator(const Operator& apply, const Block<Scalar>& x, Block<Scalar>& y)
{
  if constexpr (std::is_invocable_v<const Operator&, const Block<Scalar>&, Block<Scalar>&>)
    apply(x, y);
  else
    y = apply(x);
}

namespace internal {

// Supports both calls: fill(x, y) and y = f(x).
template <class Scalar, class Fill>
struct Block_operator {
  Fill fill;

  void operator()(const Block<Scalar>& x, Block<Scalar>& y) const { fill(x, y); }

  Block<Scalar> operator()(const Block<Scalar>& x) const
  {
    Block<Scalar> y;
    fill(x, y);
    return y;
  }
};

template <class Scalar, class Fill>
Block_operator<Scalar, Fill> make_block_operator(Fill fill)
{
  return {std::move(fill)};
}

template <class Solver, class = void>
constexpr bool is_preconditioner = false;

template <class Solver>
constexpr bool
    is_preconditioner<Solver, std::void_t<decltype(std::declval<const Solver&>().precondition(
                                  std::declval<const Block<typename Solver::Scalar>&>(),
                                  std::declval<Block<typename Solver::Scalar>&>()))>> = true;

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief The operator x -> A x for all columns of x at once. Stores a reference to A.
template <class Scalar>
auto block_operator(const Hermitian_sparse_matrix<Scalar>& A)
{
  return internal::make_block_operator<Scalar>([&A](const Block<Scalar>& x, Block<Scalar>& y) {
    y.resize(x.rows(), x.cols());
    internal::for_each_range(A.size(), 512, [&](std::ptrdiff_t first, std::ptrdiff_t last) {
      for (Eigen::Index c = 0; c < x.cols(); ++c)
        A.multiply_rows(static_cast<int>(first), static_cast<int>(last), x.col(c), y.col(c));
    });
  });
}

/// \ingroup PkgLinearAlgebra
/// \brief The operator x -> diag(masses) x for all columns of x at once. Stores a reference to the
/// masses.
template <class FT>
auto block_operator(const Vector<FT>& masses)
{
  using Scalar = Quaternion<FT>;
  return internal::make_block_operator<Scalar>([&masses](const Block<Scalar>& x, Block<Scalar>& y) {
    y.resize(x.rows(), x.cols());
    internal::for_each_range(x.rows(), 8192, [&](std::ptrdiff_t first, std::ptrdiff_t last) {
      for (Eigen::Index c = 0; c < x.cols(); ++c)
        for (std::ptrdiff_t i = first; i < last; ++i) y(i, c) = masses[i] * x(i, c);
    });
  });
}

/// \ingroup PkgLinearAlgebra
/// \brief Computes x = T b for all columns of b at once, where `solver` has factorized A and T is
/// its `precondition()`, if it has one, or else A^-1.
template <class Solver, class Scalar>
Solver_status apply_inverse(const Solver& solver, const Block<Scalar>& b, Block<Scalar>& x)
{
  if constexpr (internal::is_preconditioner<Solver>)
    return solver.precondition(b, x);
  else
    return solver.solve(b, x);
}

/// \ingroup PkgLinearAlgebra
/// \brief The operator b -> T b, see `apply_inverse()`. Stores a reference to the solver; throws
/// `Solver_error` if the solver fails.
template <class Solver>
auto inverse_operator(const Solver& solver)
{
  using Scalar = typename Solver::Scalar;
  return internal::make_block_operator<Scalar>([&solver](const Block<Scalar>& b, Block<Scalar>& x) {
    const Solver_status status = apply_inverse(solver, b, x);
    if (status != Solver_status::success) throw Solver_error("inverse_operator", to_string(status));
  });
}

namespace internal {

template <class Solver, class = void>
constexpr bool can_factorize_preconditioner = false;

template <class Solver>
constexpr bool can_factorize_preconditioner<
    Solver, std::void_t<decltype(std::declval<Solver&>().factorize_preconditioner(
                std::declval<const Hermitian_sparse_matrix<typename Solver::Scalar>&>(),
                std::declval<const Vector<typename Solver::FT>&>()))>> = is_preconditioner<Solver>;

template <class Solver, class = void>
constexpr bool can_release = false;

template <class Solver>
constexpr bool can_release<Solver, std::void_t<decltype(std::declval<Solver&>().release())>> = true;

/// \brief Field of the coefficients in linear combinations of quaternionic vectors.
///
/// Vectors with prescribed directions at the boundary (`Reduced_basis`) form a vector space over
/// the real numbers only: their inner product is the real part of the quaternionic one, and all
/// quantities derived from inner products are real as well.
enum class Coefficients { quaternions, reals };

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief factorizes A + diag(shift) for `apply_inverse()` only: by the solver's
/// `factorize_preconditioner()`, which may be less exact, if it has one.
template <class Solver>
Solver_status factorize_preconditioner(Solver& solver,
                                       const Hermitian_sparse_matrix<typename Solver::Scalar>& A,
                                       const Vector<typename Solver::FT>& shift)
{
  if constexpr (internal::can_factorize_preconditioner<Solver>)
    return solver.factorize_preconditioner(A, shift);
  else
    return solver.factorize(A, shift);
}

/// \ingroup PkgLinearAlgebra
/// \brief Releases the memory of the solver's factor, if the solver has a member `release()`; its
/// analysis stays.
template <class Solver>
void release_factor(Solver& solver)
{
  if constexpr (internal::can_release<Solver>) solver.release();
}

/// \ingroup PkgLinearAlgebra
/// \brief Returns q, or its real part
template <class FT>
Quaternion<FT> reduced_to(internal::Coefficients coefficients, const Quaternion<FT>& q)
{
  return coefficients == internal::Coefficients::reals ? Quaternion<FT>{q.w, 0, 0, 0} : q;
}

/// \ingroup PkgLinearAlgebra
/// \brief Returns A^H B, the inner products of the columns of A with those of B.
///
/// Does not use Eigen's dense products, which may swap their factors; quaternions do not commute.
template <class FT>
Block<Quaternion<FT>> gram_matrix(
    const Block<Quaternion<FT>>& A, const Block<Quaternion<FT>>& B,
    internal::Coefficients coefficients = internal::Coefficients::quaternions)
{
  Block<Quaternion<FT>> G(A.cols(), B.cols());
  for (Eigen::Index j = 0; j < B.cols(); ++j)
    for (Eigen::Index i = 0; i < A.cols(); ++i)
      G(i, j) = reduced_to(coefficients, inner_product(A.col(i), B.col(j)));
  return G;
}

/// \ingroup PkgLinearAlgebra
/// \brief Returns Re A^H C: the real inner products of the columns of A with those of C.
template <class FT>
Block<FT> real_gram_matrix(const Block<Quaternion<FT>>& A, const Block<Quaternion<FT>>& C)
{
  const auto numbers = [](const Block<Quaternion<FT>>& x) {
    return Eigen::Map<const Block<FT>>(reinterpret_cast<const FT*>(x.data()), 4 * x.rows(),
                                       x.cols());
  };
  return numbers(A).transpose() * numbers(C);
}

/// \ingroup PkgLinearAlgebra
/// \brief Computes y += x q for columns x and y; y may be a column of the same block as x.
/// \tparam Y, X vectors or columns with their own storage
template <class Y, class X, class FT>
void add_multiple(Y&& y, const X& x, const Quaternion<FT>& q)
{
  using Four = Eigen::Array<FT, 4, 1>;
  const std::ptrdiff_t least = 8192;
  internal::for_each_range(x.size(), least, [&](std::ptrdiff_t first, std::ptrdiff_t last) {
    // x q = x.w q + x.x (i q) + x.y (j q) + x.z (k q), a sum of products of a number and a vector.
    const Four w(q.w, q.x, q.y, q.z), i(-q.x, q.w, -q.z, q.y), j(-q.y, q.z, q.w, -q.x),
        k(-q.z, -q.y, q.x, q.w);
    for (std::ptrdiff_t n = first; n < last; ++n) {
      const Quaternion<FT> a = x[n];
      Eigen::Map<Four> sum(&y.coeffRef(n).w);
      sum += a.w * w + a.x * i + a.y * j + a.z * k;
    }
  });
}

/// \ingroup PkgLinearAlgebra
/// \brief Computes W += V C in place: combines the columns of V with coefficients from the right.
template <class FT>
void add_combination(Block<Quaternion<FT>>& W, const Block<Quaternion<FT>>& V,
                     const Block<Quaternion<FT>>& C)
{
  for (Eigen::Index j = 0; j < C.cols(); ++j)
    for (Eigen::Index k = 0; k < V.cols(); ++k) add_multiple(W.col(j), V.col(k), C(k, j));
}

/// \ingroup PkgLinearAlgebra
/// \brief Returns V C
template <class FT>
Block<Quaternion<FT>> combination(const Block<Quaternion<FT>>& V, const Block<Quaternion<FT>>& C)
{
  Block<Quaternion<FT>> W = Block<Quaternion<FT>>::Constant(V.rows(), C.cols(), Quaternion<FT>{});
  add_combination(W, V, C);
  return W;
}

/// \ingroup PkgLinearAlgebra
/// \brief Computes W = W C + V D, in the memory of W if its size does not change.
///
/// Processes some rows at a time to avoid another copy of W.
template <class FT>
void replace_by_combination(Block<Quaternion<FT>>& W, const Block<Quaternion<FT>>& C,
                            const Block<Quaternion<FT>>& V, const Block<Quaternion<FT>>& D)
{
  const Eigen::Index rows = V.rows(), most = 256, old = W.cols();
  if (old != D.cols()) W.conservativeResize(rows, (std::max)(old, D.cols()));
  const std::ptrdiff_t least = 2048;
  internal::for_each_range(rows, least, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    Block<Quaternion<FT>> part((std::min)(end - begin, most), D.cols());
    for (Eigen::Index first = begin; first < end; first += most) {
      const Eigen::Index count = (std::min)(most, end - first);
      part.setConstant(Quaternion<FT>{});
      for (Eigen::Index j = 0; j < D.cols(); ++j) {
        auto target = part.col(j).head(count);
        for (Eigen::Index k = 0; k < old; ++k)
          add_multiple(target, W.col(k).segment(first, count), C(k, j));
        for (Eigen::Index k = 0; k < V.cols(); ++k)
          add_multiple(target, V.col(k).segment(first, count), D(k, j));
      }
      W.block(first, 0, count, D.cols()) = part.topRows(count);
    }
  });
  if (old > D.cols()) W.conservativeResize(rows, D.cols());
}

/// \ingroup PkgLinearAlgebra
/// \brief Multiplies column j of V by s
template <class FT>
void scale_column(Block<Quaternion<FT>>& V, Eigen::Index j, FT s)
{
  for (Eigen::Index i = 0; i < V.rows(); ++i) V(i, j) *= s;
}

/// \ingroup PkgLinearAlgebra
/// \brief adds the part of v that is orthogonal to the columns of V, scaled to norm 1, as the last
/// column; v may be a column of another block. O(n k) for V of n x k.
/// \param V orthonormal with respect to `weights`, or empty
/// \param weights n, positive
/// \returns false, and leaves V as it is, if v is in the span up to rounding
template <class FT>
bool extend_orthonormal(Block<Quaternion<FT>>& V, const Vector<FT>& weights,
                        Quaternion_vector<FT> v)
{
  const auto norm = [&] { return std::sqrt(inner_product(v, weights, v).w); };
  const FT length = norm(), rounding = FT(1e-12);
  for (int pass = 0; pass < 2; ++pass)
    for (Eigen::Index j = 0; j < V.cols(); ++j)
      add_multiple(v, V.col(j), -inner_product(V.col(j), weights, v));
  const FT rest = norm();
  if (!(rest > rounding * length)) return false;
  V.conservativeResize(v.size(), V.cols() + 1);
  V.rightCols(1) = v;
  scale_column(V, V.cols() - 1, 1 / rest);
  return true;
}

}  // namespace Conformal_geometry_processing
