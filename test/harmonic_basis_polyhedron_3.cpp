// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/harmonic_basis.h
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>

#include "harmonic_basis_checks.h"

namespace cgp_test::harmonic_basis_polyhedron_3_tests {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Surface = CGAL::Polyhedron_3<Kernel>;

TEST(Harmonic_basis_of_a_Polyhedron_3, is_that_of_its_triangles)
{
  expect_harmonic_forms(to_cgal_mesh<Surface>(holed_block(2)), 2);
  expect_basis_of_the_view(to_cgal_mesh<Surface>(btorus(8)));
  EXPECT_TRUE((std::is_same_v<decltype(CGP::harmonic_basis(Surface()))::Vector, Kernel::Vector_3>));
}

}  // namespace cgp_test::harmonic_basis_polyhedron_3_tests
