// Tests examples/conformal/input/boundary_curves.cpp examples/conformal/input/Closed_curve.cpp
// Tests examples/conformal/io/file/number_rows.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "program/bounded_support.h"

#include "conformal/input/Closed_curve.h"
#include "conformal/input/boundary_curves.h"
#include "conformal/io/file/io_errors.h"
#include "conformal/io/file/numbers.h"

#include <cmath>

namespace cgp_test::boundary_curves_tests {

using namespace program_test;
using cgp_test::disk;
using cgp_test::pi;
using Curves = Bounded_program;

/// the points a cos(t), b sin(t), from the angle `start`
std::string ellipse(double a, double b, int size, double start = 0)
{
  std::string text;
  for (int i = 0; i < size; ++i) {
    const double t = start + 2 * pi * i / size;
    for (const double x : {a * std::cos(t), b * std::sin(t)}) {
      conformal::append_number(text, x);
      text += ' ';
    }
    text += '\n';
  }
  return text;
}

TEST(Closed_curve, has_the_arc_length_as_its_parameter)
{
  Points square(3, 4);
  square << 0, 3, 3, 0,  //
      0, 0, 1, 1,        //
      0, 0, 0, 0;
  const conformal::Closed_curve curve(square);
  EXPECT_DOUBLE_EQ(curve.length(), 8);
  EXPECT_EQ(curve.shares(), (std::vector<double>{0, 3. / 8, 4. / 8, 7. / 8}));
  EXPECT_LT((curve(0) - Eigen::Vector3d(0, 0, 0)).norm(), 1e-15);
  EXPECT_LT((curve(2.5 / 8) - Eigen::Vector3d(2.5, 0, 0)).norm(), 1e-15);
  EXPECT_LT((curve(7.5 / 8) - Eigen::Vector3d(0, 0.5, 0)).norm(), 1e-15);
}

TEST_F(Curves, circle_gives_a_disk_that_begins_where_it_does)
{
  const auto mesh = disk(10);
  write("a.off", off(mesh));
  write("circle.txt", ellipse(5, 5, 600, pi / 2));
  const Program_run r = run("boundary a.off --curve circle.txt -o b.ply");
  ASSERT_EQ(r.code, 0) << r.err;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(pi / 2, Eigen::Vector3d::UnitZ()).matrix();
  EXPECT_LT((points("b.ply") - turn * mesh.positions()).cwiseAbs().maxCoeff(), 1e-3);
}

TEST_F(Curves, as_many_points_as_vertices_belong_together)
{
  // The tangents of an ellipse at equal angles belong to artanh(sqrt(m) z) with m = (a - b)/(a +
  // b).
  write("a.off", off(disk(16)));
  write("ellipse.txt", ellipse(2, 1, 96));
  ASSERT_EQ(run("boundary a.off --curve ellipse.txt -o b.ply --json b.json").code, 0);
  const Points b = points("b.ply");
  const Eigen::Vector3d size = b.rowwise().maxCoeff() - b.rowwise().minCoeff();
  const double m = std::sqrt(1. / 3);
  EXPECT_NEAR(size.x() / size.y(), std::atanh(m) / std::atan(m), 2e-3);
  EXPECT_LT(json("b.json")["result"]["boundary"]["direction_error"]["mean"], 0.5);
}

TEST_F(Curves, each_loop_has_its_own)
{
  const auto mesh = cgp_test::annulus(0.5, 1, 60, 8);
  write("a.off", off(mesh));
  // The surface is to the left of a loop: the inner circle runs clockwise.
  write("circles.txt", "# outer\n" + ellipse(2, 2, 300) + "\n# inner\n" + ellipse(1, -1, 200));
  ASSERT_EQ(run("boundary a.off --curve circles.txt -o b.ply").code, 0);
  EXPECT_LT((centred(points("b.ply")) - centred(mesh.positions())).cwiseAbs().maxCoeff(), 5e-3);
  write("one.txt", ellipse(1, 1, 50));
  EXPECT_TRUE(fails(run("boundary a.off --curve one.txt -o c.ply"), 4,
                    "has 1 curve, wanted one for each of 2 boundary loops"));
}

TEST_F(Curves, are_read_with_comments_and_a_last_point_that_is_the_first)
{
  write("c.txt", "0 0 0 # start\n1, 0, 0\n# on\n1;1;0\n0 0 0\n\n\n0 0\n2 0\n2 2\n0 2\n");
  const auto curves = conformal::read_curves(path("c.txt"));
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(curves[0].points().cols(), 3);
  EXPECT_EQ(curves[1].points().cols(), 4);
  EXPECT_DOUBLE_EQ(curves[1].length(), 8);
}

TEST_F(Curves, that_are_none_are_refused_with_their_line)
{
  for (const auto& [text, words] :
       {std::pair("0 0\n1 zero\n", "c.txt:2"), std::pair("0 0\n1\n1 1\n", "c.txt:2: 1 number"),
        std::pair("0 0\n1 0\n\n0 0\n", "a curve of 2 points"),
        std::pair("0 0\n1 0 0\n0 inf\n", "c.txt:3")}) {
    write("c.txt", text);
    try {
      (void)conformal::read_curves(path("c.txt"));
      ADD_FAILURE() << text;
    } catch (const conformal::Read_error& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  }
}

TEST_F(Curves, without_a_direction_name_the_vertex)
{
  write("a.off", off(disk(1)));
  // The points before and after the third are the same.
  write("c.txt", "0 0\n1 0\n2 0\n1 0\n2 2\n0 2\n");
  EXPECT_TRUE(fails(run("boundary a.off --curve c.txt -o b.ply"), 4,
                    "curve 0 has no direction at vertex 3"));
}

}  // namespace cgp_test::boundary_curves_tests
