// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/parameterization/conformal_energy.h
#include <Conformal_geometry_processing/parameterization/conformal_energy.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "flat_maps.h"
#include "support/dense.h"
#include "support/meshes.h"

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

}  // namespace cgp_test::conformal_energy_tests
