// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests spin/Spin_report.h
#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <gtest/gtest.h>

#include "support/bounded_meshes.h"
#include "support/meshes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace cgp_test::certify_tests {

namespace CGP = Conformal_geometry_processing;
using Quaternions = CGP::Quaternion_vector<double>;
using Boundary_fault = CGP::Spin_report::Boundary_fault;

Quaternions ones(const Mesh_view& mesh)
{
  return Quaternions::Constant(mesh.size_of_vertices(), {1, 0, 0, 0});
}

TEST(Certify, of_a_similarity_finds_no_error)
{
  const Mesh_view mesh = bumpy_sphere(2);
  Quaternions lambda = ones(mesh);
  lambda[3] *= .25;
  CGP::Spin_report report;
  report.converged = true;
  CGP::internal::certify(mesh, 3 * mesh.positions(), lambda, report);
  EXPECT_TRUE(report.converged);
  EXPECT_NEAR(report.conformality.quasi_conformal.max, 1, 1e-6);
  EXPECT_EQ(report.conformality.flipped_faces, 0);
  EXPECT_EQ(report.min_spin_ratio, .25);
}

TEST(Certify, does_not_let_pass_what_is_no_number)
{
  const Mesh_view mesh = icosphere(1);
  Points f = mesh.positions();
  f(1, 5) = std::numeric_limits<double>::quiet_NaN();
  CGP::Spin_report report;
  report.converged = true;
  CGP::internal::certify(mesh, f, ones(mesh), report);
  EXPECT_FALSE(report.converged);
}

class Boundary_fault_of_a_disk : public testing::Test {
 protected:
  Boundary_fault fault(double sigma) const { return CGP::boundary_fault(mesh, sigma, report); }

  const Mesh_view mesh = scaled(disk(20), 7);
  const double radius = std::sqrt(area(mesh) / pi), h = mean_edge_length(mesh) / radius;
  CGP::Spin_report report = [] {
    CGP::Spin_report good;
    good.converged = true;
    good.min_spin_ratio = 1;
    return good;
  }();
};

TEST_F(Boundary_fault_of_a_disk, is_none_where_all_is_well)
{
  EXPECT_EQ(fault(0), Boundary_fault::none);
  EXPECT_TRUE(report);
}

TEST_F(Boundary_fault_of_a_disk, is_in_the_data_if_the_singular_value_is_more_than_edges_explain)
{
  ASSERT_GT(3 * h, .05);
  report.closure_residual = .011;
  EXPECT_EQ(fault(2.9 * h / radius), Boundary_fault::none);
  EXPECT_EQ(fault(3.1 * h / radius), Boundary_fault::not_realizable);
  const Mesh_view fine = disk(70);
  ASSERT_LT(3 * mean_edge_length(fine), .05);
  EXPECT_EQ(CGP::boundary_fault(fine, .049, report), Boundary_fault::none);
  EXPECT_EQ(CGP::boundary_fault(fine, .051, report), Boundary_fault::not_realizable);
}

TEST_F(Boundary_fault_of_a_disk, is_forgiven_where_the_edges_fit_together_nonetheless)
{
  report.closure_residual = .009;
  const Mesh_view fine = scaled(disk(70), 3);
  const double unit = std::sqrt(pi / area(fine));
  EXPECT_EQ(CGP::boundary_fault(fine, .145 * unit, report), Boundary_fault::none);
  EXPECT_EQ(CGP::boundary_fault(fine, .155 * unit, report), Boundary_fault::not_realizable);
}

TEST_F(Boundary_fault_of_a_disk, is_a_gap_if_the_edges_do_not_fit_together)
{
  report.closure_residual = .09;
  EXPECT_EQ(fault(0), Boundary_fault::none);
  report.closure_residual = .11;
  EXPECT_EQ(fault(0), Boundary_fault::does_not_close);
  const Mesh_view coarse = scaled(disk(4), 7);
  const double coarse_h = mean_edge_length(coarse) / std::sqrt(area(coarse) / pi);
  ASSERT_GT(3 * coarse_h * coarse_h, .11);
  EXPECT_EQ(CGP::boundary_fault(coarse, 0, report), Boundary_fault::none);
  report.closure_residual = 2.9 * coarse_h * coarse_h;
  EXPECT_EQ(CGP::boundary_fault(coarse, 0, report), Boundary_fault::none);
  report.closure_residual = 3.1 * coarse_h * coarse_h;
  EXPECT_EQ(CGP::boundary_fault(coarse, 0, report), Boundary_fault::does_not_close);
}

TEST_F(Boundary_fault_of_a_disk, is_a_zero_of_the_spins)
{
  report.min_spin_ratio = .021;
  EXPECT_EQ(fault(0), Boundary_fault::none);
  report.min_spin_ratio = .019;
  EXPECT_EQ(fault(0), Boundary_fault::degenerate);
}

TEST_F(Boundary_fault_of_a_disk, allows_eigenvalues_that_should_be_zero_less_than_misfits)
{
  EXPECT_NEAR(CGP::greatest_zero(mesh) * radius, std::max(h, .05), 1e-12);
  EXPECT_NEAR(CGP::greatest_zero(disk(70)), .05, 1e-3);
  EXPECT_LT(CGP::greatest_zero(mesh), CGP::greatest_misfit(mesh));
}

TEST(Spin_report_boundary_fault, with_a_fault_at_the_boundary_is_false)
{
  CGP::Spin_report report;
  report.converged = true;
  EXPECT_TRUE(report);
  for (const auto fault : {Boundary_fault::not_realizable, Boundary_fault::does_not_close,
                           Boundary_fault::degenerate}) {
    report.boundary_fault = fault;
    report.closure_residual = fault == Boundary_fault::does_not_close ? 0.2 : 0;
    EXPECT_FALSE(report);
    EXPECT_GT(std::string(CGP::to_string(fault)).size(), 10u);
  }
  EXPECT_EQ(std::string(CGP::to_string(Boundary_fault::none)), "none");
}

}  // namespace cgp_test::certify_tests
