// Tests examples/conformal/transform/cut_open.cpp examples/conformal/transform/cut_graph.cpp
// examples/conformal/transform/Shortest_paths.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/transform/Shortest_paths.h"
#include "conformal/transform/cut_graph.h"

#include "program/bounded_support.h"
#include "support/bounded_meshes.h"
#include "support/limbs.h"
#include "support/mesh_tools.h"
#include "support/polyhedra.h"
#include "support/spheres.h"
#include "support/tori.h"

#include "conformal/input/Surface_input.h"
#include "conformal/io/data/texture_coordinates.h"

#include <Conformal_geometry_processing/measure/overlaps.h>
#include <Conformal_geometry_processing/mesh/topology.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace cgp_test::flatten_closed_tests {

namespace CGP = Conformal_geometry_processing;

using namespace program_test;
using cgp_test::Mesh_view;

class Flatten_closed : public Bounded_program {
 protected:
  conformal::Surface_file file(const std::string& name) const
  {
    return conformal::read_surface(path(name));
  }

  /// whether the file is a surface with one boundary loop and no handles
  bool is_disk(const std::string& name) const
  {
    run("info " + name + " --json info.json");
    const auto input = json("info.json")["input"];
    return input["boundary_loops"] == 1 && input["genus"] == 0;
  }
};

conformal::Edge_set all_edges(const Mesh_view& mesh)
{
  return conformal::Edge_set(static_cast<std::size_t>(mesh.size_of_edges()), 1);
}

TEST(Cut_graph, is_a_path_on_a_sphere_and_has_a_handle_more_edges_than_a_tree_on_a_torus)
{
  const Mesh_view sphere = cgp_test::icosphere(2), torus = cgp_test::torus(3, 1, 16, 8);
  const auto ends = conformal::find_tips(sphere, 2, all_edges(sphere));
  const auto path = conformal::cut_graph(sphere, ends, all_edges(sphere));
  EXPECT_NEAR((sphere.position(ends[0]) - sphere.position(ends[1])).norm(), 2, .1);
  std::vector<int> degree(static_cast<std::size_t>(sphere.size_of_vertices()), 0);
  for (int k = 0; k < sphere.size_of_edges(); ++k)
    if (path[static_cast<std::size_t>(k)])
      for (const int v : sphere.ends(k)) ++degree[static_cast<std::size_t>(v)];
  EXPECT_EQ(std::count(degree.begin(), degree.end(), 1), 2);
  EXPECT_LE(*std::max_element(degree.begin(), degree.end()), 2);
  const auto loops = conformal::cut_graph(torus, {0}, all_edges(torus));
  double length = 0;
  for (int k = 0; k < torus.size_of_edges(); ++k)
    if (loops[static_cast<std::size_t>(k)])
      length += torus.vector(*torus.halfedges_begin(k)).norm();
  EXPECT_LT(length, 2 * cgp_test::pi * (1 + 4) * 1.1);
}

// The definition, one search from all tips for each
int farthest_from(const std::vector<int>& tips, const Mesh_view& mesh)
{
  conformal::Shortest_paths paths(mesh, all_edges(mesh));
  for (const int v : tips) paths.add_root(v);
  int farthest = 0;
  for (int v = 1; v < mesh.size_of_vertices(); ++v)
    if (paths.distance(v) > paths.distance(farthest)) farthest = v;
  return farthest;
}

TEST(Cut_graph, has_tips_as_far_as_possible_from_those_before_and_each_vertex_once)
{
  const Mesh_view mesh = cgp_test::bumpy_sphere(2);
  const auto tips = conformal::find_tips(mesh, 100000, all_edges(mesh));
  ASSERT_EQ(static_cast<int>(tips.size()), mesh.size_of_vertices());
  std::vector<int> before;
  for (const int v : tips) {
    if (!before.empty()) {
      ASSERT_EQ(v, farthest_from(before, mesh));
    }
    before.push_back(v);
  }
  std::sort(before.begin(), before.end());
  EXPECT_EQ(std::adjacent_find(before.begin(), before.end()), before.end());
}

