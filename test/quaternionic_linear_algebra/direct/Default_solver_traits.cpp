// Tests direct/Default_solver_traits.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/direct/Default_solver_traits.h>

#include <gtest/gtest.h>

#include <type_traits>

namespace cgp_test::default_solver_traits_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Default_solver_traits, are_the_library_s_own)
{
  EXPECT_TRUE((std::is_same_v<CGP::Default_solver_traits, CGP::Supernodal_solver_traits>));
}

}  // namespace cgp_test::default_solver_traits_tests
