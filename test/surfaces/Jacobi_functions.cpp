// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/surfaces/Jacobi_functions.h
#include <Conformal_geometry_processing/surfaces/Jacobi_functions.h>

#include <gtest/gtest.h>

#include <cmath>

namespace cgp_test::jacobi_functions_tests {

using Conformal_geometry_processing::internal::Jacobi_functions;

double modulus(double complement)
{
  return std::sqrt((1 - complement) * (1 + complement));
}

TEST(Jacobi_functions, have_the_complete_integrals_at_the_quarter_period)
{
  // computed with fifty digits
  const double table[][3] = {{1, 1.5707963267948966, 1.5707963267948966},
                             {0.9, 1.6546166675225269, 1.4932901081312071},
                             {0.3, 2.6277733320843438, 1.0964775173922272},
                             {0.01, 5.9915893405069964, 1.0002745824306629},
                             {0.0001, 10.596634757087660, 1.0000000504831738}};
  for (const auto& [complement, K, E] : table) {
    const Jacobi_functions f(complement);
    EXPECT_NEAR(f.quarter_period(), K, 2e-15 * K) << complement;
    EXPECT_NEAR(f(K).dn, complement, 2e-15);
    EXPECT_NEAR(f(K).second_integral, E, 4e-15) << complement;
  }
}

TEST(Jacobi_functions, invert_the_incomplete_integrals)
{
  for (const double complement : {1., .7, .2, .01})
    for (const double angle : {0., .3, 1., 1.5}) {
      const double k = modulus(complement), t = std::ellint_1(k, angle);
      const auto values = Jacobi_functions(complement)(t);
      EXPECT_NEAR(values.dn, std::hypot(complement * std::sin(angle), std::cos(angle)), 1e-12);
      EXPECT_NEAR(values.second_integral, std::ellint_2(k, angle), 1e-12);
    }
}

}  // namespace cgp_test::jacobi_functions_tests
