// Tests include/Conformal_geometry_processing/forms/conformal_type.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/forms/conformal_type.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/meshes.h"
#include "support/moebius.h"
#include "support/tori.h"

namespace cgp_test::conformal_type_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::internal::conformal_type_distance;
using CGP::internal::harmonic_energies;

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

}  // namespace cgp_test::conformal_type_tests
