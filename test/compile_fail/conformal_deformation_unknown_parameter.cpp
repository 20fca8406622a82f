// expect: conformal_deformation\(\): unknown named parameter
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "concepts/triangle_mesh_archetype.h"

#include <Conformal_geometry_processing/conformal_deformation.h>

#include <CGAL/Simple_cartesian.h>

#include <utility>
#include <vector>

namespace CGP = Conformal_geometry_processing;

int main()
{
  archetype::Triangle_mesh mesh{3, {{0, 1, 2}}};
  using Vertex = boost::graph_traits<archetype::Triangle_mesh>::vertex_descriptor;
  const std::vector<std::pair<Vertex, CGAL::Simple_cartesian<double>::Point_3>> targets;
  (void)CGP::conformal_deformation(mesh, targets, CGP::parameters::time_step(.1));
}
