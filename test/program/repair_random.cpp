// Tests examples/conformal/repair/repair.cpp examples/conformal/repair/mend_flat_faces.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/input/Defects.h"
#include "program/repair_support.h"
#include "support/bounded_meshes.h"
#include "support/spheres.h"

#include <Conformal_geometry_processing/mesh/topology.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace cgp_test::repair_random_tests {

using namespace program_test;
using namespace conformal;

/// A mesh to which all is done that files suffer from.
class Tortured_mesh {
 public:
  Tortured_mesh(const CGP::Mesh_view& mesh, unsigned seed) : m_random(seed)
  {
    for (int v = 0; v < mesh.size_of_vertices(); ++v) {
      const Eigen::Vector3d p = mesh.position(v);
      m_points.push_back({p.x(), p.y(), p.z()});
    }
    for (const auto& v : mesh.corners()) m_faces.push_back({v[0], v[1], v[2]});
  }

  void torture(int times)
  {
    for (int i = 0; i < times; ++i) switch (number(9)) {
        case 0:
          give_a_corner_its_own_point();
          break;
        case 1:
          m_faces.push_back(any_face());
          break;
        case 2:
          std::swap(any_face()[0], any_face()[1]);
          break;
        case 3:
        case 4:
        case 5:
          split_an_edge_on_one_side();
          break;
        case 6:
          split_a_face_next_to_a_corner();
          break;
        case 7:
          m_points.push_back({1. * i, 2. * i, 3.});
          break;
        case 8:
          m_faces.push_back({any_vertex(), any_vertex(), any_vertex()});
      }
    for (auto& face : m_faces) std::rotate(face.begin(), face.begin() + number(3), face.end());
    std::shuffle(m_faces.begin(), m_faces.end(), m_random);
    m_faces.erase(
        std::remove_if(m_faces.begin(), m_faces.end(),
                       [](const auto& f) { return std::set(f.begin(), f.end()).size() < 3; }),
        m_faces.end());
  }

  Surface_file file() const { return parse_surface(off_of(m_points, m_faces), "tortured.off"); }

 private:
  int number(int n) { return std::uniform_int_distribution<int>(0, n - 1)(m_random); }
  std::vector<int>& any_face()
  {
    return m_faces[static_cast<std::size_t>(number(static_cast<int>(m_faces.size())))];
  }
  int any_vertex() { return number(static_cast<int>(m_points.size())); }

  int add_between(int v, int w, double s)
  {
    Point p{};
    for (std::size_t i = 0; i < 3; ++i)
      p[i] = (1 - s) * m_points[static_cast<std::size_t>(v)][i] +
             s * m_points[static_cast<std::size_t>(w)][i];
    m_points.push_back(p);
    return static_cast<int>(m_points.size()) - 1;
  }

  void give_a_corner_its_own_point()
  {
    int& v = any_face()[0];
    const Point copy = m_points[static_cast<std::size_t>(v)];
    m_points.push_back(copy);
    v = static_cast<int>(m_points.size()) - 1;
  }

  // The neighbour keeps the whole edge; a cap lies between.
  void split_an_edge_on_one_side()
  {
    std::vector<int>& face = any_face();
    const int a = face[0], b = face[1], c = face[2];
    const std::vector<double> shares = {0.5, 0.25, 0.9, 1e-3, 1 - 1e-14};
    const int m = add_between(a, b, shares[static_cast<std::size_t>(number(5))]);
    face = {a, m, c};
    m_faces.push_back({m, b, c});
    m_faces.push_back({a, b, m});
  }

  void split_a_face_next_to_a_corner()
  {
    std::vector<int>& face = any_face();
    const int a = face[0], b = face[1], c = face[2], m = add_between(a, b, 3e-15);
    face = {m, b, c};
    m_faces.push_back({a, b, m});
    m_faces.push_back({a, m, c});
  }

  std::mt19937 m_random;
  std::vector<Point> m_points;
  Faces m_faces;
};

bool is_permutation_of(std::vector<int> v, std::vector<int> w)
{
  std::sort(v.begin(), v.end());
  std::sort(w.begin(), w.end());
  return v == w;
}

