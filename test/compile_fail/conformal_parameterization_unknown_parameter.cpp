// expect: conformal_parameterization\(\): unknown named parameter
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "concepts/triangle_mesh_archetype.h"

#include <Conformal_geometry_processing/conformal_parameterization.h>

#include <boost/property_map/property_map.hpp>

#include <complex>
#include <map>

namespace CGP = Conformal_geometry_processing;

int main()
{
  archetype::Triangle_mesh mesh{3, {{0, 1, 2}}};
  std::map<archetype::Vertex, std::complex<double>> uv;
  (void)CGP::conformal_parameterization(mesh, boost::make_assoc_property_map(uv),
                                        CGP::parameters::time_step(.1));
}
