// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/linear_algebra/dense/Solver_status.h>
#include <Conformal_geometry_processing/threads/Thread_team.h>

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

}  // namespace Conformal_geometry_processing
