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

/// the forms of two vectors e with <e, e> = 1, <e_1, e_2> = 0 and the eigenvalues a and b of D -
/// rho
CGP::internal::Dirac_forms forms_of_eigenvectors(double a, double b)
{
  CGP::internal::Dirac_forms forms{zero_matrix(2, 2), zero_matrix(2, 2)};
  forms.dirac(0, 0).w = a;
  forms.dirac(1, 1).w = b;
  forms.mass(0, 0).w = forms.mass(1, 1).w = 1;
  return forms;
}

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

CGP::internal::Dirac_forms turned(const CGP::internal::Dirac_forms& forms,
                                  const Quaternion_matrix& U)
{
  return {CGP::gram_matrix(U, CGP::combination(forms.dirac, U)),
          CGP::gram_matrix(U, CGP::combination(forms.mass, U))};
}

/// the forms of vectors 100 times and a tenth as long
CGP::internal::Dirac_forms stretched(const CGP::internal::Dirac_forms& forms)
{
  Quaternion_matrix lengths = zero_matrix(2, 2);
  lengths(0, 0).w = 100;
  lengths(1, 1).w = 0.1;
  return turned(forms, lengths);
}

/// |<a, b>| / (|a| |b|)
double overlap(const Quaternion_vector<double>& a, const Quaternion_vector<double>& b)
{
  return norm(CGP::inner_product(a, b)) /
         std::sqrt(CGP::inner_product(a, a).w * CGP::inner_product(b, b).w);
}

const double degree = pi / 180;

}  // namespace

TEST(Is_surely_unmixed, holds_for_no_visible_mixture_and_for_pure_vectors_without_error)
{
  for (const double g : {0.1, 1.0})
    for (const double other : {-g, -1.3 * g}) {
      const auto claimed = [&](double angle) {
        const double c = std::cos(angle), s = std::sin(angle);
        return CGP::is_surely_unmixed(c * c * g + s * s * other,
                                      c * c * g * g + s * s * other * other);
      };
      EXPECT_TRUE(claimed(0));
      EXPECT_TRUE(claimed(1 * degree));
      for (int a = 3; a <= 45; a += 3) EXPECT_FALSE(claimed(a * degree));
    }
}

TEST(Has_mixed_signs, sees_angles_above_three_degrees_between_opposite_eigenvalues)
{
  const CGP::internal::Dirac_forms pure = forms_of_eigenvectors(-0.4, 0.5);
  EXPECT_FALSE(CGP::has_mixed_signs(pure));
  EXPECT_FALSE(CGP::has_mixed_signs(turned(pure, rotation(1 * degree, 1))));
  EXPECT_FALSE(CGP::has_mixed_signs(turned(pure, rotation(89 * degree, 1))));
  EXPECT_TRUE(CGP::has_mixed_signs(turned(pure, rotation(3 * degree, 1))));
  EXPECT_TRUE(CGP::has_mixed_signs(turned(pure, rotation(10 * degree, 1))));
  EXPECT_TRUE(CGP::has_mixed_signs(turned(pure, rotation(45 * degree, 2))));
  EXPECT_TRUE(CGP::has_mixed_signs(turned(pure, rotation(-60 * degree, 3))));
}

TEST(Has_mixed_signs, does_not_depend_on_the_lengths_of_the_vectors)
{
  const CGP::internal::Dirac_forms pure = forms_of_eigenvectors(-0.4, 0.5);
  EXPECT_FALSE(CGP::has_mixed_signs(stretched(pure)));
  EXPECT_FALSE(CGP::has_mixed_signs(stretched(turned(pure, rotation(1 * degree, 4)))));
  EXPECT_TRUE(CGP::has_mixed_signs(stretched(turned(pure, rotation(20 * degree, 4)))));
}

TEST(Has_mixed_signs, sees_no_mixture_of_vectors_with_one_sign)
{
  EXPECT_FALSE(CGP::has_mixed_signs(turned(forms_of_eigenvectors(0.5, 0.5), rotation(1, 5))));
  EXPECT_FALSE(CGP::has_mixed_signs(turned(forms_of_eigenvectors(0.5, 0.6), rotation(1, 5))));
}

TEST(Signed_eigenvalues, are_those_before_the_vectors_were_mixed)
{
  for (const double angle : {0., 0.2, pi / 4, 2.}) {
    const auto mixed = turned(forms_of_eigenvectors(-0.4, 0.5), rotation(angle, 7));
    for (const CGP::internal::Dirac_forms& forms : {mixed, stretched(mixed)}) {
      const auto values = CGP::signed_eigenvalues(forms);
      EXPECT_NEAR(values[0], -0.4, 1e-14);
      EXPECT_NEAR(values[1], 0.5, 1e-14);
    }
  }
}

TEST(Separation_pays, where_the_eigenvalues_are_nearly_opposite_and_mixed)
{
  const auto pays = [](double a, double b, double angle) {
    return CGP::separation_pays(turned(forms_of_eigenvectors(a, b), rotation(angle, 8)));
  };
  for (const double angle : {5 * degree, 45 * degree, 70 * degree}) {
    EXPECT_TRUE(pays(-0.4, 0.5, angle));
    EXPECT_TRUE(pays(0.11, -0.5, angle));
    EXPECT_TRUE(pays(-0.5, 0.11, angle));
    EXPECT_FALSE(pays(-0.09, 0.5, angle));  // a shift would make the mixture a fifth smaller
    EXPECT_FALSE(pays(0.5, 0.4, angle));
  }
  EXPECT_FALSE(pays(-0.4, 0.5, 1 * degree));
}

// On the sphere D has the eigenvector 1 with eigenvalue 0, and (nearly) f with -2: rho = -1 makes
// that +1 and -1.
TEST(Separate_signs, recovers_two_eigenvectors_of_opposite_sign)
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
    EXPECT_TRUE(CGP::has_mixed_signs(forms));
    const Quaternion_matrix separated = CGP::rayleigh_ritz_of_dirac(mixed, forms);
    EXPECT_NEAR(overlap(separated.col(0), pair.col(0)), 1, 1e-12);
    EXPECT_NEAR(overlap(separated.col(1), pair.col(1)), 1, 1e-12);
    const CGP::internal::Dirac_forms after = CGP::dirac_forms(sphere, rho, separated);
    EXPECT_NEAR(after.mass(0, 0).w, 1, 1e-12);
    EXPECT_NEAR(after.mass(1, 1).w, 1, 1e-12);
    EXPECT_NEAR(after.dirac(0, 0).w, -1, 0.02);
    EXPECT_NEAR(after.dirac(1, 1).w, 1, 1e-12);
    EXPECT_FALSE(CGP::has_mixed_signs(after));
  }
}
