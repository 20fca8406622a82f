// Tests include/Conformal_geometry_processing/measure/energies.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/energies.h>

#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/moebius.h"

namespace cgp_test::energies_tests {

namespace CGP = Conformal_geometry_processing;

using Energy = std::function<double(const Mesh_view&)>;

/// the exponent with which the energy tends to a limit, on icospheres 2 to 5
double order_on_spheres(const Energy& energy)
{
  std::vector<double> h, error;
  for (int level : {2, 3, 4, 5}) {
    h.push_back(mean_edge_length(icosphere(level)));
    error.push_back(energy(icosphere(level)) - 4 * pi);
  }
  return slope(h, error);
}

double order_on_tori(const Energy& energy)
{
  std::vector<double> h, error;
  for (int n : {20, 40, 80}) {
    h.push_back(1. / n);
    error.push_back(energy(torus(std::sqrt(2.), 1, n, n)) - 2 * pi * pi);
  }
  return slope(h, error);
}

TEST(Total_area, of_polyhedra)
{
  EXPECT_NEAR(CGP::total_area(cube()), 6, 1e-15);
  EXPECT_NEAR(CGP::total_area(tetrahedron()), 8 * std::sqrt(3.), 1e-13);
}

TEST(Signed_volume, of_polyhedra_is_positive_with_outward_normals)
{
  EXPECT_NEAR(CGP::signed_volume(cube()), 1, 1e-15);
  EXPECT_NEAR(CGP::signed_volume(tetrahedron()), 8. / 3, 1e-14);
  EXPECT_NEAR(CGP::signed_volume(double_torus()), 13, 1e-13);
  EXPECT_NEAR(CGP::signed_volume(with_reversed_faces(cube())), -1, 1e-15);
}

TEST(Signed_volume, keeps_its_digits_far_from_the_origin)
{
  const Eigen::Vector3d far(1e15, -3e15, 2e15);
  const Mesh_view away(tetrahedron().positions().colwise() + far, tetrahedron().corners());
  EXPECT_NEAR(CGP::signed_volume(away), 8. / 3, 1e-14);
}

TEST(Bending_angles, of_a_cube_are_right_angles_at_its_edges_and_zero_at_diagonals)
{
  const Eigen::VectorXd angles = CGP::bending_angles(cube());
  for (int k = 0; k < cube().size_of_edges(); ++k) {
    const Eigen::Vector3d e =
        cube().position(cube().ends(k)[1]) - cube().position(cube().ends(k)[0]);
    EXPECT_NEAR(angles[k], e.norm() < 1.1 ? pi / 2 : 0, 1e-15);
  }
}

TEST(Bending_angles, of_the_tetrahedron_are_supplements_of_its_dihedral_angle)
{
  for (double angle : CGP::bending_angles(tetrahedron()))
    EXPECT_NEAR(angle, pi - std::acos(1. / 3), 1e-14);
}

TEST(Bending_angles, are_negative_where_concave_and_zero_at_the_boundary)
{
  // A valley along the y axis: both sides rise at 45 degrees.
  const Mesh_view valley(points({{0, 0, 0}, {0, 1, 0}, {1, 0, 1}, {-1, 0, 1}}),
                         {{0, 2, 1}, {0, 1, 3}});
  const Eigen::VectorXd angles = CGP::bending_angles(valley);
  EXPECT_NEAR(angles[0], -pi / 2, 1e-15);
  for (int k = 1; k < 5; ++k) EXPECT_EQ(angles[k], 0);
  EXPECT_NEAR(CGP::bending_angles(with_reversed_faces(valley))[0], pi / 2, 1e-15);
}

TEST(Bending_angles, times_length_add_up_to_twice_the_integral_of_H_on_the_sphere)
{
  const Mesh_view mesh = icosphere(4);
  const Eigen::VectorXd angles = CGP::bending_angles(mesh);
  double sum = 0;
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    sum += angles[k] * mesh.vector(mesh.halfedges_begin(k)[0]).norm();
  EXPECT_NEAR(sum / (8 * pi), 1, 1e-3);
}

TEST(Willmore_energy, of_spheres_tends_to_4_pi_with_second_order)
{
  EXPECT_NEAR(order_on_spheres(CGP::willmore_energy), 2, .05);
  EXPECT_NEAR(order_on_spheres(CGP::steiner_willmore_energy), 2, .05);
}

TEST(Willmore_energy, of_the_clifford_torus_tends_to_2_pi_squared_with_second_order)
{
  EXPECT_NEAR(order_on_tori(CGP::willmore_energy), 2, .1);
  EXPECT_NEAR(order_on_tori(CGP::steiner_willmore_energy), 2, .1);
}

TEST(Willmore_energy, of_spheres_is_as_an_independent_computation_found)
{
  const double voronoi[] = {12.331079432766932, 12.506740599066784, 12.551390818827375};
  const double steiner[] = {12.660479616674106, 12.590206939022806, 12.57234954619038};
  for (int i : {0, 1, 2}) {
    EXPECT_NEAR(CGP::willmore_energy(icosphere(i + 2)) / voronoi[i], 1, 1e-10);
    EXPECT_NEAR(CGP::steiner_willmore_energy(icosphere(i + 2)) / steiner[i], 1, 1e-10);
  }
}

TEST(Willmore_energy, of_tori_is_as_an_independent_computation_found)
{
  const int sizes[] = {20, 40, 80};
  const double voronoi[] = {.9817275983466565, .9953041588050803, .9988153672289761};
  const double steiner[] = {1.0019590066524013, 1.0004424159285656, 1.0001075067808836};
  for (int i : {0, 1, 2}) {
    const Mesh_view mesh = torus(std::sqrt(2.), 1, sizes[i], sizes[i]);
    EXPECT_NEAR(CGP::willmore_energy(mesh) / (2 * pi * pi), voronoi[i], 1e-6);
    EXPECT_NEAR(CGP::steiner_willmore_energy(mesh) / (2 * pi * pi), steiner[i], 1e-6);
  }
}

TEST(Willmore_energy, of_a_bumpy_sphere_is_as_an_independent_computation_found)
{
  EXPECT_NEAR(CGP::willmore_energy(bumpy_sphere(4)) / 13.791685563619502, 1, 1e-6);
}

TEST(Willmore_energy, does_not_depend_on_scale_or_orientation)
{
  const Mesh_view mesh = bumpy_sphere(2);
  for (const Energy& energy :
       {Energy(CGP::willmore_energy), Energy(CGP::steiner_willmore_energy)}) {
    EXPECT_NEAR(energy(scaled(mesh, 7)), energy(mesh), 1e-12);
    EXPECT_NEAR(energy(with_reversed_faces(mesh)), energy(mesh), 1e-12);
  }
}

TEST(Willmore_energy, changes_under_inversions_by_the_discretization_error_alone)
{
  const Eigen::Vector3d outside(3, 1, 2);
  for (const Energy& energy :
       {Energy(CGP::willmore_energy), Energy(CGP::steiner_willmore_energy)}) {
    std::vector<double> h, change;
    for (int n : {20, 40, 80}) {
      const Mesh_view mesh = torus(std::sqrt(2.), 1, n, n);
      h.push_back(1. / n);
      change.push_back(energy(inverted(mesh, outside)) - energy(mesh));
    }
    EXPECT_GT(slope(h, change), 1.8);
    EXPECT_LT(std::abs(change.back()), .05);
  }
}

}  // namespace cgp_test::energies_tests
