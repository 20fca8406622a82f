// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/adapters/Cholmod_hermitian_solver_traits.h>
#include <Quaternionic_linear_algebra/adapters/Eigen_hermitian_solver_traits.h>

#include "factors.h"
#include "support/Real_form_traits.h"

namespace cgp_benchmark {

using cgp_test::Real_form_traits;

void add_other_factors(std::vector<Row>& rows)
{
  using Quaternion = CGP::Quaternion<double>;
  const auto add = [&](const char* model, Row::Measure measure, int most_vertices,
                       const char* reason) {
    rows.push_back({"factor", model, measure, most_vertices, reason});
  };
  add("CHOLMOD, complex 2n",
      measure_factor<CGP::Cholmod_hermitian_solver_traits::Solver<Quaternion>>, 300'000,
      "takes a minute and 6 GB");
  add("CHOLMOD, real 4n",
      measure_factor<Real_form_traits<CGP::internal::Cholmod_backend>::Solver<Quaternion>>, 300'000,
      "takes minutes and 12 GB");
  add("Eigen, complex 2n", measure_factor<CGP::Eigen_hermitian_solver_traits::Solver<Quaternion>>,
      20'000, "time grows like the square of the size");
  add("Eigen, real 4n",
      measure_factor<Real_form_traits<CGP::internal::Eigen_backend>::Solver<Quaternion>>, 20'000,
      "time grows like the square of the size");
}

}  // namespace cgp_benchmark
