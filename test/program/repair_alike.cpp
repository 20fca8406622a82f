// Tests examples/conformal/repair/repair_alike.cpp examples/conformal/input/same_faces.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/repair/repair_alike.h"

#include "conformal/process/Failure.h"
#include "program/bounded_support.h"
#include "program/repair_support.h"
#include "support/spheres.h"

namespace cgp_test::repair_alike_tests {

using namespace program_test;
using namespace conformal;

/// A disk whose first face is two with a cap at the third: a vertex on an edge, on one side only;
/// another vertex is there twice.
Faces faces_with_faults(const cgp_test::Mesh_view& mesh)
{
  Faces faces;
  for (const auto& v : mesh.corners()) faces.push_back({v[0], v[1], v[2]});
  const int n = mesh.size_of_vertices(), a = faces[0][0], b = faces[0][1], c = faces[0][2];
  faces[0] = {a, n, c};
  faces.push_back({n, b, c});
  faces.push_back({a, b, n});
  faces[20][0] = n + 1;
  return faces;
}

std::vector<Point> points_with_faults(const cgp_test::Mesh_view& mesh)
{
  std::vector<Point> points;
  const auto add = [&](const Eigen::Vector3d& p) { points.push_back({p.x(), p.y(), p.z()}); };
  for (int v = 0; v < mesh.size_of_vertices(); ++v) add(mesh.position(v));
  const auto& face = mesh.corners(0);
  add((mesh.position(face[0]) + mesh.position(face[1])) / 2);
  add(mesh.position(mesh.corners(20)[0]));
  return points;
}

const std::vector<Point> cap = {{0, 0, 0}, {4, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, -1, 0}};
const Faces faces_at_cap = {{0, 1, 3}, {1, 0, 2}, {2, 0, 4}, {1, 2, 4}};

Surface_file alike(const std::vector<Point>& first, const std::vector<Point>& second,
                   const Faces& faces)
{
  Surface_file a = parse_surface(off_of(first, faces), "a.off");
  Surface_file b = parse_surface(off_of(second, faces), "b.off");
  const Repair done = repair(a);
  EXPECT_TRUE(done.has_changed_anything());
  repair_alike(b, done);
  EXPECT_EQ(b.polygons.corners, a.polygons.corners);
  return b;
}

/// Two surfaces with the same faults in their faces, and the same without.
class Repaired_alike : public Bounded_program {
 protected:
  Repaired_alike() : m_a(cgp_test::disk(6)), m_b(m_a)
  {
    Points p = m_a.positions();
    for (Eigen::Index v = 0; v < p.cols(); ++v) {
      p(2, v) = 0.2 * p(0, v) * p(0, v);
      p(1, v) *= 1.05;
    }
    m_b.set_positions(p);
    const Faces faces = faces_with_faults(m_a);
    write("a.off", off_of(points_with_faults(m_a), faces));
    write("b.off", off_of(points_with_faults(m_b), faces));
  }

  /// Checks exit codes and messages without and with --repair
  void expect_works_with_repair(const std::string& command)
  {
    EXPECT_EQ(run(command + " -o c.ply").code, 4);
    EXPECT_FALSE(has("c.ply"));
    const Program_run r = run(command + " --repair -o c.ply --json c.json");
    ASSERT_EQ(r.code, 0) << r.err;
    const auto repair = json("c.json")["input"]["repair"];
    EXPECT_EQ(repair["flipped_edges"], 1);
    EXPECT_EQ(repair["merged_points"], 1);
    EXPECT_EQ(points("c.ply").cols(), m_a.size_of_vertices() + 1);
    std::filesystem::remove(path("c.ply"));
    for (const char* words : {"1 edge flipped", "1 vertex merged"})
      EXPECT_NE(r.err.find(words), std::string::npos) << r.err;
  }

  cgp_test::Mesh_view m_a, m_b;
};

TEST(Repair_alike, splits_the_same_face)
{
  std::vector<Point> bent = cap;
  bent[2] = {1, 0, 0.5};
  const Surface_file b = alike(cap, bent, faces_at_cap);
  EXPECT_EQ(b.points, bent);
  EXPECT_EQ(faces_of(b), (Faces{{3, 0, 2}, {2, 1, 3}, {2, 0, 4}, {1, 2, 4}}));
}

TEST(Repair_alike, merges_the_same_vertices_if_they_are_together)
{
  const Faces faces = {{0, 1, 2}, {4, 3, 2}};
  const std::vector<Point> a = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 0}};
  std::vector<Point> b = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}};
  EXPECT_EQ(alike(a, b, faces).points, std::vector<Point>(b.begin(), b.end() - 1));
  b[4][2] = 2;
  EXPECT_THROW(alike(a, b, faces), Failure);
  std::vector<Point> with_far_vertex = a;
  with_far_vertex.push_back({0, 0, 1});
  b.push_back({0, 0, 1e9});
  EXPECT_THROW(alike(with_far_vertex, b, faces), Failure);
}

TEST(Repair_alike, removes_the_same_triangle_if_it_is_flat)
{
  const Faces faces(faces_at_cap.begin() + 1, faces_at_cap.end());
  EXPECT_EQ(alike(cap, cap, faces).polygons.size(), 2u);
  std::vector<Point> bent = cap;
  bent[2][2] = 0.5;
  EXPECT_THROW(alike(cap, bent, faces), Failure);
}

TEST_F(Repaired_alike, boundary_takes_directions_from_a_surface_repaired_alike)
{
  expect_works_with_repair("boundary a.off --binormals-from b.off");
  expect_works_with_repair("boundary a.off --positions-from b.off");
}

TEST_F(Repaired_alike, fit_has_a_target_repaired_alike)
{
  expect_works_with_repair("fit a.off b.off");
  const Program_run r = run("fit a.off b.off --repair -o c.ply");
  EXPECT_NE(r.err.find("b.off: repaired like a.off"), std::string::npos) << r.err;
}

TEST_F(Repaired_alike, blend_goes_between_and_onto_surfaces_repaired_alike)
{
  expect_works_with_repair("blend a.off b.off --onto a.off --t 0.5");
}

TEST_F(Repaired_alike, refuses_a_second_surface_that_would_lose_something)
{
  std::vector<Point> torn = points_with_faults(m_b);
  torn.back()[2] += 0.1;
  write("torn.off", off_of(torn, faces_with_faults(m_a)));
  EXPECT_TRUE(fails(run("fit a.off torn.off --repair -o c.ply"), 4,
                    "torn.off: vertices " + std::to_string(m_a.corners(20)[0]) + " and " +
                        std::to_string(m_a.size_of_vertices() + 1) +
                        " are one since a.off was repaired, but lie apart here"));
  EXPECT_FALSE(has("c.ply"));
  write("other.off", off(m_a));
  EXPECT_TRUE(fails(run("fit a.off other.off --repair -o c.ply"), 4, "has not the faces of a.off"));
}

TEST_F(Repaired_alike, a_sound_surface_leaves_the_second_as_it_is)
{
  write("a.off", off(m_a));
  write("b.off", off(m_b));
  const Program_run plain = run("fit a.off b.off -o c.ply");
  const Program_run repaired = run("fit a.off b.off --repair -o d.ply");
  ASSERT_EQ(plain.code, 0) << plain.err;
  EXPECT_EQ(repaired.err, plain.err);
  EXPECT_EQ(content(path("c.ply")), content(path("d.ply")));
}

}  // namespace cgp_test::repair_alike_tests
