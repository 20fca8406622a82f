// expect: the key type of the map must be the vertex or the face descriptor
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "concepts/triangle_mesh_archetype.h"

#include <Conformal_geometry_processing/canonical_metric.h>

namespace CGP = Conformal_geometry_processing;

struct Density_map {
  using key_type = archetype::Halfedge;
  using value_type = double;
  using reference = void;
  using category = boost::writable_property_map_tag;
};

int main()
{
  archetype::Triangle_mesh mesh{3, {{0, 1, 2}}};
  (void)CGP::canonical_metric(mesh, Density_map());
}
