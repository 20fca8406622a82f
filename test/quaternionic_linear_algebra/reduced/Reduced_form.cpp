// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Quaternionic_linear_algebra/direct/Ordering.h>
#include <Quaternionic_linear_algebra/direct/sweep_nested_dissection.h>
#include <Quaternionic_linear_algebra/reduced/Reduced_form.h>
#include <Quaternionic_linear_algebra/reduced/Reduced_hermitian_solver.h>

#include <gtest/gtest.h>

#include <numeric>

#include "quaternionic_linear_algebra/reduced_problem.h"

namespace cgp_test::reduced_form_tests {

CGP::internal::Reduced_form form_of(const Mesh_view& mesh, const std::vector<int>& reduced)
{
  const Pattern pattern = CGP::vertex_graph(mesh);
  return CGP::choose_reduced_form(*pattern, {pattern->size(), reduced},
                                  CGP::amd_ordering(*pattern));
}

TEST(Reduced_last, leaves_the_order_of_all_others)
{
  EXPECT_EQ(CGP::reduced_last({4, 2, 0, 3, 1}, {5, {0, 4}}),
            (CGP::internal::Ordering{2, 3, 1, 4, 0}));
}

TEST(Reduced_form, of_disks_and_closed_cylinders_is_quaternionic_with_the_boundary_last)
{
  for (const Mesh_view& mesh : {disk(8), disk(20), cylinder(1, 4, 30, 30)}) {
    const std::vector<int> boundary = vertices_of_boundary(mesh);
    const CGP::internal::Reduced_form form = form_of(mesh, boundary);
    EXPECT_FALSE(form.is_real);
    const std::set<int> last(form.order.end() - static_cast<std::ptrdiff_t>(boundary.size()),
                             form.order.end());
    EXPECT_EQ(last, std::set<int>(boundary.begin(), boundary.end()));
  }
}

TEST(Reduced_form, of_a_narrow_strip_is_real)
{
  const Mesh_view mesh = grid(200, 3, 200, 3);
  EXPECT_TRUE(form_of(mesh, vertices_of_boundary(mesh)).is_real);
}

TEST(Reduced_form, is_real_where_all_rows_are_reduced_and_quaternionic_where_none_is)
{
  const Mesh_view mesh = disk(12);
  std::vector<int> all(static_cast<std::size_t>(mesh.size_of_vertices()));
  std::iota(all.begin(), all.end(), 0);
  EXPECT_TRUE(form_of(mesh, all).is_real);
  EXPECT_FALSE(form_of(mesh, {}).is_real);
}

TEST(Reduced_form, knows_the_cost_of_the_real_matrix)
{
  const Mesh_view mesh = disk(10);
  const Pattern pattern = CGP::vertex_graph(mesh);
  const CGP::internal::Reduced_rows rows(pattern->size(), vertices_of_boundary(mesh));
  const CGP::internal::Ordering order = CGP::amd_ordering(*pattern);
  const double cost = CGP::internal::operations_of_real_form(
      CGP::internal::Supernodal_structure(*pattern, order), rows);
  const double exact = CGP::internal::Supernodal_structure(*CGP::reduced_pattern(*pattern, rows),
                                                           CGP::reduced_ordering(order, rows))
                           .operations();
  EXPECT_NEAR(cost, exact, 0.1 * exact);
}

TEST(Reduced_form, tries_dissection_only_where_that_may_pay_and_keeps_the_cheaper_form)
{
  const Mesh_view mesh = disk(20);
  const Pattern pattern = CGP::vertex_graph(mesh);
  const CGP::internal::Reduced_rows rows(pattern->size(), vertices_of_boundary(mesh));
  const double by_degree = form_of(mesh, vertices_of_boundary(mesh)).cost;
  const double by_dissection =
      CGP::choose_reduced_form(*pattern, rows,
                               CGP::sweep_nested_dissection(*pattern, mesh.positions()))
          .cost;
  const auto cost = [&](const Eigen::Matrix3Xd* positions,
                        const CGP::internal::Ordering_costs& costs) {
    return CGP::choose_reduced_form(*pattern, rows, positions, 1, costs).cost;
  };
  CGP::internal::Ordering_costs never, always;
  never.seconds_per_vertex = 1e9;
  always.seconds_per_vertex = 0;
  EXPECT_EQ(cost(nullptr, always), by_degree);
  EXPECT_EQ(cost(&mesh.positions(), never), by_degree);
  EXPECT_EQ(cost(&mesh.positions(), always), std::min(by_degree, by_dissection));
}

}  // namespace cgp_test::reduced_form_tests
