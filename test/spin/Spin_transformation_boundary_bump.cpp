// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests spin/Spin_transformation.h
// Tests spin/Spin_residual.h
#include "spin/boundary_tools.h"

namespace cgp_test::spin_transformation_boundary_bump_tests {

/// A bump on plane disks, with each condition at the boundary. The numbers come from an
/// implementation of the same formulas that shares no code with this one.

Curvature_potential bump(const Mesh_view& mesh)
{
  return potential_on_faces(mesh, [](const Eigen::Vector3d& p) {
    const double s = .25;
    return 4 * std::exp(-(p - Eigen::Vector3d(.2, .1, 0)).squaredNorm() / (2 * s * s));
  });
}

/// on finer and finer disks
struct Errors {
  std::vector<double> h, Q, cross_ratio;  // Q - 1
};

template <class Disk>
Errors errors(Disk disk, const Boundary_condition& condition)
{
  Errors list;
  for (const int n : {8, 16, 32, 64}) {
    const Mesh_view mesh = disk(n);
    const CGP::Spin_result r = transformed(mesh, condition, bump(mesh));
    EXPECT_TRUE(r.report);
    EXPECT_EQ(r.report.conformality.flipped_faces, 0);
    list.h.push_back(mean_edge_length(mesh));
    list.Q.push_back(mean_Q(r) - 1);
    list.cross_ratio.push_back(r.report.conformality.length_cross_ratio.rms);
  }
  return list;
}

/// of the three finest disks
double fine_slope(const std::vector<double>& h, const std::vector<double>& error)
{
  return slope({h.end() - 3, h.end()}, {error.end() - 3, error.end()});
}

void expect_table(const Errors& all, const std::vector<double>& table)
{
  const std::vector<double>& found = all.Q;
  for (std::size_t i = 0; i < table.size(); ++i)
    EXPECT_NEAR(found[i], table[i] - 1, .02 * (table[i] - 1)) << i;
  EXPECT_NEAR(found[2], table[2] - 1, 5e-4);
  EXPECT_GT(found[2] / found[3], 1.9);
  EXPECT_LT(found[2] / found[3], 2.1);
  EXPECT_NEAR(fine_slope(all.h, all.Q), 1, .05);
  EXPECT_NEAR(fine_slope(all.h, all.cross_ratio), 2, .2);
}

TEST(Spin_transformation_of_a_disk, bulges_with_a_free_boundary_as_tabled)
{
  expect_table(errors(disk, Boundary_condition::free()), {1.03936, 1.02164, 1.01079, 1.00532});
}

TEST(Spin_transformation_of_a_disk, bulges_between_its_tangents_as_tabled)
{
  expect_table(errors(disk, Boundary_condition::tangents()), {1.04139, 1.02149, 1.01081, 1.00540});
}

TEST(Spin_transformation_of_a_disk, bulges_between_its_binormals_as_tabled)
{
  expect_table(errors(disk, Boundary_condition::binormals()), {1.01949, 1.00992, 1.00491, 1.00244});
}

TEST(Spin_transformation_of_a_nonuniform_disk, bulges_with_a_free_boundary_as_tabled)
{
  EXPECT_NEAR(mean_edge_length(moved_disk(8)), .12807, 2e-4);
  EXPECT_NEAR(mean_edge_length(moved_disk(32)), .03211, 2e-4);
  expect_table(errors(moved_disk, Boundary_condition::free()),
               {1.03864, 1.02135, 1.01085, 1.00543});
}

TEST(Spin_transformation_of_a_nonuniform_disk, bulges_between_its_tangents_as_tabled)
{
  expect_table(errors(moved_disk, Boundary_condition::tangents()),
               {1.04563, 1.02372, 1.01194, 1.00597});
}

TEST(Spin_transformation_of_a_nonuniform_disk, bulges_between_its_binormals_as_tabled)
{
  expect_table(errors(moved_disk, Boundary_condition::binormals()),
               {1.02023, 1.01054, 1.00521, 1.00259});
}

TEST(Spin_transformation_with_a_free_boundary, stretches_no_face_much)
{
  const std::vector<double> table = {1.075, 1.056, 1.031, 1.016};
  for (std::size_t i = 0; i < 4; ++i) {
    const Mesh_view mesh = disk(8 << i);
    const CGP::Spin_result r = transformed(mesh, Boundary_condition::free(), bump(mesh));
    EXPECT_NEAR(r.report.conformality.quasi_conformal.max, table[i], .05 * (table[i] - 1));
    EXPECT_GT(r.report.min_spin_ratio, .1);
  }
}

TEST(Spin_transformation_with_a_free_boundary, moves_less_the_smaller_rho_is)
{
  // Not so the vector of smallest singular value, whose surface does not tend to the disk.
  const Mesh_view mesh = disk(12);
  double before = 0;
  for (const double t : {1e-1, 1e-2, 1e-3}) {
    Curvature_potential rho = bump(mesh);
    rho.values *= t;
    const CGP::Spin_result r = transformed(mesh, Boundary_condition::free(), rho);
    const double height = r.positions.row(2).maxCoeff() - r.positions.row(2).minCoeff();
    EXPECT_GT(height, .03 * t);
    if (before > 0) {
      EXPECT_NEAR(before / height, 10, .5);
    }
    before = height;
  }
}

}  // namespace cgp_test::spin_transformation_boundary_bump_tests
