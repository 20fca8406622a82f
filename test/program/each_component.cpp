// Tests examples/conformal/transform/each_component.cpp examples/conformal/transform/Component.cpp
// Tests examples/conformal/transform/Component_failures.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "program/support.h"
#include "support/bounded_meshes.h"
#include "support/mesh_tools.h"
#include "support/polyhedra.h"
#include "support/random.h"
#include "support/several_components.h"
#include "support/spheres.h"
#include "support/tori.h"

#include "conformal/io/read_surface.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <regex>
#include <string>
#include <utility>
#include <vector>

namespace cgp_test::each_component_tests {

using namespace program_test;
using cgp_test::Joined_meshes;
using cgp_test::Mesh_view;
using conformal::read_surface;

class Each_component : public Program {
 protected:
  nlohmann::json json(const std::string& name) const { return read_json(name); }

  /// the points of the vertices in a file, 3 x count
  cgp_test::Points points(const std::string& name, const std::vector<int>& vertices) const
  {
    const auto file = read_surface(path(name));
    cgp_test::Points p(3, static_cast<Eigen::Index>(vertices.size()));
    for (std::size_t i = 0; i < vertices.size(); ++i)
      p.col(static_cast<Eigen::Index>(i)) =
          Eigen::Vector3d::Map(file.points[static_cast<std::size_t>(vertices[i])].data());
    return p;
  }
};

std::vector<int> all_of(const Mesh_view& mesh)
{
  std::vector<int> numbers(static_cast<std::size_t>(mesh.size_of_vertices()));
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<int>(i);
  return numbers;
}

const std::vector<Mesh_view>& parts()
{
  static const std::vector<Mesh_view> surfaces = cgp_test::surfaces_of_different_types();
  return surfaces;
}

TEST_F(Each_component, spins_as_it_does_alone_and_has_a_certificate)
{
  const Joined_meshes all = cgp_test::interleaved(parts());
  write("all.off", off(all.mesh));
  // rho as a property, which is in units of the normalised frame of each file: scaled by hand
  const auto diagonal = [](const Mesh_view& mesh) {
    const auto& p = mesh.positions();
    return (p.rowwise().maxCoeff() - p.rowwise().minCoeff()).norm();
  };
  const auto text = [&](const Mesh_view& mesh) {
    std::string lines;
    for (int v = 0; v < mesh.size_of_vertices(); ++v)
      lines += std::to_string(.25 * std::round(4 * std::sin(mesh.position(v).x()))) + "\n";
    return lines;
  };
  write("all.txt", text(all.mesh));
  const Program_run r =
      run("spin all.off --rho-file all.txt --each-component -o b.ply --json b.json");
  ASSERT_EQ(r.code, 0) << r.err;
  const auto report = json("b.json");
  EXPECT_TRUE(report["verified"]);
  ASSERT_EQ(report["components"].size(), 3u);
  for (std::size_t p = 0; p < 3; ++p) {
    const auto& own = report["components"][p];
    EXPECT_TRUE(own["verified"]);
    EXPECT_EQ(own["first_vertex"], p);
    EXPECT_EQ(own["vertices"], parts()[p].size_of_vertices());
    EXPECT_EQ(own["genus"], p == 1 ? 1 : 0);
    EXPECT_EQ(own["boundary_loops"], p == 2 ? 1 : 0);
    write("one.off", off(parts()[p]));
    write("one.txt", text(parts()[p]));
    const std::string factor = std::to_string(diagonal(parts()[p]) / diagonal(all.mesh));
    ASSERT_EQ(
        run("spin one.off --rho-file one.txt --amplitude " + factor + " -o one.ply --json one.json")
            .code,
        0);
    const auto alone = json("one.json");
    EXPECT_NEAR(own["result"]["quasi_conformal"]["mean"],
                alone["result"]["quasi_conformal"]["mean"], 1e-6);
    EXPECT_NEAR(own["result"]["eigenvalue"], alone["result"]["eigenvalue"], 1e-5);
    const cgp_test::Points difference =
        points("b.ply", all.vertices[p]) - points("one.ply", all_of(parts()[p]));
    EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-4);
  }
}

TEST_F(Each_component, flows_and_is_flattened)
{
  const Joined_meshes all = cgp_test::interleaved(
      {cgp_test::cap_from_disk(cgp_test::disk(5), 1.5), cgp_test::annulus(1, 2, 24, 3)});
  write("a.off", off(all.mesh));
  ASSERT_EQ(run("flow a.off --steps 2 --each-component -o b.ply --json b.json").code, 0);
  EXPECT_TRUE(json("b.json")["verified"]);
  EXPECT_FALSE(json("b.json")["components"][1]["steps"].is_null());
  const Program_run r = run("flatten a.off --planar-mesh --each-component -o c.ply --json c.json");
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(json("c.json")["components"][1]["result"]["boundary_loops"], 2);
  const auto first = points("c.ply", all.vertices[0]), second = points("c.ply", all.vertices[1]);
  EXPECT_GT(first.row(1).minCoeff(), second.row(1).maxCoeff());  // two rows, the higher one first
}

