// Tests examples/conformal/io/off/read_off.cpp examples/conformal/io/obj/read_obj.cpp
// Tests examples/conformal/io/ply/read_ply.cpp examples/conformal/io/stl/read_stl.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "program/io/io_support.h"

#include "conformal/io/read_surface.h"
#include "tools/fuzz_readers_mutations.h"
#include "tools/fuzz_readers_seeds.h"

#include <cmath>

namespace cgp_test::damaged_files_tests {

using namespace conformal;

struct Format {
  const char* path;
  std::vector<std::string> seeds;
};

std::vector<Format> formats()
{
  return {{"a.off", fuzz::off_seeds()}, {"a.obj", fuzz::obj_seeds()}, {"a.ply", fuzz::ply_seeds()},
          {"a.stl", fuzz::stl_seeds()}, {"a.glb", fuzz::glb_seeds()}, {"a.vtk", fuzz::vtk_seeds()},
          {"a.vtp", fuzz::vtp_seeds()}};
}

bool is_sound(const Surface_file& file)
{
  const auto is_finite = [](const Point& p) {
    return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
  };
  bool sound = !file.points.empty() && file.polygons.size() != 0 &&
               file.vertices.size == file.points.size() && file.faces.size == file.polygons.size();
  for (const Point& point : file.points) sound = sound && is_finite(point);
  for (const int corner : file.polygons.corners)
    sound = sound && corner >= 0 && static_cast<std::size_t>(corner) < file.points.size();
  for (std::size_t f = 0; f < file.polygons.size(); ++f)
    sound = sound && file.polygons.degree(f) >= 3;
  for (const Corner_values* values : {&file.texture, &file.normals})
    for (const int row : values->index)
      sound = sound && row >= -1 && row < static_cast<int>(values->values.size());
  return sound;
}

// Either a sound surface or a Read_error that begins with the path; anything else fails the test.
void read_damaged(const std::string& bytes, const std::string& path)
{
  try {
    EXPECT_TRUE(is_sound(parse_surface(bytes, path)));
  } catch (const Read_error& error) {
    EXPECT_EQ(std::string(error.what()).substr(0, path.size() + 1), path + ':');
  }
}

TEST(Damaged_files, are_not_damaged_to_begin_with)
{
  for (const Format& format : formats())
    for (const std::string& seed : format.seeds)
      EXPECT_TRUE(is_sound(parse_surface(seed, format.path))) << seed;
}

TEST(Damaged_files, cut_at_any_byte_are_read_or_refused)
{
  for (const Format& format : formats())
    for (const std::string& seed : format.seeds)
      for (std::size_t size = 0; size < seed.size(); ++size)
        read_damaged(seed.substr(0, size), format.path);
}

TEST(Damaged_files, with_any_faults_are_read_or_refused)
{
  for (const Format& format : formats())
    for (unsigned i = 0; i < 500; ++i)
      read_damaged(fuzz::Mutator(i).mutant(format.seeds[i % format.seeds.size()]), format.path);
}

}  // namespace cgp_test::damaged_files_tests
