// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/overlaps.h>

#include <gtest/gtest.h>

#include "support/bounded_meshes.h"
#include "support/mesh_tools.h"

#include <cmath>
#include <vector>

namespace cgp_test::overlaps_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::internal::overlap_summary;
using CGP::internal::overlaps;

CGP::internal::Overlap_summary of(const Mesh_view& mesh, const Points& positions)
{
  return overlap_summary(overlaps(mesh, positions), mesh, positions);
}

/// Two triangles (0, 0), (1, 0), (0, 1), the second one moved
Mesh_view two_triangles(double x, double y)
{
  const Mesh_view one = single_triangle();
  Points flat = Points::Zero(3, 3);
  flat(0, one.corners(0)[1]) = flat(1, one.corners(0)[2]) = 1;
  const Mesh_view right(flat, one.corners());
  return disjoint_union(right, right, {x, y, 0});
}

// The second begins at (t, t): a triangle with legs 1 - 2 t is common.
TEST(Overlaps, of_two_triangles_have_the_area_that_is_common)
{
  for (const double t : {0., .1, .25, .4, .49}) {
    const Mesh_view mesh = two_triangles(t, t);
    const auto pairs = overlaps(mesh, mesh.positions());
    ASSERT_EQ(pairs.size(), 1u) << t;
    EXPECT_EQ(pairs[0].first, 0);
    EXPECT_EQ(pairs[0].second, 1);
    EXPECT_NEAR(pairs[0].area, std::pow(1 - 2 * t, 2) / 2, 1e-14);
    EXPECT_NEAR(of(mesh, mesh.positions()).share, std::pow(1 - 2 * t, 2) / 2, 1e-14);
  }
  EXPECT_EQ(of(two_triangles(.5, .5), two_triangles(.5, .5).positions()).faces, 0);
  EXPECT_EQ(of(two_triangles(-1, 1), two_triangles(-1, 1).positions()).faces, 0);
}

TEST(Overlaps, are_none_where_faces_are_neighbours)
{
  for (const Mesh_view& mesh :
       {jittered_disk(8, .3), grid(5, 3, 2e8, 1e8), annulus(1, 2, 20, 4), disk(1)})
    EXPECT_EQ(of(mesh, mesh.positions()).faces, 0);
}

/// A strip of a ring, wound by so many steps of a turn of `turn` steps, somewhere in the plane
Points wound(const Mesh_view& strip, int turn, double angle, double size)
{
  return mapped(strip,
                [=](const Eigen::Vector3d& p) {
                  const double a = angle + 2 * pi * p.x() / turn, r = 2 + p.y();
                  return Eigen::Vector3d(size * (r * std::cos(a) + 7), size * r * std::sin(a),
                                         p.z());
                })
      .positions();
}

TEST(Overlaps, of_a_wound_strip_are_its_share_beyond_a_turn)
{
  const int length = 37, turn = 24, width = 3;
  const Mesh_view strip = mapped(grid(length, width, length, 1), [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p.x(), -p.y(), p.x());  // the outer side is on the right
  });
  for (const double size : {1., 1e-100, 1e100})
    for (const double angle : {0., 1., 2.5}) {
      const auto found = of(strip, wound(strip, turn, angle, size));
      const int beyond = 2 * (length - turn) * width;
      EXPECT_EQ(found.faces, 2 * beyond);
      EXPECT_NEAR(found.share, double(length - turn) / length, 1e-12);
    }
}

// They lie on their neighbours, which do not lie on each other where one vertex has moved a little.
TEST(Overlaps, leave_out_flipped_faces)
{
  const Mesh_view mesh = grid(4, 4, 4, 4);
  Points flipped = mesh.positions();
  flipped.row(0) = -flipped.row(0);
  EXPECT_EQ(overlaps(mesh, flipped).size(), 0u);
  const Mesh_view both = disjoint_union(mesh, with_reversed_faces(mesh), {.3, .2, 0});
  EXPECT_EQ(overlaps(both, both.positions()).size(), 0u);
}

}  // namespace cgp_test::overlaps_tests
