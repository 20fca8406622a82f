// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/moebius_transform.h
#include "concepts/archetype_maps.h"

#include <Conformal_geometry_processing/moebius_transform.h>

#include <gtest/gtest.h>

#include "support/dense.h"
#include "support/meshes.h"

namespace cgp_test::moebius_transform_archetypes_tests {

namespace CGP = Conformal_geometry_processing;
using Spins = Quaternion_vector<double>;
using Spin_map = Writable_map_archetype<archetype::Vertex, Quaternion<double>, Spins>;

class Moebius_transform_of_archetypes : public testing::Test {
 protected:
  auto parameters()
  {
    return CGP::parameters::vertex_point_map(Point_map_archetype(view))
        .geom_traits(Geometry_traits_archetype(archetype_unit))
        .output_vertex_point_map(Output_map_archetype(points))
        .vertex_spin_map(Spin_map(spins));
  }

  const Mesh_view view = bumpy_sphere(1);
  archetype::Triangle_mesh mesh = archetype_of(view);
  Points points{3, view.size_of_vertices()};
  Spins spins{view.size_of_vertices()};
};

TEST_F(Moebius_transform_of_archetypes, needs_no_more_than_the_concepts_offer)
{
  const CGP::Moebius_map map = CGP::Moebius_map::sphere_inversion({.2, .1, -.3});
  (void)CGP::moebius_transform(mesh, map, parameters());
  EXPECT_EQ(points, map.transform(view.positions()));
  EXPECT_EQ(greatest_difference(spins, map.spins(view.positions())), 0);
}

TEST_F(Moebius_transform_of_archetypes, inverts_around_a_point_that_only_the_traits_understand)
{
  const auto center = Geometry_traits_archetype(archetype_unit).construct_point_3_object()(0, 3, 0);
  (void)CGP::invert_in_sphere(mesh, center, 2, parameters());
  const Eigen::Vector3d c(0, 3, 0);
  for (int v = 0; v < view.size_of_vertices(); ++v) {
    const Eigen::Vector3d r = view.position(v) - c;
    EXPECT_LT((points.col(v) - (c - 4 * r / r.squaredNorm())).norm(), 1e-14);
  }
}

}  // namespace cgp_test::moebius_transform_archetypes_tests
