// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/make_delaunay.h
#include <Conformal_geometry_processing/conformal_willmore_flow.h>
#include <Conformal_geometry_processing/make_delaunay.h>

#include <gtest/gtest.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "support/cgal_meshes.h"
#include "support/meshes.h"
#include "support/random.h"
#include "support/spheres.h"

namespace cgp_test::make_delaunay_tests {

namespace CGP = Conformal_geometry_processing;
using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

Mesh_view with_slivers()
{
  return mapped(perturbed(bumpy_sphere(3), .02),
                [](const Eigen::Vector3d& p) { return Eigen::Vector3d(4 * p.x(), p.y(), p.z()); });
}

/// the faces, each from its smallest vertex on
std::set<std::array<int, 3>> faces_of(const Mesh_view& mesh)
{
  std::set<std::array<int, 3>> all;
  for (std::array<int, 3> corners : mesh.corners()) {
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    all.insert(corners);
  }
  return all;
}

template <class Mesh>
Mesh_view view_of(const Mesh& mesh)
{
  return CGP::Graph_view<Mesh>(mesh, CGP::parameters::default_values(), "test").view();
}

template <class Mesh>
void expect_delaunay(const Mesh_view& thin)
{
  Mesh mesh = to_cgal_mesh<Mesh>(thin);
  const Mesh_view before = view_of(mesh);
  std::vector<std::array<int, 2>> flips;
  const Mesh_view expected = CGP::internal::delaunay_by_chords(before, 0, flips);
  EXPECT_EQ(CGP::make_delaunay(mesh), static_cast<int>(flips.size()));
  EXPECT_GT(flips.size(), 100U);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  EXPECT_EQ(faces_of(view_of(mesh)), faces_of(expected));
  EXPECT_EQ(view_of(mesh).positions(), before.positions());
  EXPECT_EQ(CGP::make_delaunay(mesh), 0);
}

TEST(Make_delaunay, flips_the_edges_of_a_mesh)
{
  expect_delaunay<Surface>(with_slivers());
  expect_delaunay<Polyhedron>(with_slivers());
}

// Where a flow computes with the faces of the mesh, it is judged by its own.
TEST(Make_delaunay, leaves_a_flow_the_faces_on_which_it_computes)
{
  Surface thin = to_cgal_mesh<Surface>(with_slivers()), mesh = thin;
  (void)CGP::make_delaunay(mesh);
  const auto few = CGP::parameters::number_of_iterations(6);
  const CGP::Flow_report kept = CGP::conformal_willmore_flow(thin, few),
                         flipped = CGP::conformal_willmore_flow(mesh, few);
  EXPECT_TRUE(flipped);
  EXPECT_EQ(flipped.energy_of_faces, flipped.energy);
  EXPECT_NE(kept.energy_of_faces, kept.energy);
  EXPECT_LT(flipped.conformality_of_faces.quasi_conformal.max,
            kept.conformality_of_faces.quasi_conformal.max);
}

TEST(Make_delaunay, refuses_edges_of_length_zero_and_leaves_the_mesh)
{
  Points f = with_slivers().positions();
  const std::array<int, 3> face = with_slivers().corners(0);
  f.col(face[0]) = f.col(face[1]);
  Surface mesh = to_cgal_mesh<Surface>({f, with_slivers().corners()});
  EXPECT_THROW((void)CGP::make_delaunay(mesh), CGP::Precondition_error);
  EXPECT_EQ(faces_of(view_of(mesh)), faces_of(with_slivers()));
}

}  // namespace cgp_test::make_delaunay_tests
