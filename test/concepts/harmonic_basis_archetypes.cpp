// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/harmonic_basis.h
#include "concepts/archetype_maps.h"

#include <Conformal_geometry_processing/harmonic_basis.h>

#include <gtest/gtest.h>

#include <type_traits>

#include "concepts/Sparse_hermitian_solver_archetype.h"
#include "support/meshes.h"

namespace cgp_test::harmonic_basis_archetypes_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Harmonic_basis_of_archetypes, needs_no_more_than_the_concepts_offer)
{
  const cgp_test::Mesh_view view = cgp_test::btorus(6);
  const archetype::Triangle_mesh mesh = cgp_test::archetype_of(view);
  const auto forms = CGP::harmonic_basis(
      mesh, CGP::parameters::vertex_point_map(cgp_test::Point_map_archetype(view))
                .geom_traits(cgp_test::Geometry_traits_archetype(cgp_test::archetype_unit))
                .sparse_solver(cgp_test::Sparse_hermitian_solver_traits_archetype()));
  EXPECT_TRUE((std::is_same_v<decltype(forms)::Vector, Eigen::Vector3d>));
  const CGP::Harmonic_basis expected = CGP::Hodge_decomposition(view).harmonic_basis();
  for (const auto f : faces(mesh)) {
    const auto number = static_cast<int>(f.number);
    const Eigen::Vector3d v = get(forms.tangent_field(1), f);
    EXPECT_LT((v - expected.fields[1].col(number)).norm(), 1e-12);
    EXPECT_NEAR(get(forms.one_form(1), halfedge(f, mesh)),
                CGP::along_halfedge(view, expected.one_forms.col(1), 3 * number + 2), 1e-13);
  }
}

}  // namespace cgp_test::harmonic_basis_archetypes_tests
