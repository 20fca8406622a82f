// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/conformal_parameterization.h
#include "concepts/archetype_maps.h"

#include <Conformal_geometry_processing/conformal_parameterization.h>

#include <gtest/gtest.h>

#include <complex>

#include "support/bounded_meshes.h"

namespace cgp_test::conformal_parameterization_archetypes_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Conformal_parameterization_of_archetypes, needs_no_more_than_the_concepts_offer)
{
  const cgp_test::Mesh_view view = cgp_test::cap_from_disk(cgp_test::disk(4), 2.);
  const archetype::Triangle_mesh mesh = cgp_test::archetype_of(view);
  Eigen::VectorXcd uv(view.size_of_vertices());
  using Map =
      cgp_test::Writable_map_archetype<archetype::Vertex, std::complex<double>, Eigen::VectorXcd>;
  const CGP::Parameterization_report report = CGP::conformal_parameterization(
      mesh, Map(uv),
      CGP::parameters::vertex_point_map(cgp_test::Point_map_archetype(view))
          .geom_traits(cgp_test::Geometry_traits_archetype(cgp_test::archetype_unit)));
  ASSERT_TRUE(report);
  EXPECT_LT((uv - CGP::spectral_parameterization(view).z).cwiseAbs().maxCoeff(), 1e-12);
}

}  // namespace cgp_test::conformal_parameterization_archetypes_tests
