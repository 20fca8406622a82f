// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests parameterization/spectral_parameterization.h
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/operators/calculus.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Conformal_geometry_processing/parameterization/spectral_parameterization.h>

#include <gtest/gtest.h>

#include "flat_maps.h"
#include "support/dense.h"
#include "support/meshes.h"

#include <cmath>
#include <complex>

namespace cgp_test::conformal_energy_tests {

namespace CGP = Conformal_geometry_processing;
using Complex = std::complex<double>;

/// a complex matrix as the real one that acts on a_0, b_0, a_1, b_1, ...
Eigen::MatrixXd real_form(const Eigen::MatrixXcd& L)
{
  Eigen::MatrixXd R(2 * L.rows(), 2 * L.cols());
  for (Eigen::Index i = 0; i < L.rows(); ++i)
    for (Eigen::Index j = 0; j < L.cols(); ++j) {
      const Complex s = L(i, j);
      R.block<2, 2>(2 * i, 2 * j) << s.real(), -s.imag(), s.imag(), s.real();
    }
  return R;
}

double energy(const Mesh_view& mesh, const Eigen::VectorXcd& z)
{
  return std::real(z.dot(CGP::conformal_energy(mesh) * z));
}

TEST(Conformal_energy, is_that_of_least_squares_conformal_maps)
{
  for (const Mesh_view& mesh : {cap_from_disk(jittered_disk(4, .3), 2.), annulus(.4, 1, 12, 3),
                                perturbed(cylinder(1, 2, 12, 3), .1), single_triangle()}) {
    const Eigen::MatrixXd C = least_squares_conformal_rows(mesh), expected = C.transpose() * C;
    EXPECT_LT((real_form(dense(CGP::conformal_energy(mesh))) - expected).norm(),
              1e-12 * expected.norm());
  }
}

TEST(Conformal_energy, of_a_flat_mesh_is_zero_for_similarities_and_not_for_reflections)
{
  const Mesh_view mesh = disk(8);
  const Eigen::VectorXcd z = plane_points(mesh);
  EXPECT_NEAR(energy(mesh, Complex(2, -3) * z + Complex(5, 7) * Eigen::VectorXcd::Ones(z.size())),
              0, 1e-11);
  EXPECT_NEAR(energy(mesh, z.conjugate()), 4 * area(mesh), 1e-12);
}

TEST(Conformal_energy, does_not_change_with_the_scale_of_the_surface)
{
  const Mesh_view mesh = cap_from_disk(disk(3), 1.);
  const Eigen::MatrixXcd L = dense(CGP::conformal_energy(mesh));
  EXPECT_LT((dense(CGP::conformal_energy(scaled(mesh, 1e5))) - L).norm(), 1e-12 * L.norm());
}

double energy(const Mesh_view& mesh, const Points& normals, const Eigen::VectorXcd& z)
{
  const Eigen::VectorXd ab = interleaved_parts(z);
  return ab.dot(CGP::vertex_normal_energy(mesh, normals, *CGP::vertex_graph(mesh)) * ab);
}

/// |D psi|^2 of psi = a - b N without the part along the normals of the faces, by the Dirac
/// operator
double energy_by_dirac(const Mesh_view& mesh, const Points& normals, const Eigen::VectorXcd& z)
{
  CGP::Quaternion_vector<double> psi(z.size());
  for (Eigen::Index v = 0; v < z.size(); ++v) {
    const Eigen::Vector3d bN = z[v].imag() * normals.col(v);
    psi[v] = {z[v].real(), -bN.x(), -bN.y(), -bN.z()};
  }
  const CGP::Quaternion_vector<double> D = CGP::dirac(mesh) * psi;
  double sum = 0;
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const Eigen::Vector3d n = mesh.double_area_vector(f), d(D[f].x, D[f].y, D[f].z);
    sum += n.norm() / 2 * (d - d.dot(n.normalized()) * n.normalized()).squaredNorm();
  }
  return sum;
}

Eigen::VectorXcd random_map(int n, std::uint64_t seed)
{
  return random_numbers(n, seed) +
         std::complex<double>(0, 1) * random_numbers(n, seed + 1).cast<std::complex<double>>();
}

TEST(Vertex_normal_energy, is_that_of_the_dirac_operator_along_the_faces)
{
  for (const Mesh_view& mesh :
       {cap_from_disk(jittered_disk(4, .3), 2.), perturbed(cylinder(1, 2, 12, 3), .1)}) {
    const Points normals = CGP::vertex_normals(mesh, CGP::internal::Normal_weight::angle);
    const Eigen::VectorXcd z = random_map(mesh.size_of_vertices(), 1);
    EXPECT_NEAR(energy(mesh, normals, z), energy_by_dirac(mesh, normals, z),
                1e-12 * energy(mesh, normals, z));
  }
}

TEST(Vertex_normal_energy, of_a_flat_mesh_is_the_conformal_one)
{
  const Mesh_view mesh = jittered_disk(5, .3);
  const Eigen::MatrixXd C = least_squares_conformal_rows(mesh), expected = C.transpose() * C;
  const Eigen::MatrixXd E =
      dense(CGP::vertex_normal_energy(mesh, CGP::vertex_normals(mesh), *CGP::vertex_graph(mesh)));
  EXPECT_LT((E - expected).norm(), 1e-12 * expected.norm());
}

TEST(Vertex_normal_energy, with_the_opposite_normals_is_that_of_reflections)
{
  const Mesh_view mesh = disk(8);
  const Points down = -CGP::vertex_normals(mesh);
  const Eigen::VectorXcd z = plane_points(mesh);
  EXPECT_NEAR(energy(mesh, down, z.conjugate()), 0, 1e-12);
  EXPECT_NEAR(energy(mesh, down, z), 4 * area(mesh), 1e-12);
  EXPECT_NEAR(energy(mesh, -down, z), 0, 1e-12);
}

TEST(Vertex_normal_energy, of_a_bent_mesh_is_zero_for_the_constant_1_but_not_for_i)
{
  const Mesh_view mesh = perturbed(cap_from_disk(disk(4), 2.), .05);
  const Points normals = CGP::vertex_normals(mesh, CGP::internal::Normal_weight::angle);
  const Eigen::VectorXcd one = Eigen::VectorXcd::Ones(mesh.size_of_vertices());
  EXPECT_NEAR(energy(mesh, normals, one), 0, 1e-12);
  EXPECT_GT(energy(mesh, normals, std::complex<double>(0, 1) * one), 1e-3);
  const Eigen::VectorXcd z = plane_points(mesh);
  EXPECT_GT(
      std::abs(energy(mesh, normals, std::complex<double>(0, 1) * z) - energy(mesh, normals, z)),
      1e-6);
}

}  // namespace cgp_test::conformal_energy_tests
