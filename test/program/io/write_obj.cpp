// Tests examples/conformal/io/obj/write_obj.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/io/obj/write_obj.h"

#include "conformal/io/obj/read_obj.h"
#include "conformal/io/ply/read_ply.h"
#include "program/io/io_support.h"
#include "tools/fuzz_readers_seeds.h"

namespace cgp_test::write_obj_tests {

using namespace conformal;
using namespace io_test;

std::string encode(const Surface_file& file)
{
  std::vector<std::string> notes;
  return encode_obj(file, notes);
}

TEST(Write_obj, writes_back_what_it_read)
{
  for (const std::string text :
       {"# made by hand\nv 0 0 0.1 0.5 nan 1\nv 1 5e-324 0 0 0 0\nv 0 1e+300 -0 1 1 1\n"
        "mtllib my file.mtl\nusemtl red\nf 1 2 3\ng last\n",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 5 0.1\nvn 0 0 1\n"
        "f 1/1/1 2/2/1 3/3/1\ng b\nf 1/5 3/3 4/4\nf 1//1 2 4\n",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0 0.5\nf 1/1 2 3\n",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1 2 3\n"})
    EXPECT_EQ(encode(parse_obj(text, "a.obj")), text);
}

TEST(Write_obj, writes_attributes_of_a_ply_file)
{
  const std::string text = encode(parse_ply(fuzz::binary_ply(false), "a.ply"));
  EXPECT_NE(text.find("v 0 0 0 0 0.19607843137254902 0.39215686274509803\n"), std::string::npos);
  EXPECT_NE(text.find("vt 0.25 0.375\n"), std::string::npos);
  const Surface_file again = parse_obj(text, "b.obj");
  EXPECT_EQ(again.texture.index, (std::vector<int>{0, 1, 2, 0, 3, 4}));
}

TEST(Write_obj, writes_normals_of_vertices)
{
  Surface_file file = parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 3 2\n", "a.obj");
  for (const char* name : {"nx", "ny", "nz"})
    set_property(file.vertices, name, std::vector<float>{1.0f, 2.0f, 3.0f});
  EXPECT_EQ(encode(file),
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 1 1 1\nvn 2 2 2\nvn 3 3 3\nf 1//1 3//3 2//2\n");
}

TEST(Write_obj, notes_what_the_format_has_no_place_for)
{
  std::vector<std::string> notes;
  encode_obj(parse_ply(fuzz::ply_seeds()[0], "a.ply"), notes);
  encode_obj(parse_ply(fuzz::binary_ply(false), "a.ply"), notes);
  EXPECT_EQ(notes, (std::vector<std::string>{"the vertex property quality is not written to OBJ",
                                             "the vertex property texture_u is not written to OBJ",
                                             "the vertex property texture_v is not written to OBJ",
                                             "the face property label is not written to OBJ",
                                             "lines obj_info are not written to OBJ",
                                             "the element edge is not written to OBJ"}));
}

}  // namespace cgp_test::write_obj_tests
