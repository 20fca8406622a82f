// Tests examples/conformal/commands/blend.cpp examples/conformal/commands/option_groups.cpp
// Tests examples/conformal/transform/write_result.cpp examples/conformal/transform/deform.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "program/bounded_support.h"
#include "support/moebius.h"
#include "support/spheres.h"

#include <Eigen/Geometry>

#include <complex>

namespace cgp_test::blend_tests {

using namespace program_test;
using cgp_test::bumpy_sphere;
using cgp_test::Mesh_view;

/// root mean square distance after the best similarity, by the diagonal of the second
double distance(const Points& p, const Points& q)
{
  const Eigen::Matrix4d T = Eigen::umeyama(p, q, true);
  const Points moved = (T.topLeftCorner<3, 3>() * p).colwise() + T.topRightCorner<3, 1>();
  const double diagonal = (q.rowwise().maxCoeff() - q.rowwise().minCoeff()).norm();
  return (moved - q).norm() / std::sqrt(double(p.cols())) / diagonal;
}

class Blend : public Bounded_program {
 protected:
  Blend() : m_a(bumpy_sphere(3)), m_b(cgp_test::inverted(m_a, Eigen::Vector3d(0.5, 0.4, 4)))
  {
    write("a.off", off(m_a));
    write("b.off", off(m_b));
  }

