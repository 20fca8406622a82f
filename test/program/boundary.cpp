// Tests examples/conformal/commands/boundary.cpp examples/conformal/input/boundary_condition.cpp
// Tests examples/conformal/report/boundary_report.cpp examples/conformal/transform/deform.cpp
// Tests examples/conformal/input/same_faces.cpp examples/conformal/transform/suitable_surface.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "program/bounded_support.h"
#include "support/spheres.h"

#include <cmath>
#include <complex>

namespace cgp_test::boundary_tests {

using namespace program_test;
using cgp_test::disk;
using cgp_test::pi;
using Boundary = Bounded_program;

/// a holomorphic function on the unit disk without critical points
cgp_test::Mesh_view image_under_z_plus_square(const cgp_test::Mesh_view& mesh)
{
  return cgp_test::mapped(mesh, [](const Eigen::Vector3d& p) {
    const std::complex<double> z(p.x(), p.y()), w = z + 0.3 * z * z;
    return Eigen::Vector3d(w.real(), w.imag(), 0);
  });
}

double area(const cgp_test::Mesh_view& mesh, const Points& p)
{
  double sum = 0;
  for (int f = 0; f < mesh.size_of_faces(); ++f) sum += mesh.double_area_vector(f, p).norm() / 2;
  return sum;
}

TEST_F(Boundary, tangents_turned_by_a_constant_angle_turn_a_flat_disk)
{
  const auto mesh = disk(10);
  write("a.off", off(mesh));
  const Program_run r = run("boundary a.off --tangent-rotation 30 -o b.ply --json b.json");
  ASSERT_EQ(r.code, 0) << r.err;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(pi / 6, Eigen::Vector3d::UnitZ()).matrix();
  EXPECT_LT((points("b.ply") - turn * mesh.positions()).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_EQ(json("b.json")["result"]["boundary"]["condition"], "tangents prescribed");
  EXPECT_LT(json("b.json")["result"]["boundary"]["direction_error"]["max"], 1e-4);
  EXPECT_TRUE(json("b.json")["result"]["boundary"]["fault"].is_null());
  EXPECT_NE(r.out.find("directions missed by (degrees)"), std::string::npos) << r.out;
}

TEST_F(Boundary, tangents_of_a_conformal_image_give_that_image)
{
  const auto mesh = disk(16);
  const auto target = image_under_z_plus_square(mesh);
  write("a.off", off(mesh));
  write("t.off", off(target));
  for (const std::string what : {"tangents", "binormals"}) {
    const Program_run r = run("boundary a.off --" + what + "-from t.off -o b.ply --json b.json");
    ASSERT_EQ(r.code, 0) << r.err;
    const double scale = std::sqrt(area(mesh, target.positions()) / area(mesh, mesh.positions()));
    const Points difference = centred(scale * points("b.ply")) - centred(target.positions());
    EXPECT_LT(difference.norm() / std::sqrt(difference.cols()), 1e-3) << what;
    EXPECT_LT(json("b.json")["result"]["boundary"]["direction_error"]["max"], 1);
  }
}

TEST_F(Boundary, positions_are_met_exactly)
{
  const auto mesh = disk(12);
  const auto target = image_under_z_plus_square(mesh);
  write("a.off", off(mesh));
  write("t.off", off(target));
  const Program_run r = run("boundary a.off --positions-from t.off -o b.ply --json b.json");
  ASSERT_EQ(r.code, 0) << r.err;
  const Points b = points("b.ply");
  for (const int v : outer_ring(12)) EXPECT_LT((b.col(v) - target.position(v)).norm(), 1e-12) << v;
  EXPECT_LT((b - target.positions()).norm() / std::sqrt(b.cols()), 1e-3);
  EXPECT_LT(json("b.json")["result"]["quasi_conformal"]["mean"], 1.04);
}

TEST_F(Boundary, binormals_tilt_towards_the_normals)
{
  write("a.off", off(disk(10)));
  const Program_run r = run("boundary a.off --binormal-tilt '30*cos(6*pi*s)' -o b.ply");
  ASSERT_EQ(r.code, 0) << r.err;
  const Points b = points("b.ply");
  const auto ring = outer_ring(10);
  const double diameter = (b.col(ring[0]) - b.col(ring[30])).norm();
  // The surface rises where its binormals point upward, three times, and falls between.
  for (std::size_t k = 0; k < ring.size(); k += 10) {
    const double height = b(2, ring[k]) - b.row(2).mean();
    EXPECT_GT(height * (k % 20 == 0 ? 1 : -1), 0.05 * diameter) << k;
  }
}

TEST_F(Boundary, minimal_surface_has_no_mean_curvature)
{
  write("a.off", off(cgp_test::cap_from_disk(disk(16), pi / 3)));
  ASSERT_EQ(run("boundary a.off --tangent-rotation 0 --minimal -o b.ply").code, 0);
  run("info a.off --json a.json");
  run("info b.ply --json b.json");
  EXPECT_GT(json("a.json")["result"]["willmore_energy"], 2);
  EXPECT_LT(json("b.json")["result"]["willmore_energy"], 0.01);
}

TEST_F(Boundary, rho_is_in_the_output)
{
  write("a.off", off(disk(8)));
  ASSERT_EQ(run("boundary a.off --tangent-rotation 0 --rho-expression 'gauss(x,0.2)' "
                "--lambda q -o b.ply")
                .code,
            0);
  const auto b = conformal::read_surface(path("b.ply"));
  for (const char* name : {"rho", "quality", "q_w", "q_z"})
    EXPECT_NE(find_property(b.vertices, name), nullptr) << name;
  EXPECT_DOUBLE_EQ(find_property(b.vertices, "rho")->value(0), 1);
}

TEST_F(Boundary, what_no_surface_has_is_written_only_by_force)
{
  write("a.off", off(disk(10)));
  // The tangents of a disk turn once; turned back, they are all the same.
  const std::string constant = "boundary -q a.off --tangent-rotation -360*s -o b.ply --json b.json";
  EXPECT_TRUE(fails(run(constant), 1, "no surface conformally equivalent to this one"));
  EXPECT_TRUE(fails(run(constant), 1, "try: binormals instead of tangents"));
  EXPECT_FALSE(has("b.ply"));
  EXPECT_FALSE(json("b.json")["verified"]);
  EXPECT_TRUE(json("b.json")["result"]["boundary"]["fault"].is_string());
  EXPECT_EQ(run(constant + " --force").code, 0);
  EXPECT_TRUE(has("b.ply"));
}

TEST_F(Boundary, refusals_name_what_is_easier_than_what_was_asked_for)
{
  write("a.off", off(disk(10)));
  write("cap.off", off(cgp_test::cap_from_disk(disk(8), 1.5)));
  const std::string turned = " --tangent-rotation -360*s", tilted = " --binormal-tilt 0";
  EXPECT_TRUE(fails(run("boundary -q a.off -o b.ply" + turned), 1, "binormals instead of"));
  EXPECT_TRUE(fails(run("boundary -q a.off --minimal -o b.ply" + turned), 1,
                    "try: conformal flow --boundary tangents before"));
  EXPECT_TRUE(fails(run("boundary -q cap.off --minimal -o b.ply" + tilted), 1,
                    "try: conformal flow --boundary binormals before"));
}

TEST_F(Boundary, directions_that_are_missed_have_a_limit)
{
  write("a.off", off(disk(5)));
  const std::string tilt =
      "boundary a.off --binormal-tilt '20*cos(10*pi*s)' -o b.ply --json b.json";
  ASSERT_EQ(run(tilt).code, 0);
  const double missed = json("b.json")["result"]["boundary"]["direction_error"]["mean"];
  EXPECT_GT(missed, 1);  // five waves on thirty edges
  EXPECT_TRUE(
      fails(run(tilt + " -q --limit direction_error=1"), 1, "directions at the boundary are"));
  EXPECT_EQ(run(tilt + " -q --limit direction_error=1 --force").code, 0);
}

TEST_F(Boundary, binormals_do_not_realise_any_constant)
{
  write("a.off", off(disk(10)));
  const std::string tilt = "boundary a.off --binormal-tilt 30 -o b.ply -q --rho-expression 1";
  EXPECT_EQ(run(tilt).code, 0);
  EXPECT_TRUE(fails(run(tilt + " --limit gamma_radius=1"), 1, "gamma times the radius is"));
}

TEST_F(Boundary, positions_that_no_surface_has_are_told)
{
  const auto mesh = disk(10);
  write("a.off", off(mesh));
  write("ellipse.off", off(cgp_test::mapped(mesh, [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
          return {1.3 * p.x(), p.y(), 0};
        })));
  write("turned.off", off(cgp_test::mapped(mesh, [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
          return {0, 2 * p.x(), 2 * p.y()};
        })));
  const std::string words = "no conformal surface has these positions";
  const Program_run gives =
      run("boundary a.off --positions-from ellipse.off -o b.ply --json b.json");
  EXPECT_EQ(gives.code, 0);
  EXPECT_NE(gives.err.find(words), std::string::npos) << gives.err;
  const auto result = json("b.json")["result"];
  EXPECT_EQ(result["boundary"]["gives_way"]["quasi_conformal"], result["quasi_conformal"]["max"]);
  EXPECT_GT(result["quasi_conformal"]["max"], 1.3);  // the least of any map onto the ellipse
  const Program_run good = run("boundary a.off --positions-from turned.off -o b.ply");
  EXPECT_EQ(good.err.find(words), std::string::npos) << good.err;
}

TEST_F(Boundary, several_loops_are_told_apart)
{
  const auto mesh = cgp_test::annulus(0.4, 1, 60, 10);
  write("a.off", off(mesh));
  ASSERT_EQ(run("boundary -q a.off --tangent-rotation 20 -o b.ply").code, 0);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(pi / 9, Eigen::Vector3d::UnitZ()).matrix();
  EXPECT_LT((centred(points("b.ply")) - turn * centred(mesh.positions())).cwiseAbs().maxCoeff(),
            1e-6);
  // Waves on one loop reach the other one weakened.
  const auto waves = [&](const std::string& loop, int ring) {
    const Program_run r =
        run("boundary a.off --binormal-tilt 'loop == " + loop + " ? 8*sin(6*pi*s) : 0' -o c.ply");
    EXPECT_EQ(r.code, 0) << r.err;
    const Eigen::RowVectorXd z = points("c.ply").row(2).segment(60 * ring, 60);
    return (z.array() - z.mean()).matrix().norm();
  };
  EXPECT_GT(waves("0", 0), 2 * waves("0", 10));
  EXPECT_GT(waves("1", 10), 2 * waves("1", 0));
}

TEST_F(Boundary, closed_surfaces_are_refused_with_advice)
{
  write("a.off", off(cgp_test::icosphere(1)));
  EXPECT_TRUE(fails(run("boundary a.off --tangent-rotation 0 -o b.ply"), 4, "try: conformal spin"));
  for (const std::string command : {"spin a.off --rho-expression x", "flow a.off"})
    EXPECT_TRUE(
        fails(run(command + " --boundary tangents -o b.ply"), 4, "try: without --boundary"));
  EXPECT_FALSE(has("b.ply"));
}

TEST_F(Boundary, one_thing_is_prescribed_and_one_rho_at_most)
{
  write("a.off", off(disk(3)));
  const std::string boundary = "boundary a.off -o b.ply ";
  EXPECT_EQ(run(boundary).code, 2);
  EXPECT_EQ(run(boundary + "--tangent-rotation 0 --binormal-tilt 0").code, 2);
  EXPECT_EQ(run(boundary + "--tangent-rotation 0 --minimal --rho-expression x").code, 2);
  EXPECT_TRUE(fails(run(boundary + "--tangent-rotation 'sin('"), 2, "--tangent-rotation 'sin('"));
  EXPECT_TRUE(fails(run(boundary + "--binormal-tilt t"), 2, "nz, s, loop"));
}

TEST_F(Boundary, angle_that_is_no_number_names_the_vertex_of_the_file)
{
  write("a.off", off(disk(3), "7 8 9\n", 1));
  // In the file the outer ring begins with vertex 20.
  EXPECT_TRUE(fails(run("boundary -q a.off --binormal-tilt 1/s -o b.ply"), 4, "vertex 20,"));
}

TEST_F(Boundary, target_with_other_faces_is_refused)
{
  write("a.off", off(disk(3)));
  write("t.off", off(disk(4)));
  write("turned.off", off(cgp_test::with_reversed_faces(disk(3))));
  for (const std::string what : {"tangents", "binormals", "positions"})
    EXPECT_TRUE(fails(run("boundary a.off -o b.ply --" + what + "-from t.off"), 4,
                      "has not the faces of a.off: 61 vertices, wanted 37"));
  EXPECT_TRUE(fails(run("boundary a.off -o b.ply --tangents-from turned.off"), 4, "face 0"));
  EXPECT_TRUE(fails(run("boundary a.off -o b.ply --tangents-from absent.off"), 3, "absent.off"));
}

TEST_F(Boundary, target_that_is_folded_has_no_direction_there)
{
  const auto mesh = disk(2);
  auto folded = mesh.positions();
  folded.col(9) = folded.col(11);  // the vertices before and after vertex 10
  write("a.off", off(mesh));
  write("t.off", off({folded, mesh.corners()}));
  EXPECT_TRUE(fails(run("boundary a.off -o b.ply --tangents-from t.off"), 4, "at vertex 10,"));
}

}  // namespace cgp_test::boundary_tests
