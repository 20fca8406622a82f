// expect: positions and directions of the boundary cannot be prescribed both
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "concepts/archetype_maps.h"

#include <Conformal_geometry_processing/spin_transform.h>

#include "support/bounded_meshes.h"

namespace CGP = Conformal_geometry_processing;

int main()
{
  const cgp_test::Mesh_view view = cgp_test::disk(2);
  const cgp_test::Point_map_archetype points(view);
  archetype::Triangle_mesh mesh = cgp_test::archetype_of(view);
  const boost::static_property_map<double, archetype::Vertex> rho(1);
  (void)CGP::spin_transform(
      mesh, rho,
      CGP::parameters::vertex_point_map(points)
          .geom_traits(cgp_test::Geometry_traits_archetype(cgp_test::archetype_unit))
          .vertex_target_point_map(points)
          .boundary_direction(CGP::Boundary_direction{1, 0, 0}));
}
