// Tests examples/conformal/io/read_plane_curves.cpp examples/conformal/io/write_plane_curves.cpp
// Tests examples/conformal/io/read_curve_rows.cpp examples/conformal/io/read_svg.cpp
// Tests examples/conformal/io/Svg_scanner.cpp examples/conformal/io/svg_path.cpp
// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/io/io_errors.h"
#include "conformal/io/read_curve_rows.h"
#include "conformal/io/read_plane_curves.h"
#include "conformal/io/read_svg.h"
#include "conformal/io/svg_path.h"
#include "conformal/io/write_plane_curves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace {

using namespace conformal;

Eigen::Matrix2Xd points(std::initializer_list<Eigen::Vector2d> list)
{
  return columns(std::vector<Eigen::Vector2d>(list));
}

std::vector<Plane_curve> svg(const std::string& text, int samples = 4)
{
  Curve_reading reading;
  reading.samples = samples;
  std::vector<std::string> notes;
  return parse_svg(text, "a.svg", reading, notes);
}

/// the curves of a path, y down as in the text
std::vector<Plane_curve> path(const std::string& d, int samples = 4)
{
  return parse_svg_path(d, samples,
                        [](const std::string& message) { throw std::runtime_error(message); });
}

template <class Action>
testing::AssertionResult refuses(Action action, const std::string& words)
{
  try {
    action();
  } catch (const std::runtime_error& error) {
    if (std::string(error.what()).find(words) != std::string::npos)
      return testing::AssertionSuccess();
    return testing::AssertionFailure() << error.what();
  }
  return testing::AssertionFailure() << "accepted";
}

TEST(Svg_path, lines_absolute_and_relative)
{
  const auto expected = points({{1, 2}, {4, 2}, {4, 6}, {0, 6}});
  for (const char* d : {"M1 2L4 2L4 6L0 6", "M 1,2 4,2 4,6 0,6", "m1,2 3,0 0,4-4,0", "M1 2H4V6H0",
                        "m1 2h3v4h-4", " M1 2 l3 0\n0 4 -4 0 "}) {
    const auto parts = path(d);
    ASSERT_EQ(parts.size(), 1u) << d;
    EXPECT_EQ(parts[0].points, expected) << d;
    EXPECT_FALSE(parts[0].is_closed) << d;
  }
}

TEST(Svg_path, numbers_need_no_separators)
{
  EXPECT_EQ(path("M.5.25-1e1-2.5+3,4")[0].points, points({{.5, .25}, {-10, -2.5}, {3, 4}}));
}

TEST(Svg_path, z_closes_and_the_next_part_begins_where_this_one_did)
{
  const auto parts = path("M1 1L2 1L2 2ZL5 5m1 1l0 1");
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_TRUE(parts[0].is_closed);
  EXPECT_EQ(parts[1].points, points({{1, 1}, {5, 5}}));
  EXPECT_EQ(parts[2].points, points({{6, 6}, {6, 7}}));
  const auto relative = path("m1 1l1 0 0 1zm3 3l1 1");
  EXPECT_EQ(relative[1].points, points({{4, 4}, {5, 5}}));
}

TEST(Svg_path, a_part_that_comes_back_is_closed)
{
  EXPECT_TRUE(path("M1 1L2 1L2 2L1 1")[0].is_closed);
}

TEST(Svg_path, cubic_segments_are_sampled_on_the_curve)
{
  const auto part = path("M0 0C0 3 3 3 3 0", 3)[0].points;
  ASSERT_EQ(part.cols(), 4);
  for (int i = 0; i < 4; ++i) {
    const double t = i / 3.;
    EXPECT_NEAR(part(0, i), 3 * (3 * (1 - t) * t * t + t * t * t), 1e-15);
    EXPECT_NEAR(part(1, i), 9 * t * (1 - t), 1e-15);
  }
}

TEST(Svg_path, smooth_segments_mirror_the_control_point)
{
  EXPECT_EQ(path("M0 0C0 1 1 1 1 0S2-1 2 0")[0].points,
            path("M0 0C0 1 1 1 1 0C1-1 2-1 2 0")[0].points);
  EXPECT_EQ(path("m0 0c0 1 1 1 1 0s1-1 1 0")[0].points,
            path("M0 0C0 1 1 1 1 0C1-1 2-1 2 0")[0].points);
  EXPECT_EQ(path("M0 0L1 0S2-1 2 0")[0].points, path("M0 0L1 0C1 0 2-1 2 0")[0].points);
  EXPECT_EQ(path("M0 0Q.5 1 1 0T2 0")[0].points, path("M0 0Q.5 1 1 0Q1.5-1 2 0")[0].points);
}

TEST(Svg_path, quadratic_segments_are_parabolas)
{
  const auto part = path("M0 0Q1 2 2 0", 4)[0].points;
  for (int i = 0; i < 5; ++i)
    EXPECT_NEAR(part(1, i), 2 * part(0, i) - part(0, i) * part(0, i), 1e-15);
}