// Each new tip shortens the paths of its neighbourhood, which shrinks: n / k vertices for tip k.
// From all tips anew they would be n^2.
TEST(Cut_graph, looks_at_about_n_log_n_vertices_for_all_tips)
{
  for (const int level : {2, 3, 4}) {
    const Mesh_view mesh = cgp_test::icosphere(level);
    conformal::Shortest_paths paths(mesh, all_edges(mesh));
    paths.add_root(0);
    for (int k = 1; k < mesh.size_of_vertices(); ++k) paths.add_root(paths.farthest_vertex());
    const double n = mesh.size_of_vertices();
    EXPECT_LT(static_cast<double>(paths.size_of_steps()), 2 * n * std::log(n));
  }
}

TEST_F(Flatten_closed, is_refused_unless_it_is_cut)
{
  write("a.off", off(cgp_test::icosphere(2)));
  EXPECT_TRUE(fails(run("flatten a.off -o b.ply"), 4, "--cut"));
}

TEST_F(Flatten_closed, keeps_the_mesh_and_gives_corners_texture_coordinates)
{
  write("a.off", off(cgp_test::bumpy_sphere(3)));
  ASSERT_EQ(run("flatten a.off --cut=3 -o b.ply --json b.json").code, 0);
  EXPECT_TRUE(json("b.json")["verified"]);
  const auto before = file("a.off"), after = file("b.ply");
  EXPECT_EQ(before.points, after.points);
  EXPECT_EQ(before.polygons.corners, after.polygons.corners);
  const auto texture = conformal::texture_coordinates(after);
  ASSERT_EQ(texture.index.size(), after.polygons.corners.size());
  EXPECT_FALSE(conformal::vertex_values(after, texture));  // there is a seam
  ASSERT_EQ(run("flatten a.off --cut --planar-mesh -o c.ply --json c.json").code, 0);
  const std::size_t vertices = file("c.ply").points.size();
  EXPECT_GT(vertices, before.points.size());
  const auto before_cuts = json("c.json")["result"]["vertex_before_cuts"];
  const auto flat = file("c.ply").polygons.corners;
  ASSERT_EQ(flat.size(), before.polygons.corners.size());
  for (std::size_t c = 0; c < flat.size(); ++c)
    EXPECT_EQ(before_cuts[static_cast<std::size_t>(flat[c])], before.polygons.corners[c]);
  EXPECT_TRUE(is_disk("c.ply"));
}

TEST_F(Flatten_closed, finds_how_many_tips_it_needs)
{
  write("a.off", off(cgp_test::torus(3, 1, 24, 12)));
  const auto error = [&](const std::string& options) -> double {
    EXPECT_EQ(run("flatten a.off -o b.ply --json b.json " + options).code, 0) << options;
    return json("b.json")["result"]["quasi_conformal"]["mean"];
  };
  const double four = error("--cut=4"), eight = error("--cut=8");
  EXPECT_EQ(error("--cut"), four);
  EXPECT_EQ(json("b.json")["result"]["tips"], 4);
  ASSERT_LT(eight, four);
  const std::string limit = " --limit quasi_conformal=" + std::to_string((four + eight) / 2);
  EXPECT_EQ(error("--cut" + limit), eight);
  EXPECT_EQ(json("b.json")["result"]["tips"], 8);
  EXPECT_TRUE(fails(run("flatten a.off --cut=4 -o c.ply" + limit), 1, "more cuts: --cut=8"));
  EXPECT_TRUE(fails(run("flatten a.off --cut -o c.ply --limit quasi_conformal=1.0001"), 1,
                    "64 tips of cuts were tried"));
}

