// Tests examples/conformal/commands/fit.cpp
// Tests examples/conformal/input/same_faces.cpp examples/conformal/transform/deform.cpp
// Tests examples/conformal/commands/option_groups.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests examples/conformal/input/boundary_condition.cpp
#include "program/bounded_support.h"
#include "support/bends.h"
#include "support/moebius.h"
#include "support/spheres.h"
#include "support/thin_faces.h"
#include "support/tori.h"

namespace cgp_test::fit_tests {

using namespace program_test;
using Fit = Bounded_program;

double mean_error(const nlohmann::json& report)
{
  return report["result"]["quasi_conformal"]["mean"];
}

TEST_F(Fit, takes_the_shear_out_of_a_bend)
{
  const auto beam = cgp_test::beam(4);
  write("a.off", off(beam));
  write("t.off", off(cgp_test::bent_beam(beam, cgp_test::pi / 2)));
  const Program_run r = run("fit a.off t.off --keep-curvature -o b.ply --json b.json --lambda q");
  ASSERT_EQ(r.code, 0) << r.err;
  const auto report = json("b.json");
  const double of_target = report["result"]["target"]["quasi_conformal"]["mean"];
  EXPECT_GT(of_target, 1.08);
  EXPECT_LT(mean_error(report) - 1, (of_target - 1) / 4);
  EXPECT_EQ(report["result"]["target"]["sign_conflicts"], 0);
  EXPECT_TRUE(report["verified"]);
  EXPECT_NE(r.out.find("quasi-conformal error of the target, mean"), std::string::npos);
  const auto b = conformal::read_surface(path("b.ply"));
  for (const char* name : {"quality", "q_w", "q_z"})
    EXPECT_NE(find_property(b.vertices, name), nullptr) << name;
  EXPECT_NE(find_property(b.faces, "rho"), nullptr);
}

TEST_F(Fit, keeps_handles_closed_and_takes_faces_of_area_zero_with_mollify)
{
  const auto thicker = [](const Eigen::Vector3d& p) {  // the tube, on one side
    const double r = std::hypot(p.x(), p.y());
    const Eigen::Vector3d centre(3 * p.x() / r, 3 * p.y() / r, 0);
    return Eigen::Vector3d(centre + (1 + .7 * std::exp((p.x() / r - 1) * 2)) * (p - centre));
  };
  const auto clean = cgp_test::torus(3, 1, 48, 24), thin = cgp_test::with_thin_faces(clean, 0);
  for (const auto& mesh : {clean, thin}) {
    write("a.off", off(mesh));
    write("t.off", off(cgp_test::mapped(mesh, thicker)));
    const Program_run r = run("fit a.off t.off --keep-curvature --mollify -o b.ply --json b.json");
    ASSERT_EQ(r.code, 0) << r.err;
    const auto report = json("b.json");
    EXPECT_TRUE(report["verified"]);
    EXPECT_LT(report["result"]["closure_residual"], .01);
    EXPECT_LT(mean_error(report), 1.03);
  }
  EXPECT_TRUE(fails(run("fit a.off t.off -o b.ply"), 4, "area zero"));
  ASSERT_EQ(run("fit a.off a.off --mollify -o b.ply --json b.json").code, 0);
  EXPECT_LT(mean_error(json("b.json")), 1.001);
}

TEST_F(Fit, of_a_conformal_target_is_the_target)
{
  const auto mesh = cgp_test::bumpy_sphere(3);
  const auto target = cgp_test::inverted(mesh, Eigen::Vector3d(0.4, 0.3, 2.5));
  write("a.off", off(mesh));
  write("t.off", off(target));
  ASSERT_EQ(run("fit a.off t.off -o b.ply --json b.json").code, 0);
  const Points difference = points("b.ply") - target.positions();
  const double diagonal =
      (target.positions().rowwise().maxCoeff() - target.positions().rowwise().minCoeff()).norm();
  const double rms = difference.norm() / std::sqrt(double(difference.cols())) / diagonal;
  EXPECT_LT(rms, 0.003);
  const auto distance = json("b.json")["result"]["distance"];
  EXPECT_NEAR(distance["rms"], rms, .2 * rms);  // which weighs vertices by their areas
  EXPECT_LT(double(distance["rms"]), .1 * double(distance["source"]));
}

TEST_F(Fit, comes_nearer_than_the_curvature_and_keeps_to_a_bound)
{
  const auto beam = cgp_test::beam(3);
  write("a.off", off(beam));
  write("t.off", off(cgp_test::bent_beam(beam, cgp_test::pi / 3)));
  const auto distance = [&](const std::string& options) -> double {
    EXPECT_EQ(run("fit a.off t.off -o b.ply --json b.json " + options).code, 0) << options;
    return json("b.json")["result"]["distance"]["rms"];
  };
  const double kept = distance("--keep-curvature"), nearest = distance("");
  const double source = json("b.json")["result"]["distance"]["source"];
  EXPECT_LT(nearest, kept);
  EXPECT_LT(nearest, source / 2);
  const double normals = json("b.json")["result"]["distance"]["normals"];
  (void)distance("--max-scale 1.02");  // positions alone may come nearer, by shear
  EXPECT_GT(double(json("b.json")["result"]["distance"]["normals"]), normals);
  EXPECT_EQ(run("fit a.off t.off -o b.ply --max-scale -1").code, 2);
}

TEST_F(Fit, blends_towards_the_target)
{
  const auto beam = cgp_test::beam(3);
  write("a.off", off(beam));
  write("t.off", off(cgp_test::bent_beam(beam, 2)));
  double error = 1, distance = 1;
  for (const std::string t : {"0", "0.5", "1"}) {
    ASSERT_EQ(run("fit a.off t.off --keep-curvature -o b.ply --json b.json --blend " + t).code, 0);
    EXPECT_GT(mean_error(json("b.json")), error) << t;
    EXPECT_LT(json("b.json")["result"]["distance"]["rms"], distance) << t;
    error = mean_error(json("b.json"));
    distance = json("b.json")["result"]["distance"]["rms"];
    EXPECT_GT(json("b.json")["result"]["iterations"], 0);
  }
}

TEST_F(Fit, scales_what_it_blends_in_as_a_formula_says)
{
  write("a.off", off(cgp_test::icosphere(2)));
  const std::string fit = "fit a.off a.off -o b.ply --blend 0.5 --scale-expression ";
  ASSERT_EQ(run(fit + "'exp(0.8*z)'").code, 0);
  // Where lengths are to grow towards +z, they do.
  const Points a = cgp_test::icosphere(2).positions(), b = points("b.ply");
  Eigen::Index top, bottom;
  a.row(2).maxCoeff(&top);
  a.row(2).minCoeff(&bottom);
  const auto shortest = [](Points p, Eigen::Index v) {
    const Eigen::Vector3d center = p.col(v);
    p.colwise() -= center;
    p.col(v).setConstant(1e9);
    return p.colwise().norm().minCoeff();
  };
  EXPECT_GT(shortest(b, top) / shortest(a, top), 1.2 * shortest(b, bottom) / shortest(a, bottom));
  EXPECT_TRUE(fails(run(fit + "z"), 4, "wanted finite numbers above 0"));
  EXPECT_TRUE(fails(run(fit + "'exp('"), 2, "--scale-expression"));
  EXPECT_TRUE(fails(run("fit a.off a.off -o b.ply --scale-expression 2"), 2, "--blend"));
}

TEST_F(Fit, gives_a_boundary_the_directions_of_the_target)
{
  const auto mesh = cgp_test::disk(10);
  const auto cap = cgp_test::cap_from_disk(mesh, 1.2);
  write("a.off", off(mesh));
  write("t.off", off(cap));
  for (const std::string what : {"tangents", "binormals"}) {
    ASSERT_EQ(run("fit a.off t.off -o b.ply --json b.json --boundary " + what).code, 0);
    const auto result = json("b.json")["result"];
    EXPECT_EQ(result["boundary"]["condition"], what + " prescribed");
    EXPECT_LT(result["distance"]["rms"], 3e-3) << what;
    EXPECT_LT(result["boundary"]["direction_error"]["mean"], 3) << what;
  }
}

TEST_F(Fit, refuses_targets_that_do_not_fit_and_names_the_element)
{
  const auto mesh = cgp_test::icosphere(1);
  write("a.off", off(mesh, "7 8 9\n", 1));
  write("other.off", off(cgp_test::icosphere(2)));
  write("turned.off", off(cgp_test::with_reversed_faces(mesh), "7 8 9\n", 1));
  Points flat = mesh.positions();
  flat.col(mesh.corners(3)[0]) = flat.col(mesh.corners(3)[1]);
  write("flat.off", off({flat, mesh.corners()}, "7 8 9\n", 1));
  const std::string fit = "fit -q -o b.ply a.off ";
  EXPECT_TRUE(fails(run(fit + "other.off"), 4, "other.off: has not the faces of a.off"));
  EXPECT_TRUE(fails(run(fit + "turned.off"), 4, "face 0 has the vertices"));
  EXPECT_TRUE(fails(run(fit + "flat.off"), 4, "flat.off: 2 faces of area zero (first: face"));
  EXPECT_TRUE(fails(run(fit + "absent.off"), 3, "absent.off"));
  EXPECT_EQ(run("fit a.off -o b.ply").code, 2);
  EXPECT_FALSE(has("b.ply"));
}

// The search goes on as long as its surfaces verify.
TEST_F(Fit, comes_as_near_as_the_limits_allow)
{
  const auto beam = cgp_test::beam(4);
  write("a.off", off(beam));
  write("t.off", off(cgp_test::bent_beam(beam, 2)));
  double distance = 1;
  for (const std::string limit : {"1.002", "1.02", "1.5"}) {
    const std::string fit = "fit -q a.off t.off -o b.ply --json b.json --limit quasi_conformal=";
    ASSERT_EQ(run(fit + limit).code, 0) << limit;
    EXPECT_LE(mean_error(json("b.json")), std::stod(limit));
    const double now = json("b.json")["result"]["distance"]["rms"];
    EXPECT_LT(now, distance) << limit << " " << mean_error(json("b.json"));
    distance = now;
  }
}

TEST_F(Fit, writes_what_does_not_verify_only_by_force)
{
  const auto beam = cgp_test::beam(2);
  write("a.off", off(beam));
  write("t.off", off(cgp_test::bent_beam(beam, 2)));
  const std::string fit =
      "fit -q a.off t.off -o b.ply --json b.json --keep-curvature --limit quasi_conformal=1.0001";
  EXPECT_TRUE(fails(run(fit), 1, "the mean quasi-conformal error is 1."));
  EXPECT_FALSE(has("b.ply"));
  EXPECT_FALSE(json("b.json")["verified"]);
  EXPECT_EQ(run(fit + " --force").code, 0);
  EXPECT_TRUE(has("b.ply"));
  EXPECT_EQ(temporary_files(), 0u);
}

}  // namespace cgp_test::fit_tests
