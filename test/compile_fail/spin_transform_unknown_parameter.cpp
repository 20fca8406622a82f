// expect: spin_transform\(\): unknown named parameter
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "concepts/triangle_mesh_archetype.h"

#include <Conformal_geometry_processing/spin_transform.h>

namespace CGP = Conformal_geometry_processing;

int main()
{
  archetype::Triangle_mesh mesh{3, {{0, 1, 2}}};
  const boost::static_property_map<double, archetype::Vertex> rho(1);
  (void)CGP::spin_transform(mesh, rho, CGP::parameters::tolerance(.1).time_step(.1));
}