  Mesh_view m_a, m_b;
};

TEST_F(Blend, begins_at_one_surface_and_arrives_at_the_other)
{
  const Program_run r = run("blend a.off b.off --t 1 -o c.ply --json c.json");
  ASSERT_EQ(r.code, 0) << r.err;
  const auto report = json("c.json");
  EXPECT_LT(distance(points("c.ply"), m_b.positions()), 2e-4);
  EXPECT_NEAR(report["steps"][0]["distance"], distance(points("c.ply"), m_b.positions()), 1e-10);
  EXPECT_LT(report["result"]["quasi_conformal"]["mean"], 1.05);
  EXPECT_LT(report["result"]["pair"]["quasi_conformal"]["mean"], 1.05);
  const auto c = conformal::read_surface(path("c.ply"));
  EXPECT_NE(find_property(c.vertices, "quality"), nullptr);
  EXPECT_NE(find_property(c.faces, "rho"), nullptr);
  ASSERT_EQ(run("blend a.off b.off --t 1 --keep-curvature -o c.ply --json c.json").code, 0);
  EXPECT_LT(json("c.json")["steps"][0]["distance"], .005);
  EXPECT_GT(json("c.json")["steps"][0]["distance"], 10 * double(report["steps"][0]["distance"]));
  ASSERT_EQ(run("blend a.off b.off --t 0 -o c.ply").code, 0);
  EXPECT_LT((points("c.ply") - m_a.positions()).cwiseAbs().maxCoeff(), 1e-6);
}

TEST_F(Blend, writes_frames_at_even_steps_also_beyond)
{
  const Program_run r =
      run("blend a.off b.off --from -0.5 --t 1.5 --frames 5 -o c.ply --json c.json");
  ASSERT_EQ(r.code, 0) << r.err;
  const auto steps = json("c.json")["steps"];
  ASSERT_EQ(steps.size(), 5u);
  for (std::size_t k = 0; k < 5; ++k) {
    const std::string name = "c_000" + std::to_string(k) + ".ply";
    ASSERT_TRUE(has(name));
    EXPECT_NEAR(steps[k]["t"], -0.5 + 0.5 * double(k), 1e-15);
    EXPECT_LT(steps[k]["quasi_conformal"]["mean"], 1.08) << k;
    EXPECT_NEAR(steps[k]["distance"], distance(points(name), m_b.positions()), 1e-10);
  }
  EXPECT_FALSE(has("c_0005.ply"));
  EXPECT_EQ(content(path("c.ply")), content(path("c_0004.ply")));
  EXPECT_LT(distance(points("c_0001.ply"), m_a.positions()), 1e-6);
  EXPECT_GT(steps[4]["distance"], steps[3]["distance"]);
  EXPECT_NE(r.out.find("energy/4pi"), std::string::npos);
}

TEST_F(Blend, takes_a_difference_away_from_another_surface)
{
  ASSERT_EQ(run("blend a.off b.off --onto b.off --t -1 -o c.ply").code, 0);
  EXPECT_LT(distance(points("c.ply"), m_a.positions()), 0.005);
  EXPECT_EQ(conformal::read_surface(path("c.ply")).points.size(), m_a.positions().cols());
}

TEST_F(Blend, turns_the_binormals_at_a_boundary)
{
  const Mesh_view disk = cgp_test::disk(16);
  const Mesh_view image = cgp_test::mapped(disk, [](const Eigen::Vector3d& p) {
    const std::complex<double> z(p.x(), p.y()), w = z + 0.2 * z * z;
    return Eigen::Vector3d(w.real(), w.imag(), 0);
  });
  const Mesh_view cap = cgp_test::cap_from_disk(disk, 1.2);
  write("disk.off", off(disk));
  write("image.off", off(image));
  write("cap.off", off(cap));
  const auto goes = [&](const std::string& from, const std::string& to, double limit) {
    const Program_run r = run("blend " + from + " " + to + " --t 1 -o c.ply --json c.json");
    ASSERT_EQ(r.code, 0) << r.err;
    EXPECT_LT(json("c.json")["steps"][0]["distance"], limit) << from << to;
    EXPECT_EQ(json("c.json")["result"]["boundary"]["condition"], "binormals prescribed");
  };
  goes("disk.off", "image.off", 3e-3);
  goes("image.off", "cap.off", 3e-3);
  ASSERT_EQ(run("blend disk.off cap.off --t 0.5 -o c.ply --json c.json").code, 0);
  EXPECT_LT(json("c.json")["result"]["quasi_conformal"]["mean"], 1.03);
}

TEST_F(Blend, tells_where_surfaces_are_not_conformally_equivalent)
{
  Points stretched = m_a.positions();
  stretched.row(2) *= 2;
  write("s.off", off({stretched, m_a.corners()}));
  const Program_run r = run("blend a.off s.off --t 0.5 -o c.ply --json c.json");
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_NE(r.err.find("s.off is not a conformal image of a.off"), std::string::npos);
  EXPECT_GT(json("c.json")["result"]["pair"]["quasi_conformal"]["mean"], 1.25);
}

TEST_F(Blend, writes_nothing_unless_every_frame_verifies)
{
  const std::string blend =
      "blend -q a.off b.off --t 1 --frames 3 -o c.ply --json c.json --limit quasi_conformal=1.01";
  EXPECT_TRUE(fails(run(blend), 1, "t = 0.5: the mean quasi-conformal error"));
  for (const char* name : {"c.ply", "c_0000.ply", "c_0001.ply"}) EXPECT_FALSE(has(name));
  EXPECT_FALSE(json("c.json")["verified"]);
  EXPECT_EQ(run(blend + " --force").code, 0);
  EXPECT_TRUE(has("c_0002.ply"));
  EXPECT_EQ(temporary_files(), 0u);
}

TEST_F(Blend, refuses_what_does_not_fit)
{
  write("other.off", off(cgp_test::icosphere(2)));
  write("c_0001.off", off(m_a));
  const std::string blend = "blend -q a.off -o c.off ";
  EXPECT_TRUE(fails(run(blend + "other.off"), 4, "other.off: has not the faces of a.off"));
  EXPECT_TRUE(fails(run(blend + "b.off --onto other.off"), 4, "other.off: has not the faces"));
  EXPECT_TRUE(
      fails(run(blend + "c_0001.off --frames 3"), 2, "frame 1 would be written over c_0001.off"));
  EXPECT_EQ(run(blend + "b.off --frames 1").code, 2);
  EXPECT_EQ(run(blend + "b.off --from 1").code, 2);
  EXPECT_FALSE(has("c.off"));
}

}  // namespace cgp_test::blend_tests
