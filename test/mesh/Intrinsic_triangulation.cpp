// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Intrinsic_triangulation.h>

#include <gtest/gtest.h>

#include "support/bounded_meshes.h"
#include "support/meshes.h"
#include "support/random.h"
#include "support/scans.h"
#include "support/thin_faces.h"

#include <cmath>

namespace cgp_test::intrinsic_triangulation_tests {

namespace CGP = Conformal_geometry_processing;
using Triangles = CGP::internal::Intrinsic_triangulation;

Triangles triangles_of(const Mesh_view& mesh)
{
  return {mesh, CGP::edge_lengths(mesh)};
}

/// a rhomb of two triangles in the plane, with the longer diagonal 0 -> 1
Mesh_view rhomb()
{
  return {points({{0, 0, 0}, {4, 0, 0}, {2, 1, 0}, {2, -1, 0}}), {{0, 1, 2}, {1, 0, 3}}};
}

double total_area(const Triangles& triangles)
{
  double sum = 0;
  for (int f = 0; f < triangles.size_of_faces(); ++f) sum += triangles.area(f);
  return sum;
}

/// twins are mutual, and have the same ends and lengths; triangles are none but real ones
void expect_triangulation(const Triangles& t)
{
  for (int h = 0; h < t.size_of_halfedges(); ++h) {
    const int next = Mesh_view::next_in_face(h), previous = Mesh_view::previous_in_face(h);
    EXPECT_LE(t.length(h), (t.length(next) + t.length(previous)) * (1 + 1e-14));
    if (t.twin(h) < 0) continue;
    EXPECT_EQ(t.twin(t.twin(h)), h);
    EXPECT_EQ(t.from(t.twin(h)), t.to(h));
    EXPECT_EQ(t.to(t.twin(h)), t.from(h));
    EXPECT_EQ(t.length(t.twin(h)), t.length(h));
  }
}

/// the least sum of the two cotangents at an edge, both relative to their size
double least_weight(const Triangles& t)
{
  double least = 1;
  for (int h = 0; h < t.size_of_halfedges(); ++h)
    if (t.twin(h) >= 0) {
      const double a = t.cotangent(h), b = t.cotangent(t.twin(h));
      least = std::min(least, (a + b) / (1 + std::abs(a) + std::abs(b)));
    }
  return least;
}

TEST(Intrinsic_triangulation, has_the_angles_and_areas_of_the_faces)
{
  const Mesh_view mesh = bumpy_sphere(1);
  const Triangles t = triangles_of(mesh);
  expect_triangulation(t);
  for (int h = 0; h < mesh.size_of_halfedges(); ++h) {
    const Eigen::Vector3d a = mesh.vector(Mesh_view::next_in_face(h)),
                          b = -mesh.vector(Mesh_view::previous_in_face(h));
    EXPECT_NEAR(t.angle(h), std::acos(a.dot(b) / (a.norm() * b.norm())), 1e-13);
    EXPECT_NEAR(t.cotangent(h), a.dot(b) / a.cross(b).norm(), 1e-13);
    EXPECT_NEAR(t.area(h / 3), mesh.double_area_vector(h / 3).norm() / 2, 1e-14);
    EXPECT_NEAR(t.apex_in_plane(h).norm(), b.norm(), 1e-14);
    EXPECT_EQ(t.from(h), mesh.from(h));
    EXPECT_EQ(t.to(h), mesh.to(h));
  }
}

TEST(Intrinsic_triangulation, flips_an_edge_to_the_other_diagonal)
{
  Triangles t = triangles_of(rhomb());
  EXPECT_EQ(t.length(2), 4);
  EXPECT_NEAR(t.length_of_flipped(2), 2, 1e-14);
  t.flip(2);  // of the face (0, 1, 2), opposite 2
  expect_triangulation(t);
  EXPECT_NEAR(t.length(1), 2, 1e-14);
  EXPECT_EQ(t.from(1), 3);
  EXPECT_EQ(t.to(1), 2);
  EXPECT_NEAR(total_area(t), 4, 1e-14);
  EXPECT_EQ(t.twin(0), -1);
  EXPECT_EQ(t.twin(2), -1);
}

TEST(Intrinsic_triangulation, of_the_plane_has_distances_for_lengths_whatever_is_flipped)
{
  const Mesh_view mesh = disk(6);
  Triangles t = triangles_of(mesh);
  Random random(1);
  int flips = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const int h = random.below(t.size_of_halfedges()), u = t.twin(h);
    if (u < 0) continue;
    // convex: at both ends of the edge
    const auto angle_at_ends = [&](int g, int of_twin) {
      return t.angle(Mesh_view::next_in_face(g)) + t.angle(Mesh_view::previous_in_face(of_twin));
    };
    if (angle_at_ends(h, u) > pi - .1 || angle_at_ends(u, h) > pi - .1) continue;
    t.flip(h);
    ++flips;
  }
  EXPECT_GT(flips, 200);
  expect_triangulation(t);
  EXPECT_NEAR(total_area(t), area(mesh), 1e-10);
  for (int h = 0; h < t.size_of_halfedges(); ++h)
    EXPECT_NEAR(t.length(h), (mesh.position(t.to(h)) - mesh.position(t.from(h))).norm(), 1e-9);
}

