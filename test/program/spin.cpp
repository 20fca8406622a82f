// Tests examples/conformal/commands/spin.cpp examples/conformal/transform/write_result.cpp
// Tests examples/conformal/report/verification.cpp examples/conformal/report/certificate.cpp
// Tests examples/conformal/transform/solve_spin.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "program/support.h"
#include "support/spheres.h"
#include "support/thin_faces.h"
#include "support/tori.h"

#include "conformal/io/read_surface.h"

#include <nlohmann/json.hpp>

namespace cgp_test::spin_tests {

using namespace program_test;
using conformal::read_surface;

using Spin = Program;

TEST_F(Spin, report_has_the_agreed_fields)
{
  write("a.off", off(cgp_test::icosphere(2)));
  const Program_run r = run("spin a.off --rho-expression 'x*y' -o b.ply --json b.json");
  ASSERT_EQ(r.code, 0) << r.err;
  const auto json = read_json("b.json");
  EXPECT_EQ(json["command"], "spin");
  EXPECT_EQ(json["input"]["vertices"], 162);
  EXPECT_EQ(json["input"]["genus"], 0);
  EXPECT_TRUE(json["result"]["relaxed"]);  // by the default bound: no eigenvector
  for (const char* place :
       {"eigenvalue", "dirac_residual", "iterations", "closure_residual", "quasi_conformal/mean",
        "quasi_conformal/p99", "quasi_conformal/max", "length_cross_ratio/rms",
        "length_cross_ratio/max", "scale/min", "scale/max", "flipped_faces"})
    EXPECT_TRUE(json.at(nlohmann::json::json_pointer(std::string("/result/") + place)).is_number())
        << place;
  for (const char* stage :
       {"read", "assembly", "factorization", "solve", "reconstruction", "write", "total"})
    EXPECT_TRUE(json["seconds"].at(stage).is_number()) << stage;
  EXPECT_TRUE(json["steps"].is_array());
  EXPECT_TRUE(json["verified"]);
}

TEST_F(Spin, constant_rho_changes_nothing_but_the_numbering_stays)
{
  write("a.off", off(cgp_test::bumpy_sphere(2)));
  ASSERT_EQ(run("spin a.off --rho-expression 0.1 -o b.ply").code, 0);
  const auto a = read_surface(path("a.off")), b = read_surface(path("b.ply"));
  EXPECT_EQ(a.polygons.corners, b.polygons.corners);
  for (std::size_t v = 0; v < a.points.size(); ++v)
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a.points[v][i], b.points[v][i], 2e-2);
}

TEST_F(Spin, handles_stay_closed_unless_they_may_open)
{
  write("a.off", off(cgp_test::torus(1, 0.4, 40, 16)));
  const std::string rho = "spin a.off --rho-expression 'sin(3*x+1)' ";
  const Program_run r = run(rho + "-o b.ply --json b.json");
  ASSERT_EQ(r.code, 0) << r.err;
  const auto closed = read_json("b.json");
  EXPECT_LT(closed["result"]["quasi_conformal"]["mean"], 1.1);
  EXPECT_GT(closed["result"]["missing_share"], 0.5);
  EXPECT_NE(r.err.find(" % of the norm of rho is left out"), std::string::npos) << r.err;
  EXPECT_EQ(closed["result"]["reached"], 1);
  EXPECT_NE(r.out.find("left out of rho"), std::string::npos) << r.out;
  EXPECT_LE(closed["result"]["period_defect"], 1e-8);
  ASSERT_EQ(run(rho + "--open-handles --force -o c.ply --json c.json").code, 0);
  const auto open = read_json("c.json");
  EXPECT_GT(open["result"]["quasi_conformal"]["mean"], closed["result"]["quasi_conformal"]["mean"]);
  EXPECT_EQ(open["result"]["missing_share"], 0);
}

TEST_F(Spin, two_runs_write_the_same_bytes)
{
  write("a.off", off(cgp_test::icosphere(3)));
  for (const std::string name : {"b.ply", "c.ply"})
    ASSERT_EQ(run("spin a.off --rho-expression 'sin(3*x)' -o " + name).code, 0);
  EXPECT_EQ(content(path("b.ply")), content(path("c.ply")));
}

