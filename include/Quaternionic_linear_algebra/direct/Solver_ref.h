// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/dense/Solver_status.h>
#include <Quaternionic_linear_algebra/dense/block_operators.h>
#include <Quaternionic_linear_algebra/direct/Default_solver_traits.h>
#include <Quaternionic_linear_algebra/direct/Ordering.h>

#include <Eigen/Core>

#include <complex>
#include <functional>
#include <memory>
#include <tuple>
#include <type_traits>
#include <utility>

namespace Conformal_geometry_processing {
namespace internal {

struct Solver_interface {
  virtual ~Solver_interface() = default;
  virtual const Ordering& ordering() const = 0;
  virtual Solver_statistics statistics() const = 0;
  virtual void release() = 0;
};

// What the library calls of a model of `SparseHermitianSolver`. A factorization or a solution takes
// at least a thousand times as long as a virtual call.
template <class Scalar>
struct Typed_solver_interface : Solver_interface {
  using Matrix = Hermitian_sparse_matrix<Scalar>;
  using Shift = Vector<typename Scalar_traits<Scalar>::FT>;

  virtual std::unique_ptr<Typed_solver_interface> another() const = 0;
  virtual std::unique_ptr<Typed_solver_interface<double>> another_for_numbers() const = 0;
  virtual Solver_status analyze(const Sparse_pattern& pattern) = 0;
  virtual Solver_status analyze(const Sparse_pattern& pattern, const Ordering& order) = 0;
  virtual Solver_status analyze_with_positions(const Sparse_pattern& pattern,
                                               const Eigen::Matrix3Xd& positions) = 0;
  virtual Solver_status analyze_like(const Sparse_pattern& pattern,
                                     const Solver_interface& other) = 0;
  virtual Solver_status factorize(const Matrix& A, const Shift& shift) = 0;
  virtual Solver_status factorize_preconditioner(const Matrix& A, const Shift& shift) = 0;
  virtual Solver_status solve(const Block<Scalar>& b, Block<Scalar>& x) const = 0;
  virtual Solver_status precondition(const Block<Scalar>& b, Block<Scalar>& x) const = 0;
};

template <class Scalar>
using Solver_pointer = std::unique_ptr<Typed_solver_interface<Scalar>>;

template <class SolverTraits, class Scalar>
class Solver_model final : public Typed_solver_interface<Scalar> {
 public:
  using typename Typed_solver_interface<Scalar>::Matrix;
  using typename Typed_solver_interface<Scalar>::Shift;

  static Solver_pointer<Scalar> make() { return std::make_unique<Solver_model>(); }

  Solver_pointer<Scalar> another() const override { return make(); }
  Solver_pointer<double> another_for_numbers() const override
  {
    return Solver_model<SolverTraits, double>::make();
  }
  Solver_status analyze(const Sparse_pattern& pattern) override { return solver.analyze(pattern); }
  Solver_status analyze(const Sparse_pattern& pattern, const Ordering& order) override
  {
    return solver.analyze(pattern, order);
  }
  Solver_status analyze_with_positions(const Sparse_pattern& pattern,
                                       const Eigen::Matrix3Xd& positions) override
  {
    return solver.analyze_with_positions(pattern, positions);
  }
  Solver_status analyze_like(const Sparse_pattern& pattern, const Solver_interface& other) override
  {
    if (const auto* same = dynamic_cast<const Solver_model*>(&other))
      return solver.analyze_like(pattern, same->solver);
    using Other = std::conditional_t<std::is_same_v<Scalar, double>, Quaternion<double>, double>;
    if (const auto* like = dynamic_cast<const Solver_model<SolverTraits, Other>*>(&other))
      return solver.analyze_like(pattern, like->solver);
    return solver.analyze(pattern, other.ordering());
  }
  Solver_status factorize(const Matrix& A, const Shift& shift) override
  {
    return solver.factorize(A, shift);
  }
  Solver_status factorize_preconditioner(const Matrix& A, const Shift& shift) override
  {
    return Conformal_geometry_processing::factorize_preconditioner(solver, A, shift);
  }
  Solver_status solve(const Block<Scalar>& b, Block<Scalar>& x) const override
  {
    return solver.solve(b, x);
  }
  Solver_status precondition(const Block<Scalar>& b, Block<Scalar>& x) const override
  {
    return apply_inverse(solver, b, x);
  }
  const Ordering& ordering() const override { return solver.ordering(); }
  Solver_statistics statistics() const override { return solver.statistics(); }
  void release() override { release_factor(solver); }

