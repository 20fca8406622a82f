// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/forms/Hodge_decomposition.h>
#include <Conformal_geometry_processing/forms/conformal_modulus.h>
#include <Conformal_geometry_processing/forms/tree_cotree.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <gtest/gtest.h>

#include "holed_surfaces.h"
#include "support/handlebodies.h"
#include "support/meshes.h"
#include "support/moebius.h"
#include "support/skewed_tori.h"
#include "support/tori.h"

#include <cmath>
#include <complex>
#include <vector>

namespace cgp_test::conformal_modulus_tests {

namespace CGP = Conformal_geometry_processing;
using Complex = std::complex<double>;
using CGP::internal::conformal_type_distance;
using CGP::internal::harmonic_energies;

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

double distance(const Mesh_view& a, const Mesh_view& b)
{
  return conformal_type_distance(harmonic_energies(a), harmonic_energies(b));
}

/// the proportion of the rectangle of a torus of revolution
double proportion(double R, double r)
{
  return std::sqrt(R * R / (r * r) - 1);
}

TEST(Conformal_type_distance, of_tori_of_revolution_is_the_hyperbolic_one_of_their_moduli)
{
  for (const double r : {.5, .7, 1.3}) {
    const double wanted = std::abs(std::log(proportion(2, r) / proportion(2, 1)));
    std::vector<double> h, error;
    for (const int n : {24, 48, 96}) {
      h.push_back(1. / n);
      error.push_back(std::abs(distance(torus(2, 1, 2 * n, n), torus(2, r, 2 * n, n)) - wanted));
    }
    EXPECT_LT(error.back(), 5e-3);
    EXPECT_GT(slope(h, error), 1.8) << r;
  }
}

TEST(Conformal_type_distance, of_a_surface_from_itself_and_from_its_similar_ones_is_zero)
{
  const Mesh_view mesh = irregular_torus(2, 1, 24, 12);
  EXPECT_LT(distance(mesh, mesh), 1e-12);
  EXPECT_LT(distance(mesh, scaled(mesh, 1e3)), 1e-11);
  EXPECT_EQ(distance(icosphere(1), bumpy_sphere(1)), 0);
}

TEST(Conformal_type_distance, of_moebius_images_is_the_discretisation_error)
{
  std::vector<double> h, error;
  for (const int n : {16, 32, 64}) {
    const Mesh_view mesh = torus(2, 1, 2 * n, n);
    h.push_back(1. / n);
    error.push_back(distance(mesh, inverted(mesh, {.3, .1, 2.5})));
  }
  EXPECT_LT(error.back(), 1e-3);
  EXPECT_GT(slope(h, error), 1.8);
}

TEST(Conformal_type_distance, is_infinite_where_energies_are_not_positive)
{
  const Eigen::Matrix2d good = Eigen::Matrix2d::Identity();
  EXPECT_EQ(conformal_type_distance(good, -good), HUGE_VAL);
  EXPECT_EQ(conformal_type_distance(good, std::nan("") * good), HUGE_VAL);
}

}  // namespace cgp_test::conformal_modulus_tests