TEST_F(Each_component, has_a_spectrum_and_fields_of_its_own)
{
  const Mesh_view t = cgp_test::torus(2, 1, 24, 12);
  const Joined_meshes all =
      cgp_test::interleaved({cgp_test::scaled(t, 2), cgp_test::moved(t, {20, 0, 0})});
  write("t.off", off(t));
  write("a.off", off(all.mesh));
  ASSERT_EQ(run("spectrum t.off --count 3 --json t.json").code, 0);
  ASSERT_EQ(run("spectrum a.off --count 3 --each-component --csv a.csv --json a.json").code, 0);
  const std::vector<double> alone = json("t.json")["result"]["eigenvalues"];
  const auto report = json("a.json");
  EXPECT_TRUE(report["verified"]);
  for (std::size_t c = 0; c < 2; ++c) {
    const std::vector<double> values = report["components"][c]["result"]["eigenvalues"];
    ASSERT_EQ(values.size(), alone.size());
    for (std::size_t k = 0; k < alone.size(); ++k)
      EXPECT_NEAR(values[k], alone[k] / (c == 0 ? 2 : 1), 1e-6);
  }
  EXPECT_EQ(content(path("a.csv")).rfind("component,number,", 0), 0u);
  EXPECT_TRUE(fails(run("spectrum a.off --each-component --surface 0 -o b.ply"), 2, "--surface"));

  ASSERT_EQ(run("harmonic t.off --json t.json").code, 0);
  ASSERT_EQ(run("harmonic a.off --each-component -o b.ply --json a.json").code, 0);
  const double modulus = json("t.json")["result"]["conformal_modulus"]["imaginary"];
  for (const auto& component : json("a.json")["components"])
    EXPECT_NEAR(component["result"]["conformal_modulus"]["imaginary"], modulus, 1e-9);
  const auto b = read_surface(path("b.ply"));
  EXPECT_NE(find_property(b.faces, "harmonic_1_z"), nullptr);
}

TEST_F(Each_component, that_fails_is_no_part_of_the_fields_of_the_others)
{
  const Joined_meshes all = cgp_test::interleaved(
      {cgp_test::torus(2, 1, 16, 8), cgp_test::moved(cgp_test::icosphere(1), {20, 0, 0})});
  write("a.off", off(all.mesh));
  EXPECT_TRUE(fails(run("harmonic a.off --each-component -o b.ply"), 4, "genus 0"));
  EXPECT_FALSE(has("b.ply"));
  EXPECT_EQ(run("harmonic a.off --each-component --advanced keep-going -o b.ply").code, 1);
  EXPECT_TRUE(has("b.ply"));
}

TEST_F(Each_component, that_is_inside_out_is_computed_with_outward_normals)
{
  const Mesh_view s = cgp_test::icosphere(1);
  const Joined_meshes all = cgp_test::interleaved(
      {cgp_test::scaled(s, 2), cgp_test::with_reversed_faces(cgp_test::moved(s, {9, 0, 0}))});
  write("a.off", off(all.mesh));
  const Program_run r = run("spin a.off --rho-expression 'nx' --each-component -o b.ply");
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_NE(r.err.find("1 component inside out"), std::string::npos) << r.err;
  EXPECT_EQ(read_surface(path("a.off")).polygons.corners,
            read_surface(path("b.ply")).polygons.corners);
}

TEST_F(Each_component, is_refused_unless_it_is_asked_for)
{
  write("a.off", off(cgp_test::interleaved(parts()).mesh));
  EXPECT_TRUE(fails(run("spin -q a.off --rho-expression x -o b.ply"), 4, "try: --each-component"));
  EXPECT_FALSE(has("b.ply"));
}

