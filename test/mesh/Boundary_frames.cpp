// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Boundary_frames.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <gtest/gtest.h>

#include "support/bounded_meshes.h"
#include "support/meshes.h"
#include "support/random_delaunay.h"

#include <algorithm>
#include <vector>

namespace cgp_test::boundary_frames_tests {

namespace CGP = Conformal_geometry_processing;
using Curves = std::vector<std::vector<int>>;

const Eigen::Vector3d e_z(0, 0, 1);

/// the greatest distance of the tangents of a disk from those of its circle
double tangent_error(const Mesh_view& disk)
{
  const CGP::internal::Boundary_frames b = CGP::boundary_frames(disk);
  double error = 0;
  for (std::size_t k = 0; k < b.vertices.size(); ++k) {
    const Eigen::Vector3d exact = e_z.cross(disk.position(b.vertices[k]));
    error = std::max(error, (b.tangent(k) - exact).norm());
  }
  return error;
}

TEST(Boundary_frame, is_made_of_any_tangent_and_normal)
{
  CGP::internal::Boundary_frame expected;
  expected << 1, 0, 0, 0, 1, 0, 0, 0, 1;
  EXPECT_EQ(CGP::boundary_frame({2, 0, 0}, {5, 3, 0}), expected);
  EXPECT_EQ(CGP::boundary_frame({1e-200, 0, 0}, {0, 1e200, 0}), expected);
}

TEST(Boundary_frame, holds_zeros_where_there_is_no_direction)
{
  const CGP::internal::Boundary_frame a = CGP::boundary_frame({0, 0, 0}, {0, 0, 2});
  EXPECT_EQ(a.col(0), Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(a.col(2), Eigen::Vector3d(0, 0, 0));
  const CGP::internal::Boundary_frame b = CGP::boundary_frame({0, 2, 0}, {0, 3, 0});
  EXPECT_EQ(b.col(1), Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(b.col(2), Eigen::Vector3d(0, 0, 0));
}

TEST(Boundary_frames, of_a_disk_run_around_it_with_the_binormal_outward)
{
  const Mesh_view mesh = disk(5);
  const CGP::internal::Boundary_frames b = CGP::boundary_frames(mesh);
  ASSERT_EQ(b.loops.size(), 1u);
  EXPECT_EQ(b.vertices, b.loops[0]);
  ASSERT_EQ(b.frames.size(), 30u);
  for (std::size_t k = 0; k < b.vertices.size(); ++k) {
    const Eigen::Vector3d p = mesh.position(b.vertices[k]);
    EXPECT_LT((b.tangent(k) - e_z.cross(p)).norm(), 1e-14);
    EXPECT_LT((b.normal(k) - e_z).norm(), 1e-14);
    EXPECT_LT((b.binormal(k) - p).norm(), 1e-14);
  }
}

TEST(Boundary_frames, of_an_annulus_point_out_of_it_at_both_circles)
{
  const Mesh_view mesh = annulus(1, 2, 40, 4);
  const CGP::internal::Boundary_frames b = CGP::boundary_frames(mesh);
  ASSERT_EQ(b.loops.size(), 2u);
  ASSERT_EQ(b.vertices.size(), 80u);
  for (std::size_t k = 0; k < 80; ++k) {
    const Eigen::Vector3d p = mesh.position(b.vertices[k]);
    const double sign = p.norm() > 1.5 ? 1 : -1;
    EXPECT_LT((b.binormal(k) - sign * p.normalized()).norm(), 1e-14);
    EXPECT_LT((b.tangent(k) - sign * e_z.cross(p.normalized())).norm(), 1e-14);
  }
}

TEST(Boundary_frames, are_right_handed_and_orthonormal_on_any_surface)
{
  const Mesh_view mesh = perturbed(cap_from_disk(jittered_disk(6, .3), 2), .04);
  for (const CGP::internal::Boundary_frame& frame : CGP::boundary_frames(mesh).frames) {
    EXPECT_LT((frame.transpose() * frame - Eigen::Matrix3d::Identity()).norm(), 1e-14);
    EXPECT_LT((frame.col(0).cross(frame.col(1)) - frame.col(2)).norm(), 1e-14);
  }
}

TEST(Boundary_frames, have_the_tangents_of_circles_however_uneven_the_edges)
{
  for (const double h : {.5, .1}) EXPECT_LT(tangent_error(random_domain(h, 5)), 1e-13);
  EXPECT_LT(tangent_error(moved_disk(8)), 1e-13);
}

TEST(Boundary_frames, are_second_order_on_curves_whose_edges_jump_in_length)
{
  std::vector<double> h{.2, .1, .05, .025}, errors;
  for (const double length : h) {
    const Mesh_view ellipse = mapped(random_domain(length, 5), [](const Eigen::Vector3d& p) {
      return Eigen::Vector3d(2 * p.x(), p.y(), 0);
    });
    const CGP::internal::Boundary_frames b = CGP::boundary_frames(ellipse);
    double sum = 0;
    for (std::size_t k = 0; k < b.vertices.size(); ++k) {
      const Eigen::Vector3d p = ellipse.position(b.vertices[k]), T(-2 * p.y(), p.x() / 2, 0);
      sum += (b.tangent(k) - T.normalized()).norm() / static_cast<double>(b.vertices.size());
    }
    errors.push_back(sum);
  }
  EXPECT_NEAR(slope(h, errors), 2, .15);
}

TEST(Circle_tangent, is_that_of_the_circle_line_or_what_is_left_of_it)
{
  Random random(4);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Matrix3d R = random.rotation();
    const auto point = [&R](double t) -> Eigen::Vector3d {
      return R * Eigen::Vector3d(std::cos(t), std::sin(t), .3);
    };
    const double a = 1 + random.number(), b = 1 + random.number();
    const Eigen::Vector3d T = CGP::circle_tangent(point(-a), point(0), point(b)).normalized();
    EXPECT_LT((T - R.col(1)).norm(), 1e-8);
  }
  const Eigen::Vector3d o(0, 0, 0), x(1, 0, 0);
  EXPECT_EQ(CGP::circle_tangent(o, x, 4 * x).normalized(), x);
  EXPECT_EQ(CGP::circle_tangent(o, o, x), x);
  EXPECT_EQ(CGP::circle_tangent(o, x, x), x);
  EXPECT_EQ(CGP::circle_tangent(o, x, o), o);
}

TEST(Boundary_frames, turn_with_the_surface)
{
  const Mesh_view mesh = perturbed(cap_from_disk(disk(4), 1), .04);
  const Eigen::Matrix3d R = Random(3).rotation();
  const auto turned =
      mapped(mesh, [&](const Eigen::Vector3d& p) { return Eigen::Vector3d(R * p); });
  const auto a = CGP::boundary_frames(mesh).frames, b = CGP::boundary_frames(turned).frames;
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_LT((b[k] - R * a[k]).norm(), 1e-13);
}

TEST(Boundary_frames, of_a_closed_surface_are_none)
{
  EXPECT_TRUE(CGP::boundary_frames(icosahedron()).vertices.empty());
}

Curves curves(const Mesh_view& mesh, const std::vector<int>& marked)
{
  std::vector<char> is_marked(static_cast<std::size_t>(mesh.size_of_vertices()), 0);
  for (const int v : marked) is_marked[static_cast<std::size_t>(v)] = 1;
  return CGP::internal::closed_curves(mesh, is_marked, "f");
}

TEST(Closed_curves, go_along_edges_from_the_smallest_vertex)
{
  const Mesh_view mesh = disk(4);  // rings of 6, 12, 18 and 24 vertices around vertex 0
  EXPECT_TRUE(curves(mesh, {}).empty());
  EXPECT_EQ(curves(mesh, {0, 1, 2}), (Curves{{0, 1, 2}}));
  std::vector<int> both;
  for (int v = 1; v < 7; ++v) both.push_back(v);
  for (int v = 19; v < 37; ++v) both.push_back(v);
  const Curves found = curves(mesh, both);
  ASSERT_EQ(found.size(), 2);
  EXPECT_EQ(found[0].size(), 6);
  EXPECT_EQ(found[1].size(), 18);
  for (const std::vector<int>& curve : found)
    for (std::size_t k = 0; k + 1 < curve.size(); ++k) EXPECT_EQ(curve[k + 1], curve[k] + 1);
}

TEST(Closed_curves, are_refused_where_they_are_open_or_branch)
{
  const auto refusal = [](const std::vector<int>& marked) -> std::string {
    try {
      (void)curves(disk(3), marked);
    } catch (const CGP::Precondition_error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal({4}),
            "f: 1 vertex on no closed curve, the first is vertex 4; two neighbours on it are "
            "needed, and no more");
  EXPECT_NE(refusal({1, 2}).find("2 vertices on no closed curve"), std::string::npos);
  EXPECT_NE(refusal({0, 1, 2, 3}).find("2 vertices on no closed curve, the first is vertex 0"),
            std::string::npos);
}

}  // namespace cgp_test::boundary_frames_tests
