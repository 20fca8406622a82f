// expect: geom_traits is not a model of ConformalGeometryTraits_3
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "concepts/triangle_mesh_archetype.h"

#include <Conformal_geometry_processing/core/Graph_view.h>

namespace CGP = Conformal_geometry_processing;

struct Traits_of_the_plane {
  using FT = double;
  using Point_3 = int;
};

int main()
{
  const archetype::Triangle_mesh mesh{3, {{0, 1, 2}}};
  CGP::Graph_view<archetype::Triangle_mesh>(mesh, 0, Traits_of_the_plane(), "test");
}
