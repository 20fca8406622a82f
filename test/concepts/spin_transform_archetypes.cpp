// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests spin_transform.h, spin/Spin_report.h, dirac_spectrum.h, dirac_sphere.h
#include "concepts/archetype_maps.h"

#include <Conformal_geometry_processing/dirac_spectrum.h>
#include <Conformal_geometry_processing/dirac_sphere.h>
#include <Conformal_geometry_processing/spin_transform.h>

#include <gtest/gtest.h>

#include <optional>

#include "concepts/Sparse_hermitian_eigensolver_archetype.h"
#include "concepts/Sparse_hermitian_solver_archetype.h"
#include "support/dense.h"
#include "support/meshes.h"

namespace cgp_test::spin_transform_archetypes_tests {

namespace params = Conformal_geometry_processing::parameters;
using cgp_test::Geometry_traits_archetype;
using cgp_test::Quaternion;

struct Rho_map {
  using key_type = archetype::Vertex;
  using value_type = double;
  using reference = double;
  using category = boost::readable_property_map_tag;

  explicit Rho_map(const cgp_test::Mesh_view& mesh) : view(&mesh) {}
  const cgp_test::Mesh_view* view;

  friend double get(const Rho_map& map, archetype::Vertex v)
  {
    return cgp_test::rho_of_section_3(map.view->position(static_cast<int>(v.number)));
  }
};

using Spins = cgp_test::Quaternion_vector<double>;
using Spin_map = cgp_test::Writable_map_archetype<archetype::Vertex, Quaternion<double>, Spins>;

/// exactly the concept, and tied to its place
struct Visitor {
  Visitor() = default;
  Visitor(const Visitor&) = delete;
  Visitor& operator=(const Visitor&) = delete;
  void on_iteration(const Conformal_geometry_processing::Eigensolver_progress&) { ++count; }
  bool go_further() { return true; }
  int count = 0;
};

class Spin_transform_with_archetypes : public testing::Test {
 protected:
  template <class NamedParameters>
  void expect_transformation(const NamedParameters& np)
  {
    const auto report = Conformal_geometry_processing::spin_transform(mesh, Rho_map(view), np);
    EXPECT_TRUE(report);
    EXPECT_LT((points - expected.positions).norm(), 1e-6);
    EXPECT_LT(cgp_test::greatest_difference(spins, expected.lambda), 1e-6);
  }

  const cgp_test::Mesh_view view = cgp_test::icosphere(1);
  archetype::Triangle_mesh mesh = cgp_test::archetype_of(view);
  cgp_test::Points points{3, view.size_of_vertices()};
  Spins spins{view.size_of_vertices()};
  const Conformal_geometry_processing::Spin_result expected =
      Conformal_geometry_processing::Spin_transformation(view).transform(
          Conformal_geometry_processing::Curvature_potential::on_vertices(
              cgp_test::rho_of_section_3_on_vertices(view)));
};

TEST_F(Spin_transform_with_archetypes, of_the_mesh_the_maps_the_geometry_and_the_visitor)
{
  Visitor visitor;
  expect_transformation(params::scale_bound(std::nullopt)
                            .vertex_point_map(cgp_test::Point_map_archetype(view))
                            .output_vertex_point_map(cgp_test::Output_map_archetype(points))
                            .vertex_spin_map(Spin_map(spins))
                            .geom_traits(Geometry_traits_archetype(cgp_test::archetype_unit))
                            .visitor(std::ref(visitor)));
  EXPECT_GT(visitor.count, 0);
}

TEST_F(Spin_transform_with_archetypes, of_the_solvers_too)
{
  Conformal_geometry_processing::Dirac_options dirac;
  dirac.eigensolver = cgp_test::Sparse_hermitian_eigensolver_archetype();
  expect_transformation(params::scale_bound(std::nullopt)
                            .vertex_point_map(cgp_test::Point_map_archetype(view))
                            .output_vertex_point_map(cgp_test::Output_map_archetype(points))
                            .vertex_spin_map(Spin_map(spins))
                            .geom_traits(Geometry_traits_archetype(cgp_test::archetype_unit))
                            .sparse_solver(cgp_test::Sparse_hermitian_solver_traits_archetype())
                            .dirac(dirac));
}

TEST_F(Spin_transform_with_archetypes, as_the_spectrum_of_the_surface)
{
  namespace CGP = Conformal_geometry_processing;
  const CGP::internal::Dirac_spectrum s =
      CGP::dirac_spectrum(mesh, 3,
                          params::vertex_point_map(cgp_test::Point_map_archetype(view))
                              .curvature_potential_map(Rho_map(view))
                              .geom_traits(Geometry_traits_archetype(cgp_test::archetype_unit))
                              .sparse_solver(cgp_test::Sparse_hermitian_solver_traits_archetype()));
  const CGP::internal::Dirac_spectrum by_default = CGP::internal::Dirac_spectral_problem(view).find(
      CGP::Curvature_potential::on_vertices(cgp_test::rho_of_section_3_on_vertices(view)), 3);
  ASSERT_TRUE(s.converged);
  EXPECT_LT((s.eigenvalues - by_default.eigenvalues).norm(), 1e-7);
}

TEST_F(Spin_transform_with_archetypes, as_the_Dirac_spheres)
{
  namespace CGP = Conformal_geometry_processing;
  const auto report =
      CGP::dirac_sphere(mesh, -1, 0,
                        params::vertex_point_map(cgp_test::Point_map_archetype(view))
                            .output_vertex_point_map(cgp_test::Output_map_archetype(points))
                            .vertex_spin_map(Spin_map(spins))
                            .geom_traits(Geometry_traits_archetype(cgp_test::archetype_unit))
                            .sparse_solver(cgp_test::Sparse_hermitian_solver_traits_archetype()));
  ASSERT_TRUE(report);
  EXPECT_LT((points - view.positions()).cwiseAbs().maxCoeff(), .05);  // the sphere itself
}

}  // namespace cgp_test::spin_transform_archetypes_tests
