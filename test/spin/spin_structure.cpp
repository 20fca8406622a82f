// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/spin_structure.h
#include <Conformal_geometry_processing/spin/spin_structure.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>

#include "support/figure_eight_torus.h"
#include "support/handlebodies.h"
#include "support/moebius.h"
#include "support/random.h"
#include "support/skewed_tori.h"
#include "support/spheres.h"

namespace cgp_test::spin_structure_tests {

namespace CGP = Conformal_geometry_processing;

int arf(const Mesh_view& mesh)
{
  return CGP::spin_structure(mesh).arf_invariant();
}

/// the loop around the tube of `torus(R, r, m, n)` through its first n quadrangles: across the
/// diagonal of each, and on into the next
CGP::internal::Face_loop around_the_tube(int n)
{
  CGP::internal::Face_loop loop;
  for (int j = 0; j < n; ++j) loop.insert(loop.end(), {6 * j + 1, 6 * j + 3});
  return loop;
}

/// the loop of the faces around the first corner of face 0
CGP::internal::Face_loop around_a_point(const Mesh_view& mesh)
{
  CGP::internal::Face_loop loop;
  int f = 0, corner = 0;
  do {
    loop.push_back(3 * f + (corner + 1) % 3);  // it ends there
    const int h = mesh.twin(loop.back());      // and this one begins there
    f = Mesh_view::face(h);
    corner = (h + 1) % 3;
  } while (f != 0);
  return loop;
}

TEST(Spin_structure, of_embedded_surfaces_is_even)
{
  EXPECT_EQ(arf(icosphere(1)), 0);
  EXPECT_EQ(arf(torus(2, 1, 24, 12)), 0);
  EXPECT_EQ(arf(twisted_torus(12)), 0);
  EXPECT_EQ(arf(hopf_torus(16)), 0);
  for (const int genus : {1, 2, 3}) EXPECT_EQ(arf(holed_block(genus)), 0) << genus;
}

TEST(Spin_structure, of_a_figure_eight_that_turns_around_the_axis_is_odd)
{
  EXPECT_EQ(arf(turned_torus(48, 24, true, 0)), 0);
  EXPECT_EQ(arf(turned_torus(48, 24, true, 1)), 1);
  EXPECT_EQ(arf(turned_torus(60, 24, true, 2)), 0);
  EXPECT_EQ(arf(turned_torus(72, 24, true, 3)), 1);
  EXPECT_EQ(arf(turned_torus(48, 24, false, 1)), 0);
}

TEST(Spin_structure, tells_circles_and_points_from_figures_eight)
{
  const int n = 16;
  for (const bool is_eight : {false, true}) {
    const Mesh_view mesh = turned_torus(32, n, is_eight, 0);
    EXPECT_EQ(CGP::turns_evenly(mesh, around_the_tube(n)), is_eight);
    EXPECT_FALSE(CGP::turns_evenly(mesh, around_a_point(mesh)));
  }
  const Mesh_view sphere = icosphere(2);
  EXPECT_FALSE(CGP::turns_evenly(sphere, around_a_point(sphere)));
}

TEST(Spin_structure, has_an_invariant_that_does_not_depend_on_the_loops)
{
  const Mesh_view odd = turned_torus(48, 24, true, 1);
  for (const std::uint64_t seed : {1, 2, 3})
    EXPECT_EQ(arf(renumbered(odd, random_permutation(odd.size_of_vertices(), seed))), 1);
  Corners corners = odd.corners();
  std::reverse(corners.begin(), corners.end());
  EXPECT_EQ(arf({odd.positions(), corners}), 1);
}

TEST(Spin_structure, stays_under_motions_and_small_deformations)
{
  for (const int turns : {0, 1}) {
    Mesh_view mesh = turned_torus(48, 24, true, turns);
    const CGP::internal::Spin_structure before = CGP::spin_structure(mesh);
    Random random(5);
    Points p = mesh.positions();
    for (Eigen::Index i = 0; i < p.cols(); ++i) p.col(i) += .02 * random.vector();
    mesh.set_positions(7 * random.rotation() * p);
    EXPECT_EQ(CGP::spin_structure(mesh), before);
  }
}

TEST(Spin_structure, stays_under_Moebius_transformations)
{
  for (const int turns : {0, 1}) {
    const Mesh_view mesh = turned_torus(48, 24, turns != 0, turns);
    const CGP::internal::Spin_structure before = CGP::spin_structure(mesh);
    EXPECT_EQ(before.arf_invariant(), turns);
    // outside, in the hole, and in the tube: the last turns the surface inside out
    for (const Eigen::Vector3d& center :
         {Eigen::Vector3d(1, 2, 7), Eigen::Vector3d(.1, .2, .3), Eigen::Vector3d(3 + .5, 0, 0)})
      EXPECT_EQ(CGP::spin_structure(inverted(mesh, center)), before) << turns;
  }
}

TEST(Spin_structure, differs_between_surfaces_of_one_connectivity)
{
  const Mesh_view circle = turned_torus(48, 24, false, 0), eight = turned_torus(48, 24, true, 0);
  EXPECT_NE(CGP::spin_structure(circle), CGP::spin_structure(eight));
  EXPECT_NO_THROW(CGP::require_same_spin_structure(circle, 2 * circle.positions(), "f"));
  try {
    CGP::require_same_spin_structure(circle, eight.positions(), "f");
    FAIL();
  } catch (const CGP::Precondition_error& e) {
    EXPECT_NE(std::string(e.what()).find("spin structure"), std::string::npos);
  }
}

}  // namespace cgp_test::spin_structure_tests
