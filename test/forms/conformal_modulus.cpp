// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/forms/conformal_modulus.h
#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/forms/Hodge_decomposition.h>
#include <Conformal_geometry_processing/forms/conformal_modulus.h>
#include <Conformal_geometry_processing/forms/tree_cotree.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "holed_surfaces.h"
#include "support/handlebodies.h"
#include "support/meshes.h"
#include "support/moebius.h"
#include "support/skewed_tori.h"

namespace cgp_test::conformal_modulus_tests {

namespace CGP = Conformal_geometry_processing;
using Complex = std::complex<double>;

Complex modulus_of(const Mesh_view& mesh)
{
  return CGP::conformal_modulus(mesh, CGP::Hodge_decomposition(mesh).harmonic_basis());
}

TEST(Reduced_modulus, is_in_the_fundamental_domain_and_of_the_same_class)
{
  EXPECT_EQ(CGP::reduced_modulus({0.25, 2}), Complex(0.25, 2));
  EXPECT_EQ(CGP::reduced_modulus({7.25, 2}), Complex(0.25, 2));
  EXPECT_LT(std::abs(CGP::reduced_modulus({0, 0.25}) - Complex(0, 4)), 1e-14);
  const Complex tau(0.3, 1.7);
  // (a tau + b) / (c tau + d) with a d - b c = 1
  EXPECT_LT(std::abs(CGP::reduced_modulus((5. * tau + 7.) / (2. * tau + 3.)) - tau), 1e-12);
  EXPECT_LT(std::abs(CGP::reduced_modulus((8. * tau - 3.) / (3. * tau - 1.)) - tau), 1e-12);
}

TEST(Wedge_product, is_antisymmetric_and_blind_to_exact_parts)
{
  const Mesh_view mesh = btorus(8);
  const Eigen::MatrixXd g = CGP::closed_generators(mesh);
  EXPECT_EQ(std::abs(CGP::wedge_product(mesh, g.col(0), g.col(1))), 1);
  EXPECT_EQ(CGP::wedge_product(mesh, g.col(0), g.col(1)),
            -CGP::wedge_product(mesh, g.col(1), g.col(0)));
  EXPECT_EQ(CGP::wedge_product(mesh, g.col(1), g.col(1)), 0);
  const Eigen::VectorXd u = random_numbers(mesh.size_of_vertices(), 3);
  Eigen::VectorXd form = g.col(0);
  for (int k = 0; k < mesh.size_of_edges(); ++k) form[k] += u[mesh.ends(k)[1]] - u[mesh.ends(k)[0]];
  EXPECT_NEAR(CGP::wedge_product(mesh, form, g.col(1)),
              CGP::wedge_product(mesh, g.col(0), g.col(1)), 1e-12);
}

// The torus of revolution is conformally a rectangle with sides 1 and sqrt((R/r)^2 - 1).
TEST(Conformal_modulus, of_tori_of_revolution_converges_with_second_order)
{
  for (const double R : {std::sqrt(2.), 1.2, 2.5}) {
    const double b = std::sqrt(R * R - 1), expected = std::max(b, 1 / b);
    std::vector<double> sizes, errors;
    for (const int n : {16, 32, 64}) {
      const Complex tau = modulus_of(torus(R, 1, 2 * n, n));
      sizes.push_back(1. / n);
      errors.push_back(std::abs(tau - Complex(0, expected)));
    }
    EXPECT_LT(errors.back(), 0.01 * expected);
    EXPECT_NEAR(slope(sizes, errors), 2, 0.1) << R;
  }
}

TEST(Conformal_modulus, is_that_of_the_specification)
{
  EXPECT_LT(std::abs(modulus_of(storus(32)) - Complex(0.00035213542142, 1.0409121025331)), 1e-10);
  EXPECT_LT(std::abs(modulus_of(storus(48)) - Complex(0.00015934687890, 1.0401077214354)), 1e-10);
}

TEST(Conformal_modulus, of_a_twisted_torus_changes_the_sign_of_its_real_part_with_the_hand)
{
  const Mesh_view mesh = twisted_torus(48);
  const Complex tau = modulus_of(mesh);
  EXPECT_NEAR(std::abs(tau.real()), 0.051, 3e-3);
  EXPECT_NEAR(tau.imag(), 1.80, 5e-3);
  const Mesh_view mirrored = with_reversed_faces(
      mapped(mesh, [](const Eigen::Vector3d& p) { return Eigen::Vector3d(p.x(), p.y(), -p.z()); }));
  EXPECT_LT(std::abs(modulus_of(mirrored) + std::conj(tau)), 1e-12);
  EXPECT_LT(std::abs(modulus_of(with_reversed_faces(mesh)) + std::conj(tau)), 1e-12);
}

TEST(Conformal_modulus, changes_neither_with_the_numbering_nor_with_scale)
{
  const Mesh_view mesh = twisted_torus(12);
  const Complex tau = modulus_of(mesh);
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const auto number = random_permutation(mesh.size_of_vertices(), seed);
    EXPECT_LT(std::abs(modulus_of(renumbered(mesh, number)) - tau), 1e-12);
  }
  EXPECT_LT(std::abs(modulus_of(scaled(mesh, 1e-9)) - tau), 1e-12);
}

TEST(Conformal_modulus, is_kept_by_inversions_to_second_order)
{
  std::vector<double> sizes, errors;
  for (const int n : {12, 24, 48}) {
    const Mesh_view mesh = twisted_torus(n);
    sizes.push_back(1. / n);
    errors.push_back(std::abs(modulus_of(mesh) - modulus_of(inverted(mesh, {0.3, 5, 1}))));
  }
  EXPECT_GT(slope(sizes, errors), 1.8);
  EXPECT_LT(errors.back(), 1e-3);
}

TEST(Conformal_modulus, refuses_what_is_no_torus)
{
  for (const Mesh_view& mesh : {icosphere(1), holed_block(2), torus_with_hole(8, 6)})
    EXPECT_THROW((void)modulus_of(mesh), CGP::Precondition_error);
}

}  // namespace cgp_test::conformal_modulus_tests
