// expect: dirac_spectrum\(\): unknown named parameter
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "concepts/triangle_mesh_archetype.h"

#include <Conformal_geometry_processing/dirac_spectrum.h>

namespace CGP = Conformal_geometry_processing;

int main()
{
  archetype::Triangle_mesh mesh{3, {{0, 1, 2}}};
  (void)CGP::dirac_spectrum(mesh, 3, CGP::parameters::time_step(.1));
}
