// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include "parameterization/Method.h"

namespace cgp_benchmark {

namespace SMP = CGAL::Surface_mesh_parameterization;

inline std::string in_words(SMP::Error_code code)
{
  return code == SMP::OK ? "OK" : SMP::get_error_message(code);
}

/// a model of CGAL's `Parameterizer_3` as a method
template <class Parameterizer>
Method cgal_method(const std::string& name, Parameterizer parameterizer)
{
  return {name, [parameterizer](Surface& mesh, Border border, UV_map uv) {
            return in_words(SMP::parameterize(mesh, parameterizer, border, uv));
          }};
}

}  // namespace cgp_benchmark
