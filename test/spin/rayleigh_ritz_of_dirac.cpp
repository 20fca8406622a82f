// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/rayleigh_ritz_of_dirac.h
#include <Conformal_geometry_processing/curves/Closing_functions.h>
#include <Conformal_geometry_processing/linear_algebra/dense/block_products.h>
#include <Conformal_geometry_processing/spin/rayleigh_ritz_of_dirac.h>

#include <gtest/gtest.h>

#include <cmath>

#include "support/dense.h"
#include "support/meshes.h"

namespace {

using namespace cgp_test;
namespace CGP = Conformal_geometry_processing;

/// turns by the angle, with quaternions of length one: a unitary matrix
Quaternion_matrix rotation(double angle, std::uint64_t seed)
{
  const Quaternion_vector<double> q = random_quaternions(3, seed);
  const auto unit = [&](int i) { return q[i] / norm(q[i]); };
  Quaternion_matrix U(2, 2);
  U(0, 0) = std::cos(angle) * unit(0);
  U(1, 0) = std::sin(angle) * (unit(1) * unit(0));
  U(0, 1) = -std::sin(angle) * (conjugate(unit(1)) * unit(2));
  U(1, 1) = std::cos(angle) * unit(2);
  return U;
}

/// |<a, b>| / (|a| |b|)
double overlap(const Quaternion_vector<double>& a, const Quaternion_vector<double>& b)
{
  return norm(CGP::inner_product(a, b)) /
         std::sqrt(CGP::inner_product(a, a).w * CGP::inner_product(b, b).w);
}

}  // namespace

// On the sphere D has the eigenvector 1 with eigenvalue 0, and (nearly) f with -2: rho = -1 makes
// that +1 and -1.
TEST(Rayleigh_ritz_of_dirac, recovers_two_eigenvectors_of_opposite_sign)
{
  const Mesh_view sphere = icosphere(3);
  const int n = sphere.size_of_vertices();
  const auto rho =
      CGP::Curvature_potential::on_faces(Eigen::VectorXd::Constant(sphere.size_of_faces(), -1.));
  Quaternion_matrix pair(n, 2);
  pair.col(0) = imaginary_columns(sphere.positions());
  pair.col(1).setConstant({1, 0, 0, 0});
  for (const double angle : {0.3, pi / 4, 2.}) {
    const Quaternion_matrix mixed = CGP::combination(pair, rotation(angle, 6));
    const CGP::internal::Dirac_forms forms = CGP::dirac_forms(sphere, rho, mixed);
    ASSERT_GT(norm(forms.dirac(0, 1)), 0.3);
    const Quaternion_matrix separated = CGP::rayleigh_ritz_of_dirac(mixed, forms);
    EXPECT_NEAR(overlap(separated.col(0), pair.col(0)), 1, 1e-12);
    EXPECT_NEAR(overlap(separated.col(1), pair.col(1)), 1, 1e-12);
    const CGP::internal::Dirac_forms after = CGP::dirac_forms(sphere, rho, separated);
    EXPECT_NEAR(after.mass(0, 0).w, 1, 1e-12);
    EXPECT_NEAR(after.mass(1, 1).w, 1, 1e-12);
    EXPECT_NEAR(after.dirac(0, 0).w, -1, 0.02);
    EXPECT_NEAR(after.dirac(1, 1).w, 1, 1e-12);
    EXPECT_LT(norm(after.dirac(0, 1)), 1e-12);
    EXPECT_LT(norm(after.mass(0, 1)), 1e-12);
  }
}
