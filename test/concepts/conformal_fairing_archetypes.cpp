// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/conformal_fairing.h
#include "concepts/archetype_maps.h"

#include <Conformal_geometry_processing/conformal_fairing.h>

#include <gtest/gtest.h>

#include <vector>

#include "support/meshes.h"

namespace cgp_test::conformal_fairing_archetypes_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Conformal_fairing_of_archetypes, needs_no_more_than_the_concepts_offer)
{
  const Mesh_view view = bumpy_sphere(2);
  archetype::Triangle_mesh mesh = archetype_of(view);
  Points points{3, view.size_of_vertices()};
  std::vector<archetype::Face> region;
  std::vector<char> is_in_region(at(view.size_of_faces()), 0);
  for (const archetype::Face f : faces(mesh))
    if (view.position(view.corners(static_cast<int>(f.number))[0]).z() > 0) {
      region.push_back(f);
      is_in_region[f.number] = 1;
    }
  const auto np = CGP::parameters::vertex_point_map(Point_map_archetype(view))
                      .geom_traits(Geometry_traits_archetype(archetype_unit))
                      .output_vertex_point_map(Output_map_archetype(points))
                      .exact_conformal_class(false);
  EXPECT_TRUE(CGP::conformal_fairing(mesh, region, np));
  const auto expected =
      CGP::internal::fair_region(view, is_in_region, {false}, "test", [] { return true; });
  EXPECT_EQ(points, expected.positions);
}

}  // namespace cgp_test::conformal_fairing_archetypes_tests
