// Tests examples/conformal/input/boundary_condition.cpp
// examples/conformal/transform/on_component.cpp Tests examples/conformal/commands/boundary.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "program/bounded_support.h"
#include "support/mesh_tools.h"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace cgp_test::boundary_positions_tests {

using namespace program_test;
using cgp_test::disk;
using cgp_test::Mesh_view;
using Curves_inside = Bounded_program;

constexpr int rings = 12;
/// in the user's frame, in which the disk has the radius 1 / sqrt(2): the circle of half of it
const std::string circle = " --curves-expression 'abs(x*x + y*y - .125) < .005'";

/// the disk with a circular ridge, its crest at about half the radius; the boundary stays
Mesh_view ridge(const Mesh_view& mesh)
{
  return cgp_test::mapped(mesh, [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    const double s = 1 - p.squaredNorm();
    return {p.x(), p.y(), .8 * s * s * p.squaredNorm()};
  });
}

/// 1 on the circle, and on the boundary, of disks whose vertices begin there
std::vector<int> marked(int size, const std::vector<int>& disks)
{
  std::vector<int> numbers(static_cast<std::size_t>(size));
  for (const int first : disks)
    for (const int k : {rings / 2, rings})
      for (const int v : outer_ring(k)) numbers[static_cast<std::size_t>(first + v)] = 1;
  return numbers;
}

/// with one number per vertex
std::string ply(const Mesh_view& mesh, const std::vector<int>& numbers)
{
  std::ostringstream out;
  out << "ply\nformat ascii 1.0\nelement vertex " << mesh.size_of_vertices()
      << "\nproperty double x\nproperty double y\nproperty double z\nproperty int crest\n"
      << "element face " << mesh.size_of_faces()
      << "\nproperty list uchar int vertex_indices\nend_header\n"
      << std::setprecision(17);
  for (int v = 0; v < mesh.size_of_vertices(); ++v)
    out << mesh.position(v).transpose() << ' ' << numbers[static_cast<std::size_t>(v)] << '\n';
  for (const auto& [i, j, k] : mesh.corners()) out << "3 " << i << ' ' << j << ' ' << k << '\n';
  return out.str();
}

TEST_F(Curves_inside, lie_where_those_of_the_target_do)
{
  const Mesh_view mesh = disk(rings), target = ridge(mesh);
  write("a.off", off(mesh));
  write("t.off", off(target));
  const Program_run r =
      run("boundary a.off --positions-from t.off -o b.ply --json b.json" + circle);
  ASSERT_EQ(r.code, 0) << r.err;
  const Points b = points("b.ply");
  for (const int k : {rings / 2, rings})
    for (const int v : outer_ring(k)) EXPECT_LT((b.col(v) - target.position(v)).norm(), 1e-12) << v;
  EXPECT_LT(read_json("b.json")["result"]["boundary"]["position_error"]["max"], 1e-12);
  // The boundary alone does not lift them there.
  ASSERT_EQ(run("boundary a.off --positions-from t.off -o c.ply").code, 0);
  const Points c = points("c.ply");
  for (const int v : outer_ring(rings / 2)) EXPECT_GT(target.position(v).z() - c(2, v), .02) << v;
}

TEST_F(Curves_inside, can_be_marked_by_a_property)
{
  const Mesh_view mesh = disk(rings);
  // That of the boundary has no effect.
  write("a.ply", ply(mesh, marked(mesh.size_of_vertices(), {0})));
  write("t.off", off(ridge(mesh)));
  const std::string common = "boundary a.ply --positions-from t.off";
  ASSERT_EQ(run(common + " -o b.ply --curves-property crest").code, 0);
  ASSERT_EQ(run(common + " -o c.ply" + circle).code, 0);
  EXPECT_EQ(points("b.ply"), points("c.ply"));
}

TEST_F(Curves_inside, belong_to_their_components)
{
  const Mesh_view mesh = disk(rings), target = ridge(mesh);
  const Eigen::Vector3d away(5, 0, 0);
  const int size = mesh.size_of_vertices();
  write("a.ply", ply(cgp_test::disjoint_union(mesh, mesh, away), marked(2 * size, {size})));
  write("t.off", off(cgp_test::disjoint_union(mesh, target, away)));
  const Program_run r =
      run("boundary a.ply --each-component --positions-from t.off -o b.ply "
          "--curves-property crest");
  ASSERT_EQ(r.code, 0) << r.err;
  const Points b = points("b.ply");
  for (const int v : outer_ring(rings / 2)) {
    EXPECT_LT(std::abs(b(2, v)), 1e-12) << v;
    EXPECT_LT((b.col(size + v) - away - target.position(v)).norm(), 1e-12) << v;
  }
}

TEST_F(Curves_inside, that_are_not_closed_are_refused_by_the_vertex_of_the_file)
{
  write("a.off", off(disk(rings), "7 8 9\n", 1));  // an unreferenced vertex comes first
  write("t.off", off(ridge(disk(rings)), "7 8 9\n", 1));
  const std::string common = "boundary -q a.off --positions-from t.off -o b.ply ";
  const int first = outer_ring(rings / 2)[0] + 1;
  EXPECT_TRUE(fails(run(common + "--curves-expression 'y > -.01 && abs(x*x+y*y-.125) < .005'"), 4,
                    "vertex " + std::to_string(first)));
  EXPECT_TRUE(fails(run(common + "--curves-expression -1"), 4, "no vertex inside is on a curve"));
  EXPECT_FALSE(has("b.ply"));
}

TEST_F(Curves_inside, want_positions)
{
  write("a.off", off(disk(3)));
  EXPECT_TRUE(
      fails(run("boundary a.off --tangent-rotation 0 -o b.ply" + circle), 2, "--positions-from"));
}

}  // namespace cgp_test::boundary_positions_tests
