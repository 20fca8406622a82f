// Tests linear_algebra/Default_solver_traits.h
// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#undef CONFORMAL_GEOMETRY_PROCESSING_USE_CHOLMOD
#include <Conformal_geometry_processing/linear_algebra/Default_solver_traits.h>

#include <gtest/gtest.h>

#include <type_traits>

namespace CGP = Conformal_geometry_processing;

TEST(Default_solver_traits, are_those_of_eigen_without_the_component_cholmod)
{
  EXPECT_TRUE((std::is_same_v<CGP::Default_solver_traits, CGP::Eigen_hermitian_solver_traits>));
}