  typename SolverTraits::template Solver<Scalar> solver;
};

// Compiled in the library, for `double`, `std::complex<double>` and `Quaternion<double>`.
template <class Scalar>
Solver_pointer<Scalar> make_default_solver();

template <class SolverTraits, class Scalar>
Solver_pointer<Scalar> make_solver()
{
  if constexpr (std::is_same_v<SolverTraits, Default_solver_traits>)
    return make_default_solver<Scalar>();
  else
    return Solver_model<SolverTraits, Scalar>::make();
}

/// \brief A solver of any traits, behind virtual calls: the entry points wrap the caller's solver
/// in it, and what lies below them is compiled once.
///
/// All members do what the concept says. Where the wrapped solver has no preconditioner,
/// `precondition()` is `solve()`.
/// \tparam Scalar_ `double`, `std::complex<double>` or `Quaternion<double>`
/// \cgalModels{SparseHermitianSolver}
template <class Scalar_>
class Solver_ref {
 public:
  using Scalar = Scalar_;
  using FT = typename Scalar_traits<Scalar>::FT;

  /// the library's own solver
  Solver_ref() : Solver_ref(make_default_solver<Scalar>()) {}
  explicit Solver_ref(Solver_pointer<Scalar> solver) : m_solver(std::move(solver)) {}

  /// a solver of the same traits, for the same scalars or numbers, that has analyzed nothing yet
  template <class OtherScalar = Scalar>
  Solver_ref<OtherScalar> another() const
  {
    if constexpr (std::is_same_v<OtherScalar, Scalar>)
      return Solver_ref(m_solver->another());
    else
      return Solver_ref<OtherScalar>(m_solver->another_for_numbers());
  }

  Solver_status analyze(const Sparse_pattern& pattern) { return m_solver->analyze(pattern); }
  Solver_status analyze(const Sparse_pattern& pattern, const Ordering& order)
  {
    return m_solver->analyze(pattern, order);
  }
  Solver_status analyze_with_positions(const Sparse_pattern& pattern,
                                       const Eigen::Matrix3Xd& positions)
  {
    return m_solver->analyze_with_positions(pattern, positions);
  }
  template <class OtherScalar>
  Solver_status analyze_like(const Sparse_pattern& pattern, const Solver_ref<OtherScalar>& other)
  {
    return m_solver->analyze_like(pattern, *other.m_solver);
  }
  const Ordering& ordering() const { return m_solver->ordering(); }
  Solver_status factorize(const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift)
  {
    return m_solver->factorize(A, shift);
  }
  Solver_status factorize_preconditioner(const Hermitian_sparse_matrix<Scalar>& A,
                                         const Vector<FT>& shift)
  {
    return m_solver->factorize_preconditioner(A, shift);
  }
  Solver_status solve(const Block<Scalar>& b, Block<Scalar>& x) const
  {
    return m_solver->solve(b, x);
  }
  Solver_status precondition(const Block<Scalar>& b, Block<Scalar>& x) const
  {
    return m_solver->precondition(b, x);
  }
  Solver_statistics statistics() const { return m_solver->statistics(); }
  void release() { m_solver->release(); }

 private:
  template <class>
  friend class Solver_ref;

  Solver_pointer<Scalar> m_solver;  // never null
};

/// \brief Traits of solvers for some scalars, whose type is forgotten.
template <class... Scalars>
class Solver_traits_ref {
 public:
  Solver_traits_ref() : m_make{&make_default_solver<Scalars>...} {}

  /// \tparam SolverTraits a model of `SparseHermitianSolverTraits`; converts
  template <class SolverTraits, class = std::void_t<typename SolverTraits::template Solver<double>>>
  Solver_traits_ref(const SolverTraits&) : m_make{&make_solver<SolverTraits, Scalars>...}
  {}

  /// \param make makers of solvers that know more than their matrix, such as where its other parts
  /// are
  explicit Solver_traits_ref(std::function<Solver_pointer<Scalars>()>... make)
      : m_make{std::move(make)...}
  {}

  template <class Scalar>
  Solver_ref<Scalar> solver() const
  {
    return Solver_ref<Scalar>(std::get<std::function<Solver_pointer<Scalar>()>>(m_make)());
  }

 private:
  std::tuple<std::function<Solver_pointer<Scalars>()>...> m_make;
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Traits of solvers, in place of a template parameter: the library's own by default; any
/// model of `SparseHermitianSolverTraits` converts to it.
using Spin_solvers = internal::Solver_traits_ref<double, Quaternion<double>>;

/// \ingroup PkgLinearAlgebra
/// \brief The same for parameterizations, whose unknowns are complex.
using Map_solvers = internal::Solver_traits_ref<double, std::complex<double>>;

}  // namespace Conformal_geometry_processing
