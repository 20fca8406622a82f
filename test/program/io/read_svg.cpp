// Tests examples/conformal/io/svg/read_svg.cpp examples/conformal/io/file/Xml_scanner.cpp
// Tests examples/conformal/io/svg/svg_path.cpp examples/conformal/io/svg/svg_transform.cpp
// Tests examples/conformal/io/svg/svg_arc.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/io/svg/read_svg.h"
#include "conformal/io/svg/svg_path.h"

#include <gtest/gtest.h>

#include "program/io/curve_support.h"

#include <cmath>

namespace cgp_test::read_svg_tests {

using namespace conformal;
using namespace program_test;

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

// From (1, 0) to (0, 1) on a unit circle: around (0, 0) or (1, 1), the short or the long way.
TEST(Svg_path, arcs_are_on_the_ellipse_that_the_flags_tell)
{
  const struct {
    const char* d;
    Eigen::Vector2d center, middle;
    int points;
  } cases[] = {{"M1 0A1 1 0 0 1 0 1", {0, 0}, {1, 1}, 5},
               {"M1 0a1 1 0 11-1 1", {1, 1}, {1, 1}, 13},
               {"M1 0A1,1,0,0,0,0,1", {1, 1}, {-1, -1}, 5},
               {"M1 0a1 1 0 10-1 1", {0, 0}, {-1, -1}, 13}};
  for (const auto& c : cases) {
    const auto p = path(c.d)[0].points;
    ASSERT_EQ(p.cols(), c.points) << c.d;
    for (const auto& q : p.colwise()) EXPECT_NEAR((q - c.center).norm(), 1, 1e-14) << c.d;
    const Eigen::Vector2d middle = p.col(c.points / 2) - c.center;
    EXPECT_LT((middle - c.middle / std::sqrt(2.)).norm(), 1e-14) << c.d;
  }
}

TEST(Svg_path, arcs_of_turned_ellipses_and_of_radii_that_do_not_do)
{
  const auto half = path("M-3 0A3 1 0 0 1 3 0", 2)[0].points;  // over (0, -1)
  EXPECT_LT((half.col(2) - Eigen::Vector2d(0, -1)).norm(), 1e-14);
  const auto upright = path("M0 -3A3 1 90 0 1 0 3", 2)[0].points;  // over (1, 0)
  EXPECT_LT((upright.col(2) - Eigen::Vector2d(1, 0)).norm(), 1e-14);
  const auto enlarged = path("M-3 0A.3 .1 0 0 1 3 0", 2)[0].points;
  EXPECT_LT((enlarged - half).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_EQ(path("M0 0A0 1 0 0 1 3 0")[0].points, points({{0, 0}, {3, 0}}));
}

TEST(Svg_path, names_what_it_does_not_understand)
{
  EXPECT_TRUE(refuses([] { path("M0 0B1 1"); }, "the path command 'B' is not understood"));
  EXPECT_TRUE(refuses([] { path("M0 0A1 1 0 2 1 2 2"); }, "an arc wants the flag 0 or 1"));
  EXPECT_TRUE(refuses([] { path("M0 0A1 1 0 0"); }, "an arc wants the flag 0 or 1"));
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
  EXPECT_EQ(notes[1], "left out: 2 of the element rect, which is not a path, polygon or polyline");
}

/// where the points (1, 0) and (0, 1) of SVG go, y down
Eigen::Matrix2Xd transformed(const std::string& transform)
{
  auto all = svg("<svg><g transform='" + transform + "'><path d='M1 0L0 1'/></g></svg>");
  all.at(0).points.row(1) *= -1;
  return all[0].points;
}

TEST(Read_svg, applies_transformations)
{
  EXPECT_EQ(transformed("translate(3,4)"), points({{4, 4}, {3, 5}}));
  EXPECT_EQ(transformed(" translate( 3 ) "), points({{4, 0}, {3, 1}}));
  EXPECT_EQ(transformed("scale(2)"), points({{2, 0}, {0, 2}}));
  EXPECT_EQ(transformed("scale(2, -3)"), points({{2, 0}, {0, -3}}));
  EXPECT_EQ(transformed("matrix(1 2 3 4 5 6)"), points({{6, 8}, {8, 10}}));
  EXPECT_EQ(transformed("translate(1 0) scale(2)"), points({{3, 0}, {1, 2}}));
  EXPECT_TRUE(transformed("rotate(90)").isApprox(points({{0, 1}, {-1, 0}}), 1e-15));
  EXPECT_TRUE(transformed("rotate(90 1 1)").isApprox(points({{2, 1}, {1, 0}}), 1e-15));
  EXPECT_TRUE(transformed("skewX(45)").isApprox(points({{1, 0}, {1, 1}}), 1e-15));
  EXPECT_TRUE(transformed("skewY(45)").isApprox(points({{1, 1}, {0, 1}}), 1e-15));
}

TEST(Read_svg, a_transformation_ends_with_its_element)
{
  const auto curves =
      svg("<svg><g transform='scale(2)'><g transform='scale(3)'/><path transform='scale(5)' "
          "d='M1 0L2 0'/><path d='M1 0L2 0'/></g><path d='M1 0L2 0'/></svg>");
  EXPECT_EQ(curves[0].points(0, 0), 10);
  EXPECT_EQ(curves[1].points(0, 0), 2);
  EXPECT_EQ(curves[2].points(0, 0), 1);
}

TEST(Read_svg, names_the_line_of_what_is_wrong)
{
  EXPECT_TRUE(refuses([] { svg("<svg>\n<g transform='bend(2)'/></svg>"); },
                      "a.svg:2: the transformation 'bend' with 1 numbers is not understood"));
  EXPECT_TRUE(refuses([] { svg("<svg><g transform='scale 2'/></svg>"); }, "'scale 2' is not"));
  EXPECT_TRUE(refuses([] { svg("<svg><g transform='scale(x)'/></svg>"); }, "'x' is not a number"));
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

}  // namespace cgp_test::read_svg_tests