// With a weak rho, and with one of which the bound on lengths leaves a part out.
TEST_F(Spin, all_solvers_agree)
{
  write("a.off", off(cgp_test::icosphere(1)));
  for (const std::string rho : {"x*y", "3*x"}) {
    const std::string spin = "spin a.off --rho-expression '" + rho + "' --json r.json -o ";
    ASSERT_EQ(run(spin + "b.ply").code, 0);
    EXPECT_EQ(read_json("r.json")["result"]["scale_control"]["weight"] > 0, rho == "3*x");
    const auto b = read_surface(path("b.ply"));
    for (const std::string solver : {"cholmod", "eigen"}) {
      ASSERT_EQ(run(spin + "c.ply --advanced solver=" + solver).code, 0);
      const auto c = read_surface(path("c.ply"));
      for (std::size_t v = 0; v < b.points.size(); ++v)
        EXPECT_NEAR(b.points[v][0], c.points[v][0], 1e-6);
    }
  }
}

TEST_F(Spin, input_may_be_the_output)
{
  write("a.ply", "");
  write("a.off", off(cgp_test::icosphere(1)));
  ASSERT_EQ(run("spin a.off --rho-expression 0 -o a.ply").code, 0);
  EXPECT_EQ(run("spin a.ply --rho-expression x -o a.ply").code, 0);
  EXPECT_EQ(read_surface(path("a.ply")).points.size(), 42u);
}

TEST_F(Spin, output_has_quality_rho_and_lambda)
{
  write("a.off", off(cgp_test::icosphere(1)));
  ASSERT_EQ(run("spin a.off --rho-expression z --lambda spin -o b.ply").code, 0);
  const auto b = read_surface(path("b.ply"));
  for (const char* name : {"quality", "rho", "spin_w", "spin_x", "spin_y", "spin_z"})
    EXPECT_NE(find_property(b.vertices, name), nullptr) << name;
  EXPECT_GE(find_property(b.vertices, "quality")->value(0), 1);
}

TEST_F(Spin, mollify_takes_faces_of_area_zero_and_tells_what_it_did)
{
  const auto clean = cgp_test::icosphere(3), mesh = cgp_test::spoilt(clean);
  write("clean.off", off(clean));
  write("a.off", off(mesh));
  const std::string rho = " --rho-expression '0.7*sin(4*y)' -o ";
  EXPECT_TRUE(fails(run("spin a.off" + rho + "b.ply"), 4, "--mollify"));
  ASSERT_EQ(run("spin clean.off" + rho + "clean.ply").code, 0);
  const auto expected = read_surface(path("clean.ply"));
  for (const std::string option : {"--mollify", "--mollify=1e-5"}) {
    const Program_run r = run("spin " + option + " a.off" + rho + "b.ply --json b.json");
    ASSERT_EQ(r.code, 0) << r.err;
    EXPECT_NE(r.out.find("edges flipped"), std::string::npos) << r.out;
    const auto json = read_json("b.json");
    EXPECT_TRUE(json["verified"]);
    const auto made = json["result"]["mollification"];
    EXPECT_EQ(made["share"], option == "--mollify" ? 1e-6 : 1e-5);
    EXPECT_GT(made["thin_faces"], 100);
    EXPECT_EQ(made["longer_edges"], mesh.size_of_edges());
    EXPECT_GT(made["added_length"], 0);
    EXPECT_LT(made["added_length"], 1e-5);
    EXPECT_GT(made["flipped_edges"], 100);
    const auto b = read_surface(path("b.ply"));
    for (std::size_t v = 0; v < expected.points.size(); ++v)
      for (std::size_t i = 0; i < 3; ++i)  // the misfit at vertices is averaged over other faces
        EXPECT_NEAR(b.points[v][i], expected.points[v][i], 6e-3);
    const auto* quality = find_property(b.vertices, "quality");
    for (std::size_t v = 0; v < b.points.size(); ++v) EXPECT_GE(quality->value(v), 1);
  }
}

