// expect: moebius_transform\(\), invert_in_sphere\(\): unknown named parameter
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "concepts/triangle_mesh_archetype.h"

#include <Conformal_geometry_processing/moebius_transform.h>

namespace CGP = Conformal_geometry_processing;

int main()
{
  archetype::Triangle_mesh mesh{3, {{0, 1, 2}}};
  (void)CGP::moebius_transform(mesh, CGP::Moebius_map(), CGP::parameters::tolerance(.1));
}
