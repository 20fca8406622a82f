// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/core/named_parameters.h>

#include "support/mesh_tools.h"

/// What tests of entry points see of a mesh of any type.
namespace cgp_test {

/// the points as the mesh has them now, and its triangles
template <class Mesh>
Mesh_view view_of(const Mesh& mesh)
{
  namespace CGP = Conformal_geometry_processing;
  return CGP::Graph_view<Mesh>(mesh, CGP::parameters::default_values(), "test").view();
}

/// of points with the same number
double greatest_distance(const Points& a, const Points& b);

}  // namespace cgp_test
