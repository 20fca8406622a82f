// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/direct/Supernodal_cholesky.h>

#include "factors.h"

namespace cgp_benchmark {

void add_native_factors(std::vector<Row>& rows)
{
  using Quaternion = CGP::Quaternion<double>;
  rows.push_back({"factor", "native, real n", measure_factor<CGP::Supernodal_cholesky<double>>});
  rows.push_back(
      {"factor", "native, real n, float", measure_factor<CGP::Supernodal_cholesky<double, float>>});
  rows.push_back(
      {"factor", "native, quaternion n", measure_factor<CGP::Supernodal_cholesky<Quaternion>>});
  rows.push_back({"factor", "native, quaternion n, float",
                  measure_factor<CGP::Supernodal_cholesky<Quaternion, float>>});
}

}  // namespace cgp_benchmark
