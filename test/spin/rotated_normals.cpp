// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Spin_report.h
#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.h"

namespace cgp_test::rotated_normals_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Quaternion;
using CGP::Quaternion_vector;

Points area_vectors(const Mesh_view& mesh)
{
  Points vectors(3, mesh.size_of_faces());
  for (int f = 0; f < mesh.size_of_faces(); ++f) vectors.col(f) = mesh.double_area_vector(f);
  return vectors;
}

TEST(Rotated_normals, by_the_identity_are_those_of_the_faces)
{
  const Mesh_view mesh = bumpy_sphere(1);
  const auto one =
      Quaternion_vector<double>::Constant(mesh.size_of_vertices(), Quaternion<double>{1, 0, 0, 0});
  // The spins of three corners sum up to 3, which scales by 9.
  EXPECT_LT((CGP::rotated_normals(mesh, one) - 9 * area_vectors(mesh)).cwiseAbs().maxCoeff(),
            1e-14);
}

TEST(Rotated_normals, by_a_constant_spin_are_those_of_the_rotated_surface)
{
  const Mesh_view mesh = bumpy_sphere(1);
  // A quarter of a turn about the z axis: x goes to y.
  const double h = std::sqrt(0.5);
  const auto spins =
      Quaternion_vector<double>::Constant(mesh.size_of_vertices(), Quaternion<double>{h, 0, 0, -h});
  Points turned(3, mesh.size_of_vertices());
  turned << -mesh.positions().row(1), mesh.positions().row(0), mesh.positions().row(2);
  const Points expected = area_vectors(Mesh_view(turned, mesh.corners()));
  EXPECT_LT((CGP::rotated_normals(mesh, spins) - 9 * expected).cwiseAbs().maxCoeff(), 1e-13);
}

}  // namespace cgp_test::rotated_normals_tests
