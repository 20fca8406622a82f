// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Iterative_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>

#include "parameterization/cgal_method.h"

namespace cgp_benchmark {
namespace {

using Circle = SMP::Circular_border_arc_length_parameterizer_3<Surface>;

/// `parameterize()` does not support it, because it has a number of iterations
Method iterative_authalic()
{
  return {"iterative authalic", [](Surface& mesh, Border border, UV_map uv) {
            SMP::Iterative_authalic_parameterizer_3<Surface, Circle> parameterizer;
            return in_words(parameterizer.parameterize(mesh, border, uv));
          }};
}

}  // namespace

std::vector<Method> methods_of_cgal()
{
  return {
      cgal_method("LSCM", SMP::LSCM_parameterizer_3<Surface>()),
      cgal_method("ARAP, lambda 0", SMP::ARAP_parameterizer_3<Surface>(0.)),
      cgal_method("ARAP, lambda 1000", SMP::ARAP_parameterizer_3<Surface>(1000.)),
      cgal_method("discrete conformal map", SMP::Discrete_conformal_map_parameterizer_3<Surface>()),
      cgal_method("mean value", SMP::Mean_value_coordinates_parameterizer_3<Surface>()),
      cgal_method("Tutte", SMP::Barycentric_mapping_parameterizer_3<Surface>()),
      cgal_method("discrete authalic", SMP::Discrete_authalic_parameterizer_3<Surface>()),
      iterative_authalic()};
}

}  // namespace cgp_benchmark