TEST_F(Spin, mollify_changes_nothing_where_there_is_nothing_to_be_changed)
{
  write("a.off", off(cgp_test::bumpy_sphere(2)));
  ASSERT_EQ(run("spin a.off --rho-expression 'x*y' -o b.ply").code, 0);
  ASSERT_EQ(run("spin a.off --rho-expression 'x*y' --mollify -o c.ply --json c.json").code, 0);
  const auto made = read_json("c.json")["result"]["mollification"];
  for (const char* name : {"thin_faces", "longer_edges", "added_length", "flipped_edges"})
    EXPECT_EQ(made[name], 0) << name;
  const auto b = read_surface(path("b.ply")), c = read_surface(path("c.ply"));
  for (std::size_t v = 0; v < b.points.size(); ++v)
    EXPECT_NEAR(b.points[v][0], c.points[v][0], 1e-7);
}

TEST_F(Spin, mollify_refuses_numbers_that_it_cannot_use_and_takes_every_solver)
{
  write("a.off", off(cgp_test::icosphere(1)));
  const std::string spin = "spin a.off --rho-expression x -o b.ply --mollify";
  for (const std::string number : {"=1", "=-1", "=x", "=nan"})
    EXPECT_TRUE(fails(run(spin + number), 2, "between 0 and 1")) << number;
  const Program_run by_eigen = run(spin + " --advanced solver=eigen");
  EXPECT_EQ(by_eigen.code, 0) << by_eigen.err;
}

TEST_F(Spin, mollify_is_what_to_try_where_it_was_not_tried)
{
  write("a.off", off(cgp_test::bumpy_sphere(2)));
  const std::string spin = "spin a.off --rho-expression x --limit quasi_conformal=1.0001 -o b.ply";
  EXPECT_TRUE(fails(run(spin + " --mollify=0"), 1,
                    "try: a weaker rho, --mollify for thin faces, a finer mesh"));
  for (const std::string option : {"", " --mollify", " --advanced solver=eigen"})
    EXPECT_TRUE(fails(run(spin + option), 1, "try: a weaker rho, a finer mesh"));
}

TEST_F(Spin, of_slivers_is_mollified_and_says_so)
{
  const auto clean = cgp_test::icosphere(3);
  write("clean.off", off(clean));
  const std::string rho = " --rho-expression '0.7*sin(4*y)' -o ";
  ASSERT_EQ(run("spin clean.off" + rho + "clean.ply --json clean.json").code, 0);
  const auto unspoilt = read_json("clean.json");
  EXPECT_FALSE(unspoilt["result"].contains("mollification"));
  EXPECT_TRUE(unspoilt["notes"].empty());
  const auto expected = read_surface(path("clean.ply"));
  // A certificate that does not hold; and a matrix that is not definite.
  for (const double height : {1e-5, 1e-9}) {
    write("a.off", off(cgp_test::with_thin_faces(clean, height, .5, 2)));
    EXPECT_EQ(run("spin --mollify=0 a.off" + rho + "b.ply").code, 1) << height;
    EXPECT_FALSE(has("b.ply"));
    const Program_run r = run("spin a.off" + rho + "b.ply --json b.json");
    ASSERT_EQ(r.code, 0) << r.err;
    EXPECT_NE(r.err.find("solved as with --mollify: without, "), std::string::npos) << r.err;
    EXPECT_EQ(r.err.find("try"), std::string::npos) << r.err;
    const auto json = read_json("b.json");
    EXPECT_TRUE(json["verified"]);
    EXPECT_EQ(json["notes"].size(), 1);
    EXPECT_EQ(json["result"]["mollification"]["share"], 1e-6);
    const auto b = read_surface(path("b.ply"));
    for (std::size_t v = 0; v < expected.points.size(); ++v)
      for (std::size_t i = 0; i < 3; ++i)  // the misfit at vertices is averaged over other faces
        EXPECT_NEAR(b.points[v][i], expected.points[v][i], 6e-3);
    std::filesystem::remove(path("b.ply"));
  }
}

