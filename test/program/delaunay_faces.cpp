// Tests examples/conformal/input/delaunay_faces.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/input/delaunay_faces.h"

#include "program/support.h"
#include "support/random.h"
#include "support/spheres.h"

#include "conformal/io/read_surface.h"

#include <Conformal_geometry_processing/measure/energies.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace cgp_test::delaunay_faces_tests {

using namespace program_test;
using namespace conformal;

/// a long surface, whose faces are thin
cgp_test::Mesh_view with_slivers()
{
  return cgp_test::mapped(
      cgp_test::perturbed(cgp_test::bumpy_sphere(3), .02),
      [](const Eigen::Vector3d& p) { return Eigen::Vector3d(4 * p.x(), p.y(), p.z()); });
}

std::array<int, 3> corners_of(const Surface_file& file, int f)
{
  const std::size_t first = file.polygons.first[static_cast<std::size_t>(f)];
  return {file.polygons.corners[first], file.polygons.corners[first + 1],
          file.polygons.corners[first + 2]};
}

/// a grid of parallelograms, whose long diagonals are far from Delaunay, with a label for each
Surface_file labelled_parallelograms(int n)
{
  Surface_file file;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) file.points.push_back({x + 2.2 * y, y + .01 * x * y, 0.});
  std::vector<double> labels;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const int a = y * (n + 1) + x;
      for (const int v : {a, a + 1, a + n + 2, a + n + 1}) file.polygons.corners.push_back(v);
      file.polygons.first.push_back(file.polygons.corners.size());
      labels.push_back(7 + a);
    }
  file.vertices.size = file.points.size();
  file.faces.size = file.polygons.size();
  set_property(file.faces, "label", labels);
  return file;
}

TEST(Delaunay_faces, have_the_properties_of_those_in_whose_place_they_are)
{
  const int n = 6;
  Surface_input input = prepare(labelled_parallelograms(n));
  const Surface_file before = input.file;
  const auto area = CGP::total_area(input.mesh);
  const Delaunay_faces made = make_delaunay(input, 0);
  EXPECT_GT(made.flips, n);
  EXPECT_EQ(input.file.points, before.points);
  ASSERT_EQ(input.file.polygons.size(), 2U * n * n);
  ASSERT_EQ(made.face_before.size(), 2U * n * n);
  const Property &labels = *find_property(input.file.faces, "label"),
                 &first = *find_property(before.faces, "label");
  for (std::size_t f = 0; f < made.face_before.size(); ++f)
    EXPECT_EQ(labels.value(f), first.value(static_cast<std::size_t>(made.face_before[f])));
  EXPECT_NEAR(CGP::total_area(prepare(input.file).mesh), area, 1e-12 * area);
  EXPECT_EQ(make_delaunay(input, 0).flips, 0);
}

class Connectivity : public Program {};

TEST_F(Connectivity, that_is_delaunay_is_judged_as_it_is_written)
{
  write("a.off", off(with_slivers()));
  const Program_run r = run("flow a.off --steps 6 --connectivity delaunay -o b.ply --json b.json");
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_NE(r.err.find("edges flipped"), std::string::npos) << r.err;
  const auto result = read_json("b.json")["result"];
  EXPECT_FALSE(result.contains("triangulation"));
  const Surface_file a = read_surface(path("a.off")), b = read_surface(path("b.ply"));
  const std::vector<int> changed = result["connectivity"]["changed_faces"];
  EXPECT_GT(changed.size(), 100U);
  EXPECT_EQ(result["connectivity"]["face_before"].size(), b.polygons.size());
  for (int f = 0; f < static_cast<int>(b.polygons.size()); ++f) {
    if (std::binary_search(changed.begin(), changed.end(), f)) continue;
    EXPECT_EQ(corners_of(a, f), corners_of(b, f));
  }
  ASSERT_EQ(run("info b.ply --json i.json").code, 0);
  const double energy = result["energy"]["final"];
  EXPECT_NEAR(read_json("i.json")["result"]["willmore_energy"], energy, 1e-6 * energy);
}

TEST_F(Connectivity, leaves_out_textures_with_a_note)
{
  std::string obj;
  const cgp_test::Mesh_view mesh = with_slivers();
  for (int v = 0; v < mesh.size_of_vertices(); ++v) {
    const Eigen::Vector3d p = mesh.position(v);
    obj += "v " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " +
           std::to_string(p.z()) + "\nvt " + std::to_string(p.x()) + " 0\n";
  }
  for (const auto& c : mesh.corners()) {
    obj += "f";
    for (const int v : c) obj += " " + std::to_string(v + 1) + "/" + std::to_string(v + 1);
    obj += "\n";
  }
  write("a.obj", obj);
  const Program_run r = run("flow a.obj --steps 2 --connectivity delaunay -o b.obj");
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_NE(r.err.find("texture coordinates are left out"), std::string::npos) << r.err;
  EXPECT_TRUE(read_surface(path("b.obj")).texture.empty());
  const Program_run kept = run("flow a.obj --steps 2 -o b.obj");
  EXPECT_FALSE(read_surface(path("b.obj")).texture.empty()) << kept.err;
}

}  // namespace cgp_test::delaunay_faces_tests
