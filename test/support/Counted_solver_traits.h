// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/direct/Default_solver_traits.h>

#include <type_traits>

namespace cgp_test {

/// of a solver, preconditioners included
struct Solver_counts {
  int analyses = 0, factorizations = 0, solves = 0;
};

/// the default solvers, whose operations are counted: one count for real and one for quaternionic
/// matrices
struct Counted_solver_traits {
  using Counts = Solver_counts;
  inline static Counts real, quaternionic;

  static void reset() { real = quaternionic = {}; }
  static int analyses() { return real.analyses + quaternionic.analyses; }
  static int factorizations() { return real.factorizations + quaternionic.factorizations; }

  template <class Scalar>
  class Solver : public Conformal_geometry_processing::Default_solver_traits::Solver<Scalar> {
    using Parent = Conformal_geometry_processing::Default_solver_traits::Solver<Scalar>;
    using Matrix = Conformal_geometry_processing::Hermitian_sparse_matrix<Scalar>;
    using Shift = Conformal_geometry_processing::Vector<double>;
    using Vectors = Conformal_geometry_processing::Block<Scalar>;

   public:
    template <class... Arguments>
    auto analyze(const Arguments&... arguments)
    {
      ++counts().analyses;
      return Parent::analyze(arguments...);
    }
    template <class... Arguments>
    auto analyze_with_positions(const Arguments&... arguments)
    {
      ++counts().analyses;
      return Parent::analyze_with_positions(arguments...);
    }
    template <class... Arguments>
    auto analyze_like(const Arguments&... arguments)
    {
      ++counts().analyses;
      return Parent::analyze_like(arguments...);
    }
    auto factorize(const Matrix& A, const Shift& shift)
    {
      ++counts().factorizations;
      return Parent::factorize(A, shift);
    }
    auto factorize_preconditioner(const Matrix& A, const Shift& shift)
    {
      ++counts().factorizations;
      return Parent::factorize_preconditioner(A, shift);
    }
    auto solve(const Vectors& b, Vectors& x) const
    {
      counts().solves += static_cast<int>(b.cols());
      return Parent::solve(b, x);
    }
    auto precondition(const Vectors& b, Vectors& x) const
    {
      counts().solves += static_cast<int>(b.cols());
      return Parent::precondition(b, x);
    }

   private:
    static Counts& counts() { return std::is_same_v<Scalar, double> ? real : quaternionic; }
  };
};

}  // namespace cgp_test
