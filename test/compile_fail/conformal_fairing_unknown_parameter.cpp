// expect: conformal_fairing\(\): unknown named parameter
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "concepts/triangle_mesh_archetype.h"

#include <Conformal_geometry_processing/conformal_fairing.h>

#include <vector>

namespace CGP = Conformal_geometry_processing;

int main()
{
  archetype::Triangle_mesh mesh{3, {{0, 1, 2}}};
  const std::vector<boost::graph_traits<archetype::Triangle_mesh>::face_descriptor> region;
  (void)CGP::conformal_fairing(mesh, region, CGP::parameters::time_step(.1));
}
