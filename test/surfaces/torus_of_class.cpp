// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests surfaces/tori.h
#include <Conformal_geometry_processing/surfaces/tori.h>

#include <gtest/gtest.h>

#include <complex>

#include "support/polyhedra.h"

namespace cgp_test::torus_of_class_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Torus_of_class, has_the_modulus_asked_for)
{
  const auto family = [](double R) { return CGP::round_torus(R, 1, 20, 15); };
  for (const double b : {1.1, 1.7}) {
    const std::complex<double> tau = CGP::conformal_modulus(CGP::torus_of_class(family, b, 1.4, 3));
    EXPECT_NEAR(tau.imag(), b, 1e-9);
    EXPECT_NEAR(tau.real(), 0, 1e-9);
  }
}

TEST(Torus_of_class, refuses_families_without_it_and_surfaces_that_are_no_tori)
{
  const auto family = [](double R) { return CGP::round_torus(R, 1, 20, 15); };
  EXPECT_THROW((void)CGP::torus_of_class(family, 5, 1.4, 3), CGP::Precondition_error);
  EXPECT_THROW((void)CGP::torus_of_class([](double) { return tetrahedron(); }, 1, 2, 3),
               CGP::Precondition_error);
}

}  // namespace cgp_test::torus_of_class_tests
