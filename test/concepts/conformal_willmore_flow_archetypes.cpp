// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/conformal_willmore_flow.h
// Tests include/Conformal_geometry_processing/flow/Flow_report.h
#include "concepts/archetype_maps.h"

#include <Conformal_geometry_processing/conformal_willmore_flow.h>

#include <gtest/gtest.h>

#include <functional>

#include "concepts/Sparse_hermitian_eigensolver_archetype.h"
#include "concepts/Sparse_hermitian_solver_archetype.h"
#include "support/meshes.h"

namespace cgp_test::conformal_willmore_flow_archetypes_tests {

namespace CGP = Conformal_geometry_processing;

/// exactly `FlowVisitor`, and tied to its place
struct Visitor {
  Visitor() = default;
  Visitor(const Visitor&) = delete;
  Visitor& operator=(const Visitor&) = delete;
  void on_flow_begin(const Mesh_view&, double) { ++begins; }
  void on_iteration(const CGP::Eigensolver_progress&) { ++iterations; }
  bool go_further() { return true; }
  void on_step_end(const CGP::Flow_step_report&, const Mesh_view&) { ++steps; }
  int begins = 0, iterations = 0, steps = 0;
};

/// exactly `CurvatureDirection`, without an energy and without a default
struct Direction {
  explicit Direction(double speed_) : speed(speed_) {}
  Eigen::VectorXd operator()(const Mesh_view& mesh) const
  {
    return -speed * CGP::mean_curvature(mesh);
  }
  double speed;
};

/// readable, by value
struct Area_map {
  using key_type = archetype::Vertex;
  using value_type = double;
  using reference = double;
  using category = boost::readable_property_map_tag;

  explicit Area_map(const Eigen::VectorXd& areas_) : areas(&areas_) {}
  const Eigen::VectorXd* areas;
  friend double get(const Area_map& map, archetype::Vertex v)
  {
    return (*map.areas)[static_cast<int>(v.number)];
  }
};

// All at once, for every other combination would be compiled for minutes.
TEST(Conformal_willmore_flow_of_archetypes, needs_no_more_than_the_concepts_offer)
{
  const Mesh_view view = bumpy_sphere(1);
  archetype::Triangle_mesh mesh = archetype_of(view);
  Points points(3, view.size_of_vertices());
  Visitor visitor;
  CGP::Flow_options options;
  options.time_step = .5;
  options.max_steps = 2;
  options.surface.exact_conformal_class = false;
  options.balance = CGP::Flow_options::Balance::prescribed;
  options.target_areas = random_numbers(view.size_of_vertices(), 1).array() + 2;
  CGP::Dirac_options dirac;
  dirac.eigensolver = Sparse_hermitian_eigensolver_archetype();
  EXPECT_TRUE(CGP::conformal_willmore_flow(
      mesh, CGP::parameters::vertex_point_map(Point_map_archetype(view))
                .output_vertex_point_map(Output_map_archetype(points))
                .geom_traits(Geometry_traits_archetype(archetype_unit))
                .vertex_target_area_map(Area_map(options.target_areas))
                .number_of_iterations(2)
                .exact_conformal_class(false)
                .curvature_direction(Direction(.5))
                .visitor(std::ref(visitor))
                .sparse_solver(Sparse_hermitian_solver_traits_archetype())
                .dirac(dirac)));
  EXPECT_EQ(visitor.begins, 1);
  EXPECT_EQ(visitor.steps, 2);
  EXPECT_GE(visitor.iterations, 2);
  // half of the direction is half of the step
  CGP::Conformal_willmore_flow expected(view, options);
  EXPECT_TRUE(expected.run());
  EXPECT_LT((points - expected.mesh().positions()).norm(), 1e-6);
  EXPECT_GT((points - view.positions()).norm(), .1);
}

}  // namespace cgp_test::conformal_willmore_flow_archetypes_tests
