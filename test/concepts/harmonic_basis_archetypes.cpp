// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/harmonic_basis.h
#include "concepts/triangle_mesh_archetype.h"

#include <Conformal_geometry_processing/harmonic_basis.h>

#include <gtest/gtest.h>

#include <type_traits>

#include "concepts/Sparse_hermitian_solver_archetype.h"
#include "concepts/geometry_traits_archetype.h"
#include "support/meshes.h"

namespace {

namespace CGP = Conformal_geometry_processing;
using cgp_test::Geometry_traits_archetype;
using cgp_test::Point_archetype;

const double unit = 8;  // of the geometry traits

/// readable, by value, not default constructible
struct Point_map {
  using key_type = archetype::Vertex;
  using value_type = Point_archetype;
  using reference = Point_archetype;
  using category = boost::readable_property_map_tag;

  explicit Point_map(const cgp_test::Mesh_view& mesh) : view(&mesh) {}
  const cgp_test::Mesh_view* view;

  friend Point_archetype get(const Point_map& map, archetype::Vertex v)
  {
    const Eigen::Vector3d p = map.view->position(static_cast<int>(v.number));
    return Geometry_traits_archetype(unit).construct_point_3_object()(p.x(), p.y(), p.z());
  }
};

}  // namespace

TEST(Harmonic_basis_of_archetypes, needs_no_more_than_the_concepts_offer)
{
  const cgp_test::Mesh_view view = cgp_test::btorus(6);
  archetype::Triangle_mesh mesh{cgp_test::at(view.size_of_vertices()), {}};
  for (const auto& v : view.corners())
    mesh.corners.push_back({cgp_test::at(v[0]), cgp_test::at(v[1]), cgp_test::at(v[2])});
  const auto forms = CGP::harmonic_basis(
      mesh, CGP::parameters::vertex_point_map(Point_map(view))
                .geom_traits(Geometry_traits_archetype(unit))
                .sparse_solver(cgp_test::Sparse_hermitian_solver_traits_archetype()));
  EXPECT_TRUE((std::is_same_v<decltype(forms)::Vector, Eigen::Vector3d>));
  const CGP::Harmonic_basis expected = CGP::Hodge_decomposition<>(view).harmonic_basis();
  for (const auto f : faces(mesh)) {
    const auto number = static_cast<int>(f.number);
    const Eigen::Vector3d v = get(forms.tangent_field(1), f);
    EXPECT_LT((v - expected.fields[1].col(number)).norm(), 1e-12);
    EXPECT_NEAR(get(forms.one_form(1), halfedge(f, mesh)),
                CGP::along_halfedge(view, expected.one_forms.col(1), 3 * number + 2), 1e-13);
  }
}
