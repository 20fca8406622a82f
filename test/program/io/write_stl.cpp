// Tests examples/conformal/io/stl/write_stl.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/io/stl/write_stl.h"

#include "program/io/io_support.h"

#include "conformal/io/off/read_off.h"
#include "conformal/io/stl/read_stl.h"

namespace cgp_test::write_stl_tests {

using namespace io_test;
using namespace conformal;

Surface_file off(const std::string& text)
{
  return parse_off(text, "a.off");
}

TEST(Write_stl, keeps_triangles_and_their_order)
{
  const Surface_file file =
      off("OFF\n4 4 0\n0 0 0\n1 0 0\n0 1.5 0\n0 0 2\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
  std::vector<std::string> notes;
  const std::string bytes = encode_stl(file, notes);
  EXPECT_EQ(bytes.size(), 84u + 50u * 4u);
  EXPECT_TRUE(is_binary_stl(bytes));
  const Surface_file again = parse_stl(bytes, "a.stl");
  EXPECT_EQ(again.points.size(), 4u);
  for (std::size_t c = 0; c < 12; ++c)
    EXPECT_EQ(again.points[static_cast<std::size_t>(again.polygons.corners[c])],
              file.points[static_cast<std::size_t>(file.polygons.corners[c])]);
  EXPECT_EQ(notes.size(), 1u);  // that there are no vertices
}

TEST(Write_stl, cuts_polygons_keeps_attributes_and_notes_the_rest)
{
  Surface_file file =
      off("COFF\n4 1 0\n0 0 0 1 0 0\n1 0 0 1 0 0\n1 1 0 1 0 0\n0 1 0 1 0 0\n4 0 1 2 3\n");
  set_property(file.faces, "attribute", std::vector<double>{513});
  std::vector<std::string> notes;
  const Surface_file again = parse_stl(encode_stl(file, notes), "a.stl");
  EXPECT_EQ(again.polygons.size(), 2u);
  const Property* attribute = find_property(again.faces, "attribute");
  ASSERT_NE(attribute, nullptr);
  EXPECT_EQ(attribute->value(1), 513);
  EXPECT_GT(notes.size(), 3u);  // the colours
}

}  // namespace cgp_test::write_stl_tests
