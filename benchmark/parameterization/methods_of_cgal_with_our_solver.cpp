// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/core/Supernodal_linear_algebra_traits.h>

#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>

#include "parameterization/cgal_method.h"

namespace cgp_benchmark {

std::vector<Method> methods_of_cgal_with_our_solver()
{
  using Solver = Conformal_geometry_processing::Supernodal_linear_algebra_traits;
  using Pins = SMP::Two_vertices_parameterizer_3<Surface>;
  using Circle = SMP::Circular_border_arc_length_parameterizer_3<Surface>;
  using ARAP = SMP::ARAP_parameterizer_3<Surface, Pins, Solver>;
  return {cgal_method("LSCM, our solver", SMP::LSCM_parameterizer_3<Surface, Pins, Solver>()),
          cgal_method("ARAP, lambda 0, our solver", ARAP(0.)),
          cgal_method("ARAP, lambda 1000, our solver", ARAP(1000.)),
          cgal_method("discrete conformal map, our solver",
                      SMP::Discrete_conformal_map_parameterizer_3<Surface, Circle, Solver>()),
          cgal_method("Tutte, our solver",
                      SMP::Barycentric_mapping_parameterizer_3<Surface, Circle, Solver>())};
}

}  // namespace cgp_benchmark
