// Tests examples/conformal/io/data/note_losses.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/io/data/note_losses.h"

#include "conformal/io/data/texture_coordinates.h"
#include "conformal/io/read_surface.h"
#include "conformal/io/write_surface.h"
#include "program/io/io_support.h"

namespace cgp_test::note_losses_tests {

using namespace conformal;
using namespace io_test;

// Numbers that are the same in single precision, colours that are in bytes.
const std::string whole =
    "ply\nformat ascii 1.0\ncomment by hand\nobj_info scanned\nelement vertex 4\n"
    "property double x\nproperty double y\nproperty double z\nproperty uchar red\n"
    "property uchar green\nproperty uchar blue\nproperty float rho\nproperty float quality\n"
    "property float texture_u\nproperty float texture_v\nproperty float s\n"
    "element face 3\nproperty list uchar int vertex_indices\nproperty int label\n"
    "element edge 1\nproperty int vertex1\nelement nothing 0\nproperty int a\nend_header\n"
    "0 0 0 0 255 51 0.5 1 0 0 7\n1 0 0 255 0 0 -0.25 0.5 1 0 8\n1 1 0 0 0 255 2 0 1 1 9\n"
    "0 1 2 102 0 0 0 1 0 1 10\n4 0 1 2 3 5\n3 0 2 1 6\n3 0 3 2 7\n1\n";

bool is_noted(const std::vector<std::string>& notes, const std::string& what)
{
  for (const std::string& note : notes)
    if (note.find(what) != std::string::npos) return true;
  return false;
}

/// the names of the properties that both have, in the order of the first
std::vector<std::string> common(const Element& a, const Element& b)
{
  std::vector<std::string> names;
  for (const Property& property : a.properties)
    if (find_property(b, property.name()) != nullptr) names.push_back(property.name());
  return names;
}

class Formats : public ::testing::TestWithParam<const char*> {
 protected:
  Surface_file before = parse_surface(whole, "whole.ply"), after;
  std::vector<std::string> notes;

  void SetUp() override
  {
    const Folder folder;
    notes = write_surface(folder / GetParam(), before);
    after = read_surface(folder / GetParam());
  }

  void expect_kept_or_noted(bool is_kept, const std::string& what) const
  {
    EXPECT_NE(is_kept, is_noted(notes, what)) << GetParam() << ": " << what;
  }
};

TEST_P(Formats, keep_points_faces_and_their_order)
{
  EXPECT_EQ(after.points, before.points);
  const bool has_polygons = after.polygons.size() == before.polygons.size();
  EXPECT_EQ(after.polygons.corners == before.polygons.corners, has_polygons);
  expect_kept_or_noted(has_polygons, "polygons");
}

TEST_P(Formats, keep_each_property_with_its_values_or_have_a_note)
{
  for (const char* name : {"rho", "red", "green", "blue", "quality", "s"}) {
    const bool is_kept = find_property(after.vertices, name) != nullptr;
    expect_kept_or_noted(is_kept, std::string("vertex property ") + name + ' ');
    const double unit =
        is_kept && find_property(after.vertices, name)->type() == Value_type::float64
            ? 255
            : 1;  // colours of OBJ
    for (std::size_t v = 0; is_kept && v < 4; ++v)
      EXPECT_NEAR(unit * values(after.vertices, name)[v], values(before.vertices, name)[v], 1e-12);
  }
  expect_kept_or_noted(find_property(after.faces, "label") != nullptr, "face property label");
  EXPECT_EQ(common(after.vertices, before.vertices), common(before.vertices, after.vertices));
}

TEST_P(Formats, keep_all_else_or_have_a_note)
{
  const Corner_values texture = texture_coordinates(after);
  expect_kept_or_noted(!texture.empty(), "texture coordinates");
  for (std::size_t c = 0; !texture.empty() && c < after.polygons.corners.size(); ++c) {
    const Point& p = after.points[static_cast<std::size_t>(after.polygons.corners[c])];
    const auto& uv = texture.values[static_cast<std::size_t>(texture.index[c])];
    EXPECT_EQ((std::array{uv[0], uv[1]}), (std::array{p[0], p[1]}));
  }
  expect_kept_or_noted(!after.comments.empty(), "comments");
  expect_kept_or_noted(!after.object_info.empty(), "obj_info");
  expect_kept_or_noted(after.other_elements.size() == 1, "element edge");
  EXPECT_FALSE(is_noted(notes, "element nothing"));
}

INSTANTIATE_TEST_SUITE_P(All, Formats,
                         ::testing::Values("a.ply", "a.off", "a.obj", "a.glb", "a.stl"));

}  // namespace cgp_test::note_losses_tests