TEST_F(Each_component, that_fails_is_named_and_nothing_is_written)
{
  write("a.off", off(cgp_test::interleaved(parts()).mesh));
  const std::string each = "a.off --each-component -o b.ply --json b.json ";
  EXPECT_TRUE(fails(run("flatten -q " + each), 4,
                    "a.off: 2 of 3 components failed; component 0 (from vertex 0), component 1 "
                    "(from vertex 1): the surface is closed"));
  EXPECT_FALSE(has("b.ply"));
  const auto report = json("b.json");
  EXPECT_FALSE(report["verified"]);
  EXPECT_FALSE(report["components"][0]["verified"]);
  EXPECT_TRUE(report["components"][2]["verified"]);
  EXPECT_TRUE(fails(run("spin -q --rho-expression x --limit quasi_conformal=1.000001 " + each), 1,
                    "components failed; component 0 (from vertex 0)"));
  EXPECT_FALSE(has("b.ply"));
  EXPECT_EQ(run("spin -q --rho-expression x --force --limit quasi_conformal=1.000001 " + each).code,
            0);
  EXPECT_TRUE(has("b.ply"));
  EXPECT_FALSE(json("b.json")["verified"]);
}

TEST_F(Each_component, that_fails_like_many_others_is_counted)
{
  std::vector<Mesh_view> crumbs(8, cgp_test::tetrahedron());
  crumbs.push_back(cgp_test::disk(2));
  write("a.off", off(cgp_test::interleaved(crumbs).mesh));
  EXPECT_TRUE(fails(run("flatten -q a.off --each-component -o b.ply --json b.json"), 4,
                    "a.off: 8 of 9 components failed; component 0 (from vertex 0), component 1 "
                    "(from vertex 1), component 2 (from vertex 2), component 3 (from vertex 3), "
                    "component 4 (from vertex 4) and 3 more: the surface is closed"));
  EXPECT_TRUE(json("b.json")["components"][7].contains("error"));
}

TEST_F(Each_component, cannot_be_shown_in_snapshots_of_the_whole)
{
  write("a.off", off(cgp_test::interleaved(parts()).mesh));
  EXPECT_TRUE(fails(run("flow -q a.off --every 1 --each-component -o b.ply"), 2, "--every"));
}

