// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Boundary_condition.h
#include <Conformal_geometry_processing/mesh/Delaunay_view.h>
#include <Conformal_geometry_processing/spin/Boundary_condition.h>

#include <limits>

#include "spin/boundary_tools.h"
#include "support/meshes.h"
#include "support/thin_faces.h"

namespace cgp_test::require_condition_tests {

/// with which a condition on `disk(2)`, whose boundary has 12 vertices, is refused
std::string refusal(const Boundary_condition& condition, const Mesh_view& mesh = disk(2))
{
  return refusal_of([&] { CGP::require_condition(mesh, condition, "f"); });
}

Points constant(int count, double x = 1)
{
  return Eigen::Vector3d(x, 0, 0).replicate(1, count);
}

Points with_column(Points p, int k, const Eigen::Vector3d& v)
{
  p.col(k) = v;
  return p;
}

const double infinity = std::numeric_limits<double>::infinity();

TEST(Require_condition, takes_what_fits)
{
  EXPECT_EQ(refusal(Boundary_condition::free()), "");
  EXPECT_EQ(refusal(Boundary_condition::free(), icosahedron()), "");
  EXPECT_EQ(refusal(Boundary_condition::tangents()), "");
  EXPECT_EQ(refusal(Boundary_condition::tangents(constant(12, 1e-300))), "");
  EXPECT_EQ(refusal(Boundary_condition::directions({0, 100, 1}, constant(12, 1e200))), "");
  EXPECT_EQ(refusal(Boundary_condition::positions(constant(12, 0), constant(12))), "");
}

TEST(Require_condition, refuses_to_prescribe_what_is_not_there)
{
  const std::string message = "the surface is closed; no boundary can be prescribed";
  EXPECT_EQ(refusal(Boundary_condition::binormals(), icosahedron()), message);
  EXPECT_EQ(refusal(Boundary_condition::positions(constant(0), constant(0)), icosahedron()),
            message);
}

TEST(Require_condition, refuses_other_numbers_of_targets)
{
  EXPECT_EQ(refusal(Boundary_condition::tangents(constant(11))),
            "11 directions, one per boundary vertex is needed: 12");
  EXPECT_EQ(refusal(Boundary_condition::positions(constant(13), constant(12))),
            "13 positions, one per boundary vertex is needed: 12");
  EXPECT_EQ(refusal(Boundary_condition::positions(constant(0), constant(12))),
            "0 positions, one per boundary vertex is needed: 12");
  EXPECT_EQ(refusal(Boundary_condition::positions(constant(12), constant(0))),
            "0 normals, one per boundary vertex is needed: 12");
}

TEST(Require_condition, refuses_directions_that_are_none)
{
  Points two = with_column(with_column(constant(12), 4, {0, 0, 0}), 5, {infinity, 0, 0});
  EXPECT_EQ(
      refusal(Boundary_condition::tangents(two)),
      "2 directions zero or not finite, the first is vertex 11; finite vectors that are not zero "
      "are needed");
  const Points one = with_column(constant(12), 11, {0, 0, std::nan("")});
  EXPECT_EQ(
      refusal(Boundary_condition::positions(constant(12), one)),
      "1 normal zero or not finite, the first is vertex 18; finite vectors that are not zero are "
      "needed");
  EXPECT_EQ(refusal(Boundary_condition::positions(one, constant(12))),
            "1 position not finite, the first is vertex 18; finite coordinates are needed");
}

TEST(Require_condition, refuses_to_prescribe_the_normal)
{
  for (const Eigen::Vector3d& d : {Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(1e-4, 1, 1e-4),
                                   Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, infinity, 0)})
    EXPECT_EQ(refusal(Boundary_condition::directions(d)),
              "only tangents, binormals and directions between them and the normal can be "
              "prescribed; that of the normal is not elliptic");
}

TEST(Require_condition, refuses_a_boundary_that_folds_back)
{
  Points p = disk(2).positions();
  p.col(8) = p.col(10);  // the tangent at vertex 9 vanishes
  const Mesh_view folded(p, disk(2).corners());
  const std::string message =
      "1 boundary vertex without tangent or normal, the first is vertex 9; the boundary must not "
      "fold back";
  EXPECT_EQ(refusal(Boundary_condition::tangents(), folded), message);
  EXPECT_EQ(refusal(Boundary_condition::positions(constant(12), constant(12)), folded), message);
  EXPECT_EQ(refusal(Boundary_condition::free(), folded), "");
}

TEST(Require_condition, takes_boundaries_of_thin_faces_by_their_triangulation)
{
  const CGP::Delaunay_view surface(spoilt(disk(2)));
  const auto refusal = [&](const Boundary_condition& condition) {
    return refusal_of([&] { CGP::require_condition(surface, condition, "f"); });
  };
  const int count = static_cast<int>(CGP::boundary_frames(surface).vertices.size());
  EXPECT_EQ(refusal(Boundary_condition::tangents()), "");
  EXPECT_EQ(refusal(Boundary_condition::tangents(constant(count))), "");
  EXPECT_NE(refusal(Boundary_condition::tangents(constant(count + 1))), "");
}

}  // namespace cgp_test::require_condition_tests
