// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <random>
#include <utility>
#include <vector>

namespace cgp_benchmark {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

/// Everything that is random is drawn from this.
using Chance = std::mt19937;

double uniform(Chance& chance, double low, double high);

/// a body of revolution about z with the given profile of (radius, height), the ends on the axis
Mesh turned(const std::vector<std::pair<double, double>>& profile, int segments);

/// a box, cylinder, cone, ball or torus of random size, turn and place, with few faces
Mesh random_solid(Chance& chance);

/// a star over a polygon, with caps triangulated as CAD programs do
Mesh random_extrusion(Chance& chance);

/// a ball or torus with waves and noise, and vertices that are denser on one side
Mesh random_scan(Chance& chance);

/// the union of some solids, as intersected curves cut it: with slivers and needles
Mesh random_union(Chance& chance);

/// a union without a smaller copy of itself and what lies above: an open vessel with a thin wall
Mesh random_vessel(Chance& chance);

/// what is below a random plane through the middle, and open there
Mesh random_cut(Chance& chance, const Mesh& mesh);

}  // namespace cgp_benchmark
