// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/canonical_metric.h
#include "concepts/archetype_maps.h"

#include <Conformal_geometry_processing/canonical_metric.h>

#include <gtest/gtest.h>

#include "concepts/Sparse_hermitian_solver_archetype.h"
#include "support/meshes.h"

namespace cgp_test::canonical_metric_archetypes_tests {

namespace CGP = Conformal_geometry_processing;

/// all that is known of it: it is made from a number, on purpose
struct Density {
  explicit Density(double value_) : value(value_) {}
  explicit operator double() const { return value; }
  double value;
};

template <class Key>
using Density_map = Writable_map_archetype<Key, Density, Eigen::VectorXd>;

TEST(Canonical_metric_of_archetypes, needs_no_more_than_the_concepts_offer)
{
  const Mesh_view view = btorus(6);
  const archetype::Triangle_mesh mesh = archetype_of(view);
  const auto np = CGP::parameters::vertex_point_map(Point_map_archetype(view))
                      .geom_traits(Geometry_traits_archetype(archetype_unit))
                      .sparse_solver(Sparse_hermitian_solver_traits_archetype());
  Eigen::VectorXd on_faces(view.size_of_faces()), on_vertices(view.size_of_vertices());
  EXPECT_NEAR(CGP::canonical_metric(mesh, Density_map<archetype::Face>(on_faces), np).area, 1,
              1e-10);
  (void)CGP::canonical_metric(mesh, Density_map<archetype::Vertex>(on_vertices), np);
  const Eigen::VectorXd u =
      CGP::canonical_area_density(view, CGP::Hodge_decomposition(view).harmonic_basis().one_forms);
  EXPECT_LT((on_faces - u).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT(
      (on_vertices.cwiseProduct(CGP::vertex_areas(view)) - CGP::canonical_vertex_areas(view, u))
          .cwiseAbs()
          .maxCoeff(),
      1e-12);
}

}  // namespace cgp_test::canonical_metric_archetypes_tests
