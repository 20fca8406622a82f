// expect: conformal_willmore_flow\(\): unknown named parameter
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "concepts/triangle_mesh_archetype.h"

#include <Conformal_geometry_processing/conformal_willmore_flow.h>

namespace CGP = Conformal_geometry_processing;

int main()
{
  archetype::Triangle_mesh mesh{3, {{0, 1, 2}}};
  (void)CGP::conformal_willmore_flow(mesh, CGP::parameters::spectral_shift(1));
}