// A spike is thin and has much of the area: it is measured, for to leave it out would be a lie.
TEST_F(Spin, mollify_measures_thin_faces_that_are_large)
{
  const auto sphere = cgp_test::icosphere(1);
  Conformal_geometry_processing::Points p = sphere.positions();
  p.col(0) *= 40;
  write("a.off", off({p, sphere.corners()}));
  const std::string spin =
      "spin a.off --rho-expression '2*x' --mollify --max-scale none "
      "-o b.ply --json b.json ";
  EXPECT_TRUE(fails(run(spin), 1, "the mean quasi-conformal error is"));
  EXPECT_EQ(run(spin + "--force").code, 0);
  const auto result = read_json("b.json")["result"];
  EXPECT_GE(result["mollification"]["measured_area"], .95);
  EXPECT_GE(result["mollification"]["measured_faces"], 79);
  ASSERT_EQ(run("compare a.off b.ply --json c.json").code, 0);
  const auto found = read_json("c.json")["result"];
  const double told = result["quasi_conformal"]["mean"], mean = found["quasi_conformal"]["mean"];
  EXPECT_NEAR(told, mean, .05 * mean);
}

TEST_F(Spin, mollify_wants_some_area)
{
  const auto mesh = cgp_test::icosahedron();
  write("a.off", off(cgp_test::mapped(
                     mesh, [](const Eigen::Vector3d& p) { return Eigen::Vector3d(p.x(), 0, 0); })));
  EXPECT_TRUE(
      fails(run("spin --mollify a.off --rho-expression x -o b.ply"), 4, "no face has an area"));
}

TEST_F(Spin, unreferenced_vertices_stay_where_they_are)
{
  write("a.off", off(cgp_test::icosphere(1), "7 8 9\n", 1));
  const Program_run r = run("spin a.off --rho-expression x -o b.ply");
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_NE(r.err.find("1 vertex without a face"), std::string::npos) << r.err;
  const auto b = read_surface(path("b.ply"));
  EXPECT_EQ(b.points.size(), 43u);
  EXPECT_EQ(b.points[0], (conformal::Point{7, 8, 9}));
}

TEST_F(Spin, surface_inside_out_gives_the_same_points_and_keeps_its_faces)
{
  const auto mesh = cgp_test::icosphere(2);
  write("a.off", off(mesh));
  write("inside.off", off(cgp_test::with_reversed_faces(mesh)));
  ASSERT_EQ(run("spin a.off --rho-expression x -o b.ply").code, 0);
  const Program_run r = run("spin inside.off --rho-expression x -o c.ply");
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_NE(r.err.find("inside out"), std::string::npos);
  const auto b = read_surface(path("b.ply")), c = read_surface(path("c.ply"));
  EXPECT_EQ(read_surface(path("inside.off")).polygons.corners, c.polygons.corners);
  for (std::size_t v = 0; v < b.points.size(); ++v)
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(b.points[v][i], c.points[v][i], 1e-6);
}

TEST_F(Spin, result_that_does_not_verify_is_written_only_by_force)
{
  write("a.off", off(cgp_test::icosphere(2)));
  const std::string spin =
      "spin -q a.off --rho-expression 'x*y' -o b.ply --json b.json --limit quasi_conformal=1.0001";
  EXPECT_TRUE(fails(run(spin), 1, "mean quasi-conformal error is"));
  EXPECT_FALSE(has("b.ply"));
  const auto json = read_json("b.json");
  EXPECT_FALSE(json["verified"]);
  EXPECT_TRUE(json["error"].is_string());
  EXPECT_EQ(run(spin + " --force").code, 0);
  EXPECT_TRUE(has("b.ply"));
  EXPECT_TRUE(fails(run("spin -q a.off --rho-expression 'x*y' -o c.ply --limit closure=1e-9"), 1,
                    "does not close up"));
  EXPECT_TRUE(fails(run("spin -q a.off --rho-expression 'x*y' -o c.ply --advanced tolerance=1e-30 "
                        "--max-scale none"),
                    1, "did not converge"));
}

TEST_F(Spin, every_format_is_written)
{
  write("a.off", off(cgp_test::icosphere(1)));
  for (const std::string name : {"b.ply", "b.off", "b.obj", "b.glb"})
    EXPECT_EQ(run("spin a.off --rho-expression x -o " + name).code, 0) << name;
}

}  // namespace cgp_test::spin_tests