TEST_F(Flatten_closed, takes_handles_polygons_and_cones)
{
  write("torus.off", off(cgp_test::torus(3, 1, 24, 12)));
  ASSERT_EQ(run("flatten torus.off --cut --planar-mesh -o t.ply").code, 0);
  EXPECT_TRUE(is_disk("t.ply"));
  write("cube.off",
        "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
        "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
  ASSERT_EQ(run("flatten cube.off --cones 0,2,5,7 --planar-mesh --force -o c.off").code, 0);
  EXPECT_EQ(file("c.off").polygons.size(), 6u);
  EXPECT_GT(file("c.off").points.size(), 8u);
  EXPECT_TRUE(fails(run("flatten cube.off --cones 3 -o d.off"), 4, "--cones"));
}

/// The lengths of each cut in the plane, by the points of its ends
std::map<std::pair<conformal::Point, conformal::Point>, std::vector<double>> cuts_of(
    const conformal::Surface_file& before, const conformal::Surface_file& flat)
{
  std::map<std::pair<conformal::Point, conformal::Point>, std::vector<double>> lengths;
  const auto point = [](const conformal::Surface_file& file, std::size_t corner) {
    return file.points[static_cast<std::size_t>(file.polygons.corners[corner])];
  };
  for (std::size_t c = 0; c < before.polygons.corners.size(); ++c) {
    const std::size_t next = c % 3 == 2 ? c - 2 : c + 1;
    const auto p = point(flat, c), q = point(flat, next);
    const auto ends = std::minmax(point(before, c), point(before, next));
    lengths[ends].push_back(std::hypot(p[0] - q[0], p[1] - q[1]));
  }
  return lengths;
}

TEST_F(Flatten_closed, with_cones_has_cuts_with_equal_sides_and_keeps_areas)
{
  for (const Mesh_view& mesh :
       {cgp_test::bumpy_sphere(3), cgp_test::irregular_torus(3, 1, 36, 20)}) {
    write("a.off", off(mesh));
    double deviation = HUGE_VAL;
    for (const int cones : {4, 16}) {
      const std::string cut = " --cut=" + std::to_string(cones) + " --planar-mesh --json b.json";
      ASSERT_EQ(run("flatten a.off --method spectral -o b.ply" + cut).code, 0);
      const double free_error = json("b.json")["result"]["quasi_conformal"]["mean"];
      ASSERT_EQ(run("flatten a.off --method cones -o b.ply" + cut).code, 0);
      const auto result = json("b.json")["result"];
      EXPECT_TRUE(json("b.json")["verified"]);
      EXPECT_LT(result["quasi_conformal"]["mean"], 1.3 * free_error);
      EXPECT_EQ(result["cones"]["vertices"].size(), static_cast<std::size_t>(cones));
      double angles = 0;
      for (const double angle : result["cones"]["angles"]) angles += 360 - angle;
      EXPECT_NEAR(angles, 360 * CGP::topology(mesh).euler_characteristic(), 1e-6);
      EXPECT_LT(result["scale"]["log_deviation"], deviation);
      deviation = result["scale"]["log_deviation"];
      for (const auto& [ends, lengths] : cuts_of(file("a.off"), file("b.ply"))) {
        ASSERT_EQ(lengths.size(), 2u);
        EXPECT_NEAR(lengths[0], lengths[1], 1e-3 * lengths[0]);
      }
      EXPECT_EQ(is_disk("b.ply"), result["overlap"]["faces"] == 0);
    }
  }
}

// A block is flat outside its corners, which are cones of 270 degrees: its map is an isometry.
TEST_F(Flatten_closed, with_its_corners_as_cones_unfolds_a_block)
{
  const Mesh_view mesh = cgp_test::block(4, 3, 2);
  write("a.off", off(mesh));
  std::string cones;
  for (int v = 0; v < mesh.size_of_vertices(); ++v) {
    const Eigen::Vector3d p = mesh.position(v);
    const bool is_corner = (p.array() == mesh.positions().rowwise().minCoeff().array() ||
                            p.array() == mesh.positions().rowwise().maxCoeff().array())
                               .all();
    if (is_corner) cones += (cones.empty() ? "" : ",") + std::to_string(v) + ":270";
  }
  ASSERT_EQ(run("flatten a.off --method cones --cones " + cones + " -o b.ply --json b.json").code,
            0);
  const auto result = json("b.json")["result"];
  EXPECT_NEAR(result["quasi_conformal"]["max"], 1, 1e-5);
  EXPECT_LT(result["scale"]["log_deviation"], 1e-5);
  EXPECT_EQ(result["flipped_faces"], 0);
}

TEST_F(Flatten_closed, refuses_cones_that_do_not_fit)
{
  write("a.off", off(cgp_test::icosphere(2)));
  const std::string to = "flatten a.off --method cones -o b.ply --cones ";
  EXPECT_TRUE(fails(run(to + "0:90,1:90,2:90"), 4, "adds up to 810, wanted 720"));
  EXPECT_TRUE(fails(run(to + "0,1"), 4, "three at least"));
  EXPECT_TRUE(fails(run(to + "0:350,1:350,2"), 4, "no angle for vertex 2"));
  EXPECT_TRUE(fails(run(to + "0:0,1,2"), 2, "'0:0' is not a vertex"));
  EXPECT_TRUE(fails(run(to + "x"), 2, "'x' is not a vertex"));
  EXPECT_TRUE(fails(run(to + "0,1,2,162"), 4, "no face has a vertex 162"));
  EXPECT_TRUE(fails(run("flatten a.off -o b.ply --cones 0,1:90"), 2, "vertex 1 is for --method"));
  EXPECT_TRUE(fails(run("flatten a.off --method cones -o b.ply"), 4, "--cut"));
  EXPECT_EQ(run(to + "0:90,1:120,2,3 --force --json b.json").code, 0);
  EXPECT_NEAR(json("b.json")["result"]["cones"]["angles"][1].get<double>(), 120, 1e-9);
}

TEST_F(Flatten_closed, cuts_an_image_that_overlaps_into_charts)
{
  write("a.off", off(cgp_test::dumbbell(3)));
  bool has_overlapped = false;
  for (const int cones : {8, 24, 48}) {
    ASSERT_EQ(run("flatten a.off --method cones --planar-mesh -o b.ply --json b.json --cut=" +
                  std::to_string(cones))
                  .code,
              0);
    const auto result = json("b.json")["result"];
    const bool overlaps = result["overlap"]["share"] > 0;
    has_overlapped |= overlaps;
    ASSERT_EQ(result.count("charts") == 1, overlaps);
    const Mesh_view flat = conformal::prepare(file("b.ply")).mesh;
    EXPECT_EQ(CGP::internal::overlaps(flat, flat.positions()).size(), 0u);
    EXPECT_EQ(CGP::topology(flat).components, result.value("charts", 1));
    EXPECT_EQ(file("b.ply").polygons.size(), file("a.off").polygons.size());
    EXPECT_EQ(result["vertex_before_cuts"].size(), file("b.ply").points.size());
    for (const auto& [ends, lengths] : cuts_of(file("a.off"), file("b.ply")))
      EXPECT_NEAR(lengths[0], lengths[1], 1e-3 * lengths[0]);
  }
  EXPECT_TRUE(has_overlapped);
}

// A cylinder is flat, but its image needs a cut.
TEST_F(Flatten_closed, with_cones_unrolls_a_cylinder)
{
  write("a.off", off(cgp_test::cylinder(1, 3, 24, 12)));
  ASSERT_EQ(run("flatten a.off --method cones --planar-mesh -o b.ply --json b.json").code, 0);
  const auto result = json("b.json")["result"];
  EXPECT_NEAR(result["quasi_conformal"]["max"], 1, 1e-5);
  EXPECT_LT(result["scale"]["log_deviation"], 1e-5);
  EXPECT_EQ(result["overlap"]["faces"], 0);
  EXPECT_TRUE(is_disk("b.ply"));
}

/// by how much the map scales the edges at the boundary before, as largest by least
double spread_of_boundary(const conformal::Surface_file& before,
                          const conformal::Surface_file& flat)
{
  double least = HUGE_VAL, most = 0;
  for (const auto& [ends, lengths] : cuts_of(before, flat)) {
    if (lengths.size() != 1) continue;
    const auto& [p, q] = ends;
    const double scale = lengths[0] / std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    least = std::min(least, scale);
    most = std::max(most, scale);
  }
  return most / least;
}

TEST_F(Flatten_closed, with_cones_keeps_the_length_of_a_boundary)
{
  const Mesh_view cap = cgp_test::cap_from_disk(cgp_test::jittered_disk(16, .25), 2.4);
  const Mesh_view torus = cgp_test::irregular_torus(3, 1, 36, 20),
                  holed = cgp_test::without_face(torus, 7);
  for (const Mesh_view& mesh : {cap, holed}) {
    write("a.off", off(mesh));
    double deviation = HUGE_VAL;
    for (const std::string cut : {"", " --cut=4", " --cut=16"}) {
      ASSERT_EQ(run("flatten a.off --method cones --planar-mesh -o b.ply --json b.json" + cut).code,
                0);
      const auto result = json("b.json")["result"];
      EXPECT_LT(result["quasi_conformal"]["mean"], 1.2);
      EXPECT_LT(result["scale"]["log_deviation"], deviation);
      deviation = result["scale"]["log_deviation"];
      EXPECT_LT(spread_of_boundary(file("a.off"), file("b.ply")), 1.001);
    }
    EXPECT_LT(deviation, .2);
  }
  EXPECT_TRUE(fails(
      run("flatten a.off --method cones -o c.ply --cones " + std::to_string(torus.corners(7)[0])),
      4, "is at the boundary"));
}

}  // namespace cgp_test::flatten_closed_tests
