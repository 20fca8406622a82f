// Tests examples/conformal/io/read_plane_curves.cpp examples/conformal/io/write_plane_curves.cpp
// Tests examples/conformal/io/csv/read_curve_rows.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/io/csv/read_curve_rows.h"
#include "conformal/io/read_plane_curves.h"
#include "conformal/io/write_plane_curves.h"

#include <gtest/gtest.h>

#include "program/io/curve_support.h"
#include "program/io/io_support.h"

#include <cmath>
#include <fstream>

namespace cgp_test::plane_curves_tests {

using namespace conformal;
using namespace program_test;

TEST(Curve_rows, are_points_with_empty_lines_between_curves)
{
  for (const char* text : {"0,1\n2,3\n\n4,5\n6,7\n", "x,y\n0;1\n2 3\n\n\n4 5\r\n# more\n6 7",
                           "\"x\" \"y\"\n0 1\n2 3\n\n4 5\n6 7"}) {
    const auto curves = parse_curve_rows(text, "a.csv");
    ASSERT_EQ(curves.size(), 2u) << text;
    EXPECT_EQ(curves[0].points, points({{0, 1}, {2, 3}})) << text;
    EXPECT_EQ(curves[1].points, points({{4, 5}, {6, 7}})) << text;
    EXPECT_EQ(curves[1].name, "curve 1");
  }
}

TEST(Curve_rows, that_are_no_points_are_refused)
{
  EXPECT_TRUE(refuses([] { parse_curve_rows("0,1\n2,3,4\n", "a.csv"); }, "a.csv:2: 3 numbers"));
  EXPECT_TRUE(refuses([] { parse_curve_rows("0,1\nx,y\n", "a.csv"); }, "a.csv:2: 'x' is not a"));
  EXPECT_TRUE(refuses([] { parse_curve_rows("0,nan\n", "a.csv"); }, "not finite"));
}

TEST(Obj_lines, are_curves_closed_or_open)
{
  const auto curves = parse_obj_lines(
      "# lines\nv 0 0 0\nv 1 0 0\nv 1 1 0 1\nvt 0 0\nl 1 2 3 1\nl -1/1 -2/1\n", "a.obj");
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_TRUE(curves[0].is_closed);
  EXPECT_EQ(curves[0].points.cols(), 4);
  EXPECT_FALSE(curves[1].is_closed);
  EXPECT_EQ(curves[1].points, points({{1, 1}, {1, 0}}));
  EXPECT_EQ(parse_obj_lines("v 0 0 0\nv 1 0 0\n", "a.obj").at(0).points, points({{0, 0}, {1, 0}}));
}

TEST(Obj_lines, that_are_wrong_are_refused)
{
  EXPECT_TRUE(refuses([] { parse_obj_lines("v 0 0 1\n", "a.obj"); }, "a.obj:1: a vertex with z"));
  EXPECT_TRUE(
      refuses([] { parse_obj_lines("v 0 0 0\nl 1 2\n", "a.obj"); }, "'2' is not the index"));
  EXPECT_TRUE(refuses([] { parse_obj_lines("v 0 0 0\nl 0\n", "a.obj"); }, "'0' is not the index"));
  EXPECT_TRUE(refuses([] { parse_obj_lines("v 0 0 0\nl\n", "a.obj"); }, "a line without vertices"));
}

class Curve_files : public testing::Test {
 protected:
  std::string path_of(const std::string& name) const { return m_folder / name; }

  std::vector<Plane_curve> read(const std::string& name, const Curve_reading& reading = {})
  {
    m_notes.clear();
    return read_plane_curves(path_of(name), reading, m_notes);
  }

  std::vector<Plane_curve> read_text(const std::string& name, const std::string& text)
  {
    std::ofstream(path_of(name)) << text;
    return read(name);
  }

  io_test::Folder m_folder;
  std::vector<std::string> m_notes;
};

TEST_F(Curve_files, read_back_as_they_were_written)
{
  const std::vector<Plane_curve> curves = {
      {"", points({{0, 0}, {1, std::sqrt(2.)}, {-1. / 3, 2e-9}}), true},
      {"", points({{5, 5}, {1e6, 7}, {2e6, -3e5}, {9e6, 9}}), false}};
  for (const char* name : {"a.svg", "a.CSV", "a.obj", "a.txt", "a.xy"}) {
    write_plane_curves(path_of(name), curves);
    const auto again = read(name);
    ASSERT_EQ(again.size(), 2u) << name;
    for (std::size_t c = 0; c < 2; ++c) {
      EXPECT_EQ(again[c].points, curves[c].points) << name;
      EXPECT_EQ(again[c].is_closed, curves[c].is_closed) << name;
    }
    EXPECT_TRUE(m_notes.empty());
  }
}

TEST_F(Curve_files, ends_that_touch_are_closed)
{
  EXPECT_TRUE(read_text("a.csv", "0,0\n1,0\n1,1\n0,0\n")[0].is_closed);
  EXPECT_EQ(read("a.csv")[0].points.cols(), 3);
  EXPECT_TRUE(read_text("a.csv", "0,0\n1,0\n1,1\n0,1\n")[0].is_closed);
  EXPECT_FALSE(read_text("a.csv", "0,0\n1,0\n1,1\n1,2\n")[0].is_closed);
  EXPECT_FALSE(read_text("a.svg", "<svg><polyline points='0,0 1,0 1,1 0,1'/></svg>")[0].is_closed);
  Curve_reading reading;
  reading.are_closed = true;
  EXPECT_TRUE(read("a.svg", reading)[0].is_closed);
}

TEST_F(Curve_files, rounding_errors_where_a_path_closes_are_no_edge)
{
  const auto curve = read_text("a.svg", "<svg><path d='M0 0l1 0 0 1-1.0000000001-1z'/></svg>");
  EXPECT_EQ(curve[0].points.cols(), 3);
}

TEST_F(Curve_files, points_that_repeat_but_for_rounding_are_left_out)
{
  const auto curve = read_text("a.svg", "<svg><path d='M.1 .3C.1 .3 .1 .3 .1 .3L1 0 1 1z'/></svg>");
  EXPECT_EQ(curve[0].points.cols(), 3);
  ASSERT_EQ(m_notes.size(), 1u);
  EXPECT_NE(m_notes[0].find("16 points that repeat the one before"), std::string::npos);
}

TEST_F(Curve_files, that_cannot_be_read_or_written_are_refused)
{
  EXPECT_TRUE(refuses([&] { read("a.dxf"); }, "has no known extension"));
  EXPECT_TRUE(refuses([&] { read_text("a.svg", "<svg></svg>"); }, "no curves"));
  EXPECT_TRUE(refuses([&] { read_text("a.csv", "# none\n"); }, "no curves"));
  EXPECT_TRUE(refuses([&] { write_plane_curves(path_of("a.dxf"), {}); }, "has no known extension"));
}

}  // namespace cgp_test::plane_curves_tests