TEST_F(Each_component, that_fails_stays_as_it_was_if_the_others_are_wanted)
{
  const Joined_meshes all = cgp_test::interleaved(parts());
  write("a.off", off(all.mesh));
  const std::string each = " -q --each-component --advanced keep-going --json b.json ";
  EXPECT_TRUE(fails(run("flatten a.off --planar-mesh -o b.ply" + each), 1,
                    "a.off: 2 of 3 components failed; component 0 (from vertex 0), component 1 "
                    "(from vertex 1): the surface is closed"));
  EXPECT_FALSE(json("b.json")["verified"]);
  EXPECT_EQ(json("b.json")["result"]["verified_components"], 1);
  EXPECT_EQ(points("b.ply", all.vertices[1]), points("a.off", all.vertices[1]));
  EXPECT_LT(points("b.ply", all.vertices[2]).row(2).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_TRUE(fails(run("spin a.off --rho-expression x -o c.ply --limit flipped_share=-1" + each),
                    1, "3 of 3 components failed"));
  EXPECT_FALSE(has("c.ply"));
  EXPECT_TRUE(fails(run("spin a.off --rho-expression x -o c.ply --advanced keep-going"), 2,
                    "--keep-going requires --each"));
}

TEST_F(Each_component, with_a_face_of_area_zero_does_not_take_the_others_with_it)
{
  std::vector<Mesh_view> meshes = {cgp_test::bumpy_sphere(2), cgp_test::torus(3, 1, 24, 12)};
  cgp_test::Points flat = meshes[1].positions();
  flat.col(meshes[1].corners(0)[1]) = flat.col(meshes[1].corners(0)[0]);
  meshes[1].set_positions(flat);
  const Joined_meshes all = cgp_test::interleaved(meshes);
  write("a.off", off(all.mesh));
  const std::string each = " a.off -q --each-component -o b.ply ";
  for (const std::string command : {"spin --rho-expression .3*x --mollify=0", "flow --steps 1"}) {
    EXPECT_TRUE(fails(run(command + each), 4, "of area zero"));
    EXPECT_FALSE(has("b.ply"));
    EXPECT_TRUE(fails(run(command + each + "--advanced keep-going --json b.json"), 1,
                      "1 of 2 components failed; component 1 (from vertex 1): "));
    EXPECT_EQ(json("b.json")["result"]["verified_components"], 1);
    EXPECT_EQ(points("b.ply", all.vertices[1]), points("a.off", all.vertices[1]));
    EXPECT_NE(points("b.ply", all.vertices[0]), points("a.off", all.vertices[0]));
    std::filesystem::remove(path("b.ply"));
  }
}

TEST_F(Each_component, has_boundary_conditions_targets_and_differences_of_its_own)
{
  const Joined_meshes all = cgp_test::interleaved(
      {cgp_test::cap_from_disk(cgp_test::disk(5), 1.5),
       cgp_test::moved(cgp_test::cap_from_disk(cgp_test::disk(4), 1), {9, 0, 0})});
  write("a.off", off(all.mesh));
  const std::string each = " -q --each-component --json b.json --lambda q ";
  ASSERT_EQ(run("boundary a.off --binormal-tilt 10 -o b.ply" + each).code, 0);
  EXPECT_EQ(json("b.json")["result"]["verified_components"], 2);
  ASSERT_EQ(run("boundary a.off --binormals-from b.ply -o c.ply" + each).code, 0);
  for (const auto& own : json("b.json")["components"])
    EXPECT_LT(own["result"]["boundary"]["direction_error"]["mean"], 1);
  ASSERT_EQ(run("fit a.off b.ply -o d.ply" + each).code, 0);
  for (const auto& own : json("b.json")["components"])
    EXPECT_LT(own["result"]["distance"]["rms"], .02);
  ASSERT_EQ(run("blend a.off b.ply --t 0 -o e.ply" + each).code, 0);
  for (const auto& vertices : all.vertices)
    EXPECT_LT((points("e.ply", vertices) - points("a.off", vertices)).cwiseAbs().maxCoeff(), .05);
}

/// with other numbers of the vertices, and the faces in another order
Mesh_view shuffled(const Mesh_view& mesh, const std::vector<int>& number)
{
  const Mesh_view other = cgp_test::renumbered(mesh, number);
  Mesh_view::Corners corners;
  for (const int f : cgp_test::random_permutation(mesh.size_of_faces(), 5))
    corners.push_back(other.corners(f));
  return {other.positions(), corners};
}

/// the x of the vertices that a refusal of `x` as a factor names, one for each component
std::vector<double> refused_factors(const std::string& message, const Mesh_view& mesh)
{
  const std::regex words("vertex ([0-9]+) has the value");
  std::vector<double> x;
  for (std::sregex_iterator i(message.begin(), message.end(), words), end; i != end; ++i)
    x.push_back(mesh.position(std::stoi((*i)[1])).x());
  return x;
}

// The program computes in an order of its own.
TEST_F(Each_component, has_the_names_of_the_file_in_messages)
{
  const Mesh_view sphere =
      cgp_test::renumbered(cgp_test::icosphere(2), cgp_test::random_permutation(162, 8));
  write("a.off", off(sphere));
  int v = 0;
  while (!(sphere.position(v).x() < 0)) ++v;
  const std::string number = std::to_string(v);
  write("a.json", R"({"targets": [{"vertex": )" + number + R"(, "move": [0, 0, 0]}]})");
  EXPECT_TRUE(fails(run("deform a.off --targets a.json --region-expression 3*x -o c.ply"), 4,
                    "is at vertex " + number + ", which is outside"));
  const Mesh_view two = cgp_test::interleaved({sphere, cgp_test::moved(sphere, {0, 4, 0})}).mesh;
  write("b.off", off(two));
  const std::string spin = "spin b.off --rho-expression 0 --target-scale-expression x -o c.ply ";
  const std::vector<double> x = refused_factors(run(spin + "--each-component").err, two);
  ASSERT_EQ(x.size(), 2);
  EXPECT_LT(x[0], 1e-12);
  EXPECT_LT(x[1], 1e-12);
}

// A map, a handle, a boundary whose directions are kept, positions at it, and a flow.
TEST_F(Each_component, has_the_same_bits_for_any_numbering_of_the_file)
{
  const Mesh_view sphere = cgp_test::bumpy_sphere(2), torus = cgp_test::torus(1, .4, 24, 12),
                  cap = cap_from_disk(cgp_test::jittered_disk(8, .2), 1.2);
  const std::string rho = "--rho-expression 'sin(3*x+y)' --on vertices ";
  const std::vector<std::pair<Mesh_view, std::string>> runs = {
      {sphere, "spin FILE " + rho},
      {sphere, "spin FILE --max-scale none " + rho},
      {torus, "spin FILE " + rho},
      {cap, "spin FILE " + rho},
      {cap, "spin FILE --boundary tangents " + rho},
      {sphere, "flow FILE --steps 2 "}};
  for (const auto& [mesh, command] : runs) {
    const std::vector<int> number = cgp_test::random_permutation(mesh.size_of_vertices(), 4);
    write("a.off", off(mesh));
    write("b.off", off(shuffled(mesh, number)));
    const auto with = [&, &text = command](const std::string& file) {
      return std::string(text).replace(text.find("FILE"), 4, file);
    };
    ASSERT_EQ(run(with("a.off") + "-o a.ply").code, 0) << command;
    ASSERT_EQ(run(with("b.off") + "-o b.ply").code, 0) << command;
    EXPECT_EQ(points("a.ply", all_of(mesh)), points("b.ply", number)) << command;
  }
}

}  // namespace cgp_test::each_component_tests
