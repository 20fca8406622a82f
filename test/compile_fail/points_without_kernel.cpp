// expect: the points of the mesh belong to no kernel: pass geom_traits
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "concepts/geometry_traits_archetype.h"
#include "concepts/triangle_mesh_archetype.h"

#include <Conformal_geometry_processing/core/geometry_traits.h>

namespace CGP = Conformal_geometry_processing;

struct Point_map {
  using key_type = archetype::Vertex;
  using value_type = cgp_test::Point_archetype;
  using reference = value_type;
  using category = boost::readable_property_map_tag;
};

int main()
{
  CGP::internal::geometry_traits<archetype::Triangle_mesh>(
      CGP::parameters::vertex_point_map(Point_map()));
}