TEST(Intrinsic_triangulation, flips_triangles_that_are_glued_to_each_other_all_around)
{
  // Both sides of one triangle: an edge flipped ends twice in the same point.
  const Mesh_view mesh(points({{0, 0, 0}, {3, 0, 0}, {1, 2, 0}}), {{0, 1, 2}, {0, 2, 1}});
  Triangles t = triangles_of(mesh);
  const double before = total_area(t);
  t.flip(0);
  expect_triangulation(t);
  EXPECT_EQ(t.from(1), 0);
  EXPECT_EQ(t.to(1), 0);
  EXPECT_NEAR(t.length(1), 2 * std::sqrt(4.5), 1e-14);  // twice the height on the edge
  EXPECT_NEAR(total_area(t), before, 1e-14);
}

TEST(Flip_to_delaunay, leaves_what_is_delaunay)
{
  for (const Mesh_view& mesh : {icosphere(2), bumpy_sphere(2), torus(2, 1, 16, 8)}) {
    Triangles t = triangles_of(mesh);
    EXPECT_EQ(CGP::flip_to_delaunay(t), 0);
  }
}

TEST(Flip_to_delaunay, makes_every_cotan_weight_nonnegative)
{
  const Mesh_view stretched = mapped(bumpy_sphere(2), [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p.x(), 8 * p.y(), p.z());
  });
  for (const Mesh_view& mesh : {stretched, scan(400), spoilt(icosphere(2)), spoilt(stretched)}) {
    Triangles t(mesh, CGP::mollified_lengths(mesh, 1e-6).lengths);
    EXPECT_LT(least_weight(t), -.1);
    const double before = total_area(t);
    EXPECT_GT(CGP::flip_to_delaunay(t), 0);
    EXPECT_GT(least_weight(t), -1e-9);
    EXPECT_NEAR(total_area(t), before, 1e-7 * before);
    expect_triangulation(t);
  }
}

TEST(Flip_to_delaunay, finds_circles_that_are_empty_in_the_plane)
{
  const Mesh_view round = disk(5);
  const Mesh_view mesh = mapped(round, [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(6 * p.x(), p.y(), 0);  // still convex
  });
  Triangles t = triangles_of(mesh);
  CGP::flip_to_delaunay(t);
  for (int f = 0; f < t.size_of_faces(); ++f) {
    const Eigen::Vector2d a = mesh.position(t.apex(3 * f)).head<2>(),
                          b = mesh.position(t.apex(3 * f + 1)).head<2>() - a,
                          c = mesh.position(t.apex(3 * f + 2)).head<2>() - a;
    const double d = 2 * (b.x() * c.y() - b.y() * c.x());
    const Eigen::Vector2d center =
        Eigen::Vector2d(c.y() * b.squaredNorm() - b.y() * c.squaredNorm(),
                        b.x() * c.squaredNorm() - c.x() * b.squaredNorm()) /
        d;
    for (int v = 0; v < mesh.size_of_vertices(); ++v)
      EXPECT_GT((mesh.position(v).head<2>() - a - center).norm(), center.norm() * (1 - 1e-9));
  }
}

TEST(Mollified_lengths, are_the_lengths_where_no_triangle_is_degenerate)
{
  const Mesh_view mesh = bumpy_sphere(2);
  EXPECT_EQ(CGP::mollified_lengths(mesh, 1e-6).lengths, CGP::edge_lengths(mesh));
  EXPECT_EQ(CGP::mollified_lengths(mesh, 1e-6).thin_faces, 0);
}

TEST(Mollified_lengths, leave_every_triangle_the_slack_asked_for_and_no_more)
{
  const Mesh_view mesh = spoilt(icosphere(2));
  for (const double share : {1e-3, 1e-6}) {
    const Eigen::VectorXd before = CGP::edge_lengths(mesh),
                          after = CGP::mollified_lengths(mesh, share).lengths;
    const double wanted = share * before.mean();
    double least = 1;
    for (int f = 0; f < mesh.size_of_faces(); ++f) {
      double sum = 0, longest = 0;
      for (int c = 0; c < 3; ++c) {
        sum += after[mesh.edge(3 * f + c)];
        longest = std::max(longest, after[mesh.edge(3 * f + c)]);
      }
      least = std::min(least, sum - 2 * longest);
    }
    EXPECT_NEAR(least, wanted, 1e-8 * wanted + 1e-15);
    EXPECT_LE((after - before).maxCoeff(), wanted * (1 + 1e-8));
    EXPECT_NEAR((after - before).maxCoeff(), (after - before).minCoeff(), 1e-15);
  }
}

TEST(Mollified_lengths, grow_with_the_mesh)
{
  const Mesh_view mesh = spoilt(icosphere(1));
  const Eigen::VectorXd one = CGP::mollified_lengths(mesh, 1e-6).lengths;
  for (const double scale : {1e-200, 1e200})
    EXPECT_LT((CGP::mollified_lengths(scaled(mesh, scale), 1e-6).lengths / scale - one).norm(),
              1e-13);
}

}  // namespace cgp_test::intrinsic_triangulation_tests