TEST(Svg_path, names_what_it_does_not_understand)
{
  EXPECT_TRUE(
      refuses([] { path("M0 0A1 1 0 0 1 2 2"); }, "the path command 'A' is not understood"));
  EXPECT_TRUE(refuses([] { path("L0 0"); }, "does not begin with M"));
  EXPECT_TRUE(refuses([] { path("1 2 3 4"); }, "a number where it should have a command"));
  EXPECT_TRUE(refuses([] { path("M0 0L1"); }, "the numbers end"));
  EXPECT_TRUE(refuses([] { path("M0 0L1 #"); }, "'#' is not a number"));
  EXPECT_TRUE(refuses([] { path("M0 0L1 1e999"); }, "is not a number"));
}

TEST(Read_svg, finds_paths_polygons_and_polylines_with_y_up)
{
  const auto curves =
      svg("<?xml version='1.0'?><!DOCTYPE svg [<!ENTITY a \"b\">]>\n<!-- <path d='M9 9L8 8'/> -->\n"
          "<svg:svg xmlns:svg=\"x\"><g id='a>b'><polygon points='0,0 1,0 1,1'/>\n"
          "<polyline points=\"0 0 1 2 3 4\" /></g><style><![CDATA[<path d='M0 0L1 1'/>]]></style>"
          "<svg:path style='fill:none' d='M0 0L1 5'></svg:path></svg:svg>");
  ASSERT_EQ(curves.size(), 3u);
  EXPECT_TRUE(curves[0].is_closed);
  EXPECT_EQ(curves[0].points, points({{0, 0}, {1, 0}, {1, -1}}));
  EXPECT_FALSE(curves[1].is_closed);
  EXPECT_EQ(curves[1].name, "curve 1 (polyline in line 4)");
  EXPECT_EQ(curves[2].points, points({{0, 0}, {1, -5}}));
}

TEST(Read_svg, leaves_out_definitions_and_notes_other_shapes)
{
  std::vector<std::string> notes;
  const auto curves = parse_svg(
      "<svg><defs><clipPath><path d='M0 0L1 1'/></clipPath></defs><mask/><rect/><circle r='1'/>"
      "<rect/><path d='M0 0L1 1'/></svg>",
      "a.svg", {}, notes);
  EXPECT_EQ(curves.size(), 1u);
  ASSERT_EQ(notes.size(), 2u);
  EXPECT_EQ(notes[1], "left out: 2 of the element rect, which is no path, polygon or polyline");
}

TEST(Read_svg, names_the_line_of_what_is_wrong)
{
  EXPECT_TRUE(refuses([] { svg("<svg>\n<g transform='scale(2)'/></svg>"); },
                      "a.svg:2: the attribute transform is not understood"));
  EXPECT_TRUE(refuses([] { svg("<html></html>"); }, "no svg element"));
  EXPECT_TRUE(refuses([] { svg("<svg>\n\n<path d='M0 0L1 1"); }, "a.svg:3: an attribute whose"));
  EXPECT_TRUE(refuses([] { svg("<svg><path d></svg>"); }, "an attribute without ="));
  EXPECT_TRUE(refuses([] { svg("<svg><path d=3/></svg>"); }, "not in quotes"));
  EXPECT_TRUE(refuses([] { svg("<svg><path"); }, "the file ends inside a tag"));
  EXPECT_TRUE(refuses([] { svg("<svg>< path/></svg>"); }, "a name is missing"));
  EXPECT_TRUE(refuses([] { svg("<svg><!-- "); }, "a comment without an end"));
  EXPECT_TRUE(refuses([] { svg("<svg><![CDATA[ "); }, "character data without an end"));
  EXPECT_TRUE(refuses([] { svg("<?xml "); }, "a declaration without an end"));
}

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
  Curve_files()
  {
    std::string name = (std::filesystem::temp_directory_path() / "conformal-test-XXXXXX").string();
    m_folder = ::mkdtemp(name.data());
  }
  ~Curve_files() override { std::filesystem::remove_all(m_folder); }

  std::string path_of(const std::string& name) const { return (m_folder / name).string(); }

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

  std::filesystem::path m_folder;
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

TEST_F(Curve_files, that_cannot_be_read_or_written_are_refused)
{
  EXPECT_TRUE(refuses([&] { read("a.dxf"); }, "has no known extension"));
  EXPECT_TRUE(refuses([&] { read_text("a.svg", "<svg></svg>"); }, "no curves"));
  EXPECT_TRUE(refuses([&] { read_text("a.csv", "# none\n"); }, "no curves"));
  EXPECT_TRUE(refuses([&] { write_plane_curves(path_of("a.dxf"), {}); }, "has no known extension"));
}

}  // namespace
