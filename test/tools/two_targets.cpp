// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Compiled twice, for different vector units, and linked to one program: what one part has factored
// the other may solve with, and both compute the same. The compiled library gives the same bits;
// used header-only, the linker takes the templates of either part, and results are right.
#include <Quaternionic_linear_algebra/direct/Supernodal_cholesky.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "quaternionic_linear_algebra/hermitian_matrices.h"

#define CGP_JOINED(a, b) a##b
#define CGP_NAME(unit) CGP_JOINED(solve_, unit)

namespace CGP = Conformal_geometry_processing;
using Scalar = CGP::Quaternion<double>;
using Solver = CGP::Supernodal_cholesky<Scalar>;
using Matrix = CGP::Hermitian_sparse_matrix<Scalar>;

std::vector<double> solve_baseline(const Matrix& A, Solver& solver, bool factorizes);
std::vector<double> solve_avx2(const Matrix& A, Solver& solver, bool factorizes);

/// the solution for a right-hand side of whole numbers; nothing if it fails
std::vector<double> CGP_NAME(CGP_UNIT)(const Matrix& A, Solver& solver, bool factorizes)
{
  constexpr auto success = CGP::Solver_status::success;
  if (factorizes && (solver.analyze(A.pattern()) != success || solver.factorize(A, {}) != success))
    return {};
  CGP::Block<Scalar> b(A.size(), 3), x;
  for (int i = 0; i < A.size(); ++i)
    for (int c = 0; c < 3; ++c) b(i, c) = {double(i % 5), double(c), double(i % 3 - 1), 1};
  if (solver.solve(b, x) != success) return {};
  const double* const numbers = reinterpret_cast<const double*>(x.data());
  return {numbers, numbers + 4 * x.size()};
}

#ifdef CGP_MAIN

// A grid whose entries are whole numbers, the same whatever it is compiled for.
Matrix some_matrix()
{
  Matrix A(cgp_test::grid_pattern(40, 40));
  for (int j = 0; j < A.size(); ++j)
    for (int k = A.pattern().offsets[std::size_t(j)]; k < A.pattern().offsets[std::size_t(j) + 1];
         ++k)
      A.value(k) = A.pattern().indices[std::size_t(k)] == j
                       ? Scalar{12, 0, 0, 0}
                       : Scalar{-1, double(k % 3 - 1), double(k % 2), -1};
  return A;
}

double difference(const std::vector<double>& a, const std::vector<double>& b)
{
  if (a.empty() || a.size() != b.size()) return HUGE_VAL;
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::fmax(most, std::fabs(a[i] - b[i]));
  return most;
}

int main()
{
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) return 0;
  const Matrix A = some_matrix();
  Solver first, second;
  const std::vector<double> x = solve_baseline(A, first, true), y = solve_avx2(A, second, true);
  const double differences[] = {difference(x, y), difference(x, solve_avx2(A, first, false)),
                                difference(y, solve_baseline(A, second, false))};
#ifdef CGP_HEADER_ONLY
  const double allowed = 1e-12;
#else
  const double allowed = 0;
#endif
  for (const double d : differences) {
    std::printf("%g\n", d);
    if (!(d <= allowed)) return 1;
  }
}

#endif