/// The maps between old and new numbers are consistent with the positions
void expect_right_map(const Repair& done, const Surface_file& before, const Surface_file& after)
{
  ASSERT_EQ(done.vertex_in_file.size(), after.points.size());
  ASSERT_EQ(done.face_in_file.size(), after.polygons.size());
  ASSERT_EQ(done.new_vertex.size(), before.points.size());
  ASSERT_EQ(done.new_face.size(), before.polygons.size());
  for (std::size_t i = 0; i < after.points.size(); ++i)
    EXPECT_EQ(after.points[i], before.points[static_cast<std::size_t>(done.vertex_in_file[i])]);
  std::set<Point> gone;  // one point for each collapse, however many vertices lay there
  for (std::size_t v = 0; v < before.points.size(); ++v)
    if (const int now = done.new_vertex[v]; now >= 0)
      if (after.points[static_cast<std::size_t>(now)] != before.points[v])
        gone.insert(before.points[v]);
  EXPECT_LE(static_cast<int>(gone.size()), done.collapsed_edges);
  EXPECT_TRUE(std::is_sorted(done.face_in_file.begin(), done.face_in_file.end()));
  const Faces old_faces = faces_of(before), new_faces = faces_of(after);
  for (std::size_t f = 0; f < new_faces.size(); ++f) {
    const int old = done.face_in_file[f];
    EXPECT_LE(done.new_face[static_cast<std::size_t>(old)], static_cast<int>(f));
    const bool is_whole = std::count(done.face_in_file.begin(), done.face_in_file.end(), old) == 1;
    std::vector<int> was, is;
    for (const int v : new_faces[f]) is.push_back(done.vertex_in_file[static_cast<std::size_t>(v)]);
    for (const int v : old_faces[static_cast<std::size_t>(old)]) {
      const int now = done.new_vertex[static_cast<std::size_t>(v)];
      if (now >= 0) was.push_back(done.vertex_in_file[static_cast<std::size_t>(now)]);
    }
    if (is_whole && done.flipped_edges + done.collapsed_edges == 0) {
      EXPECT_TRUE(is_permutation_of(was, is)) << "face " << f;
    }
  }
}

/// A flat one cannot be mended: all its diagonals exist.
bool has_tetrahedron(const Surface_file& file)
{
  const CGP::Mesh_view mesh = prepare(file).mesh;
  const std::vector<int> component = CGP::connected_components(mesh);
  std::vector<int> sizes(component.size(), 0);
  for (const int c : component) ++sizes[static_cast<std::size_t>(c)];
  return std::find(sizes.begin(), sizes.end(), 4) != sizes.end();
}

void expect_repaired(const CGP::Mesh_view& mesh, unsigned seed, int times)
{
  Tortured_mesh tortured(mesh, seed);
  tortured.torture(times);
  const Surface_file before = tortured.file();
  Surface_file file = before;
  const Repair done = repair(file);
  expect_right_map(done, before, file);
  const Surface_input input = prepare(file);
  const Defects defects = find_defects(input);
  EXPECT_EQ(defects.of_topology, std::vector<std::string>()) << "seed " << seed;
  EXPECT_TRUE(defects.of_geometry.empty() || has_tetrahedron(file)) << "seed " << seed;
  EXPECT_EQ(input.turned_faces, 0);
  const Surface_file once = file;
  repair(file);
  EXPECT_EQ(file.points, once.points) << "seed " << seed;
  EXPECT_EQ(file.polygons.corners, once.polygons.corners) << "seed " << seed;
}

TEST(Repair_of_random_damage, leaves_an_oriented_manifold_without_flat_faces)
{
  const CGP::Mesh_view sphere = cgp_test::icosphere(1), disk = cgp_test::disk(3);
  for (unsigned seed = 0; seed < 300; ++seed) {
    expect_repaired(sphere, seed, 1 + static_cast<int>(seed % 40));
    expect_repaired(disk, seed, 1 + static_cast<int>(seed % 40));
  }
}

}  // namespace cgp_test::repair_random_tests
