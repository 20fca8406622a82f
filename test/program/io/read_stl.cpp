// Tests examples/conformal/io/stl/read_stl.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/io/stl/read_stl.h"

#include "program/io/io_support.h"
#include "tools/fuzz_readers_seeds.h"

namespace cgp_test::read_stl_tests {

using namespace conformal;
using namespace io_test;

std::string refusal(const std::string& text)
{
  return message_of([&] { parse_stl(text, "a.stl"); });
}

std::string facet(const std::string& a, const std::string& b, const std::string& c)
{
  return "facet normal 0 0 1\nouter loop\nvertex " + a + "\nvertex " + b + "\nvertex " + c +
         "\nendloop\nendfacet\n";
}

TEST(Read_stl, merges_corners_of_equal_coordinates)
{
  const Surface_file file = parse_stl(fuzz::stl_seeds()[0], "a.stl");
  EXPECT_EQ(file.format, File_format::stl);
  ASSERT_EQ(file.points.size(), 4u);
  EXPECT_EQ(file.points[3], (Point{1, 1, 0}));
  EXPECT_EQ(corners(file, 0), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(corners(file, 1), (std::vector<int>{1, 3, 2}));
  EXPECT_EQ(file.comments, (std::vector<std::string>{"solid two"}));
}

TEST(Read_stl, merges_zeros_of_either_sign_and_nothing_that_differs)
{
  const Surface_file file =
      parse_stl("solid\n" + facet("0 0 0", "1 0 0", "0 1 0") +
                    facet("-0 0 -0", "1.0000000000000002 0 0", "0 1 0") + "endsolid\n",
                "a.stl");
  EXPECT_EQ(file.points.size(), 4u);
  EXPECT_EQ(corners(file, 1), (std::vector<int>{0, 3, 2}));
}

TEST(Read_stl, reads_binary_files_with_their_attributes)
{
  const Surface_file file = parse_stl(fuzz::binary_stl(), "a.stl");
  EXPECT_EQ(file.points.size(), 4u);
  EXPECT_EQ(corners(file, 3), (std::vector<int>{2, 1, 3}));  // by first appearance
  EXPECT_EQ(types(file.faces), "attribute:ushort");
  EXPECT_EQ(values(file.faces, "attribute"), (std::vector<double>{5, 5, 5, 5}));
}

TEST(Read_stl, takes_a_binary_file_for_one_whatever_its_header_says)
{
  std::string text = fuzz::binary_stl();
  text.replace(0, 6, "solid ");
  EXPECT_EQ(parse_stl(text, "a.stl").polygons.size(), 4u);
}

TEST(Read_stl, accepts_several_solids_in_letters_of_any_case)
{
  const std::string two = "SOLID a\n" + facet("0 0 0", "1 0 0", "0 1 0") + "EndSolid a\nsolid b\n" +
                          facet("0 0 1", "1 0 1", "0 1 1") + "endsolid\n";
  EXPECT_EQ(parse_stl(two, "a.stl").polygons.size(), 2u);
}

TEST(Read_stl, refuses_bad_text_with_its_line)
{
  EXPECT_EQ(refusal("solid\nendsolid\n"), "a.stl:3: no facets, wanted a surface");
  EXPECT_EQ(refusal("solid\nvertex\n"), "a.stl:2: 'vertex', wanted facet or endsolid");
  EXPECT_EQ(refusal("solid\n" + facet("0 0 0", "1 0 0", "nan 1 0")),
            "a.stl:6: 'nan' is not finite, wanted a coordinate");
  EXPECT_EQ(refusal("solid\n" + facet("0 0 0", "1 0 0", "1 0 0")),
            "a.stl:2: a facet has two equal corners, wanted three different ones; try: --repair");
  EXPECT_EQ(refusal("solid\n" + facet("0 0 0", "1 0 0", "0 1 0\nvertex 1 1 1")),
            "a.stl:7: 'vertex', wanted endloop");
  EXPECT_EQ(refusal("solid\nfacet normal 0 0 x\n"),
            "a.stl:2: 'x' is not a number, wanted a normal");
  EXPECT_EQ(refusal("solid\n" + facet("0 0 0", "1 0 0", "0 1 0")),
            "a.stl:9: the file ends, wanted facet or endsolid");
}

TEST(Read_stl, leaves_out_bytes_after_the_last_facet_unless_their_number_may_be_wrong)
{
  const Surface_file file = parse_stl(fuzz::binary_stl() + "abcde", "a.stl");
  EXPECT_EQ(file.polygons.size(), 4u);
  EXPECT_EQ(file.notes, (std::vector<std::string>{"left out: 5 bytes after the last facet"}));
  EXPECT_EQ(refusal(fuzz::binary_stl() + std::string(50, '\0')),
            "a.stl: announces 4 facets, but 50 bytes follow them, wanted the right number");
}

TEST(Read_stl, refuses_bad_bytes)
{
  const std::string good = fuzz::binary_stl();
  EXPECT_EQ(refusal(good.substr(0, good.size() - 1)),
            "a.stl: is not a whole STL file: 4 facets need 284 bytes, but it has 283");
  EXPECT_EQ(refusal("solid " + good.substr(6, good.size() - 7)),
            "a.stl: is not a whole STL file: 4 facets need 284 bytes, but it has 283");
  EXPECT_EQ(refusal("x"),
            "a.stl: is not an STL file: it has 1 bytes and does not begin with solid");
  EXPECT_EQ(refusal(std::string(84, '\0')), "a.stl: no facets, wanted a surface");
  std::string text = good;
  text.replace(84 + 50 + 12 + 2, 2, "\x80\x7f");
  EXPECT_EQ(refusal(text),
            "a.stl: facet 1 has a coordinate that is not finite, wanted a coordinate");
  text = good;
  text.replace(84 + 50 + 12, 12, text, 84 + 50 + 24, 12);
  EXPECT_EQ(
      refusal(text),
      "a.stl: facet 1: a facet has two equal corners, wanted three different ones; try: --repair");
  text = good;
  text.replace(80, 4, "\xff\xff\xff\xff");
  EXPECT_EQ(refusal(text),
            "a.stl: is not a whole STL file: 4294967295 facets need 214748364834 bytes, but it has "
            "284");
}

}  // namespace cgp_test::read_stl_tests
