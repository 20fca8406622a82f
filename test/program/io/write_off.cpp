// Tests examples/conformal/io/off/write_off.cpp examples/conformal/io/data/encode_text.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/io/off/write_off.h"

#include "conformal/io/obj/read_obj.h"
#include "conformal/io/off/read_off.h"
#include "conformal/io/ply/read_ply.h"
#include "program/io/io_support.h"
#include "tools/fuzz_readers_seeds.h"

namespace cgp_test::write_off_tests {

using namespace conformal;
using namespace io_test;

std::string encode(const Surface_file& file)
{
  std::vector<std::string> notes;
  return encode_off(file, notes);
}

TEST(Write_off, writes_back_what_it_read)
{
  for (const std::string text :
       {"OFF\n# made by hand\n3 1 0\n0 0 0.1\n1 5e-324 0\n0 1e+300 -0\n3 0 1 2\n",
        "STCNOFF\n3 1 0\n0 0 0 0 0 1 255 0 7 0.25 0.75\n1 0 0 0 0 1 1 2 3 1 0\n"
        "0 1 0 0 0 1 4 5 6 0 1\n3 0 1 2 0.5 nan 1.0 0.25\n",
        "COFF\n3 2 0\n0 0 0 0.5 1.0 0.0 1.0\n1 0 0 0.5 1.0 0.0 1.0\n0 1 0 0.5 1.0 0.0 1e-05\n"
        "3 0 1 2 255 0 0\n3 0 2 1\n"})
    EXPECT_EQ(encode(parse_off(text, "a.off")), text);
}

TEST(Write_off, writes_texture_coordinates_of_any_origin)
{
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.5 0.25\nvt 1 0\nvt 0 1\nvt 3 3\n";
  const Surface_file file = parse_obj(points + "f 1/1 2/2 3/3\n", "a.obj");
  EXPECT_EQ(encode(file), "STOFF\n3 1 0\n0 0 0 0.5 0.25\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n");
}

TEST(Write_off, notes_what_the_format_has_no_place_for)
{
  std::vector<std::string> notes;
  encode_off(parse_ply(fuzz::ply_seeds()[0], "a.ply"), notes);
  EXPECT_EQ(notes,
            (std::vector<std::string>{"the vertex property quality is not written to OFF",
                                      "the face property label is not written to OFF",
                                      "texture coordinates with seams are not written to OFF",
                                      "lines obj_info are not written to OFF"}));
  notes.clear();
  encode_off(parse_ply(fuzz::binary_ply(false), "a.ply"), notes);
  EXPECT_EQ(notes,
            (std::vector<std::string>{"texture coordinates with seams are not written to OFF",
                                      "the element edge is not written to OFF"}));
  notes.clear();
  encode_off(parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\ng a\nf 1//1 2//1 3//1\n", "a.obj"),
             notes);
  EXPECT_EQ(notes, (std::vector<std::string>{"normals of corners are not written to OFF",
                                             "groups and materials are not written to OFF"}));
}

}  // namespace cgp_test::write_off_tests
