// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/krylov/Lobpcg.h>

#include "quaternionic_linear_algebra/spectral_problem.h"

namespace cgp_test {

inline CGP::Eigensolver_options until(double tolerance, int wanted = 1, int max_iterations = 200)
{
  CGP::Eigensolver_options options;
  options.tolerance = tolerance;
  options.wanted = wanted;
  options.max_iterations = max_iterations;
  return options;
}

template <class GoFurther = CGP::internal::Always_go_further>
CGP::Eigensolver_result solve(const Spectral_problem& problem,
                              const CGP::Block<Quaternion<double>>& x0,
                              const CGP::Eigensolver_options& options, double shift = 1e-3,
                              GoFurther go_further = {})
{
  return CGP::lobpcg(problem.k(), problem.n(), problem.inverse(shift), x0, options, go_further);
}

}  // namespace cgp_test
