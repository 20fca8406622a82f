// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Exact_steps.h
#include <Conformal_geometry_processing/mesh/Boundary_frames.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <vector>

#include "../flow/bounded_flows.h"

namespace cgp_test::exact_steps_boundary_tests {

using CGP::Curvature_potential;

Curvature_potential wave(const Mesh_view& mesh, double amplitude)
{
  Eigen::VectorXd rho(mesh.size_of_vertices());
  for (int v = 0; v < rho.size(); ++v) {
    const Eigen::Vector3d p = mesh.position(v);
    rho[v] = amplitude * (std::sin(3 * p.x() + 1) * std::cos(2 * p.y()) + .5 * std::sin(4 * p.z()));
  }
  return Curvature_potential::on_vertices(rho);
}

CGP::Spin_result transformed(const Mesh_view& mesh, const Boundary_condition& condition,
                             const Curvature_potential& rho,
                             CGP::Spin_transformation_options options = {})
{
  options.boundary = condition;
  return CGP::Spin_transformation(mesh, options, "f").transform(rho);
}

double distortion(const CGP::Spin_result& result)
{
  return result.report.conformality.quasi_conformal.mean - 1;
}

/// the tangents of the image of a plane surface under z + 0.3 z^2, which is conformal
Boundary_condition tangents_of_image(const Mesh_view& mesh)
{
  const CGP::internal::Boundary_frames b = CGP::boundary_frames(mesh);
  Points targets(3, static_cast<Eigen::Index>(b.vertices.size()));
  for (std::size_t k = 0; k < b.vertices.size(); ++k) {
    const Eigen::Vector3d p = mesh.position(b.vertices[k]), t = b.tangent(k);
    const std::complex<double> z(p.x(), p.y());
    const std::complex<double> image = (1. + .6 * z) * std::complex<double>(t.x(), t.y());
    targets.col(static_cast<Eigen::Index>(k)) << image.real(), image.imag(), 0;
  }
  return Boundary_condition::tangents(targets);
}

TEST(Exact_steps_with_boundary, of_a_disk_are_a_single_one_to_the_bit)
{
  const Mesh_view mesh = bumpy_cap(8);
  const Boundary_condition condition = Boundary_condition::binormals();
  const CGP::Spin_result expected = CGP::Spin_transformation(mesh, {condition}).step(wave(mesh, 1));
  const CGP::Spin_result result = transformed(mesh, condition, wave(mesh, 1));
  EXPECT_EQ(result.positions, expected.positions);
  EXPECT_EQ(result.report.steps, 1);
}

TEST(Exact_steps_with_boundary, does_not_shear_an_annulus)
{
  const Mesh_view mesh = bumpy_annulus(8);
  CGP::Spin_transformation_options plain;
  plain.exactness.reset();
  for (const Boundary_condition& condition :
       {Boundary_condition::binormals(), Boundary_condition::tangents(),
        Boundary_condition::free()}) {
    const CGP::Spin_result result = transformed(mesh, condition, wave(mesh, 1));
    EXPECT_TRUE(result.report);
    EXPECT_EQ(result.report.reached, 1);
    EXPECT_LE(result.report.period_defect, std::max(.25 * distortion(result), .002));
    EXPECT_GT(result.report.missing_share, .01);
    EXPECT_LT(result.report.missing_share, .9);
    EXPECT_LT(distortion(result), .05);
    EXPECT_LT(distortion(result), distortion(transformed(mesh, condition, wave(mesh, 1), plain)));
  }
}

TEST(Spin_transformation_with_boundary, is_as_before_if_new_positions_fold_the_boundary)
{
  const Mesh_view mesh = bumpy_annulus(4);
  CGP::Spin_transformation transformation(mesh, {Boundary_condition::binormals()});
  const CGP::Spin_result expected = transformation.transform(wave(mesh, .5));
  const CGP::internal::Boundary_frames b = CGP::boundary_frames(mesh);
  Points folded = mesh.positions();
  // A vertex between two that coincide has no tangent.
  folded.col(b.loops[0][3]) = folded.col(b.loops[0][1]);
  folded.col(b.loops[0][2]) += Eigen::Vector3d(0, 0, .05);
  EXPECT_THROW(transformation.set_positions(folded), CGP::Precondition_error);
  EXPECT_EQ(transformation.positions(), mesh.positions());
  EXPECT_EQ(transformation.transform(wave(mesh, .5)).positions, expected.positions);
}

TEST(Exact_steps_with_boundary, tell_the_error_of_directions_from_end_to_end)
{
  const Mesh_view mesh = bumpy_annulus(6);
  for (const bool is_mollified : {false, true}) {
    CGP::Spin_transformation_options options{Boundary_condition::binormals()};
    options.max_period_defect = .001;
    if (is_mollified) options.mollification = 1e-6;
    CGP::Spin_transformation transformation(mesh, options);
    const CGP::Spin_result result = transformation.transform(wave(mesh, 2));
    ASSERT_TRUE(result.report);
    ASSERT_GT(result.report.steps, 2);
    const CGP::internal::Boundary_frames before = CGP::boundary_frames(mesh),
                                         after = CGP::boundary_frames(
                                             Mesh_view(result.positions, mesh.corners()));
    double greatest = 0;
    for (std::size_t k = 0; k < before.vertices.size(); ++k)
      greatest = std::max(greatest, (before.binormal(k) - after.binormal(k)).norm());
    EXPECT_GT(greatest, .02);  // of the steps together
    EXPECT_NEAR(result.report.direction_error.max, greatest, .1 * greatest);
    EXPECT_EQ(transformation.transform(wave(mesh, 2)).positions, result.positions);
  }
}

TEST(Exact_steps_with_boundary, takes_as_many_steps_as_the_tolerance_wants)
{
  const Mesh_view mesh = bumpy_annulus(6);
  CGP::Spin_transformation_options options;
  options.max_period_defect = .002;
  const CGP::Spin_result result =
      transformed(mesh, Boundary_condition::binormals(), wave(mesh, 2), options);
  EXPECT_TRUE(result.report);
  EXPECT_GT(result.report.steps, 2);
  EXPECT_LE(result.report.period_defect, .002);
  EXPECT_NEAR(area({result.positions, mesh.corners()}), area(mesh), 1e-9 * area(mesh));
}

TEST(Exact_steps_with_boundary, counts_constants_where_they_have_an_effect)
{
  const Mesh_view mesh = bumpy_annulus(6);
  const auto one =
      Curvature_potential::on_vertices(Eigen::VectorXd::Constant(mesh.size_of_vertices(), .5));
  const CGP::Spin_result result = transformed(mesh, Boundary_condition::tangents(), one);
  EXPECT_TRUE(result.report);
  EXPECT_GT(result.report.missing_share, 1e-3);
  EXPECT_LT(result.report.missing_share, 1);
  EXPECT_GT(CGP::mean_curvature(Mesh_view(result.positions, mesh.corners())).mean(),
            CGP::mean_curvature(mesh).mean() + .1);
}

TEST(Exact_steps_with_boundary, turns_both_loops_of_an_annulus)
{
  const Mesh_view mesh = annulus(.4, 1, 96, 8);
  const CGP::Spin_result result =
      transformed(mesh, tangents_of_image(mesh), CGP::no_potential(mesh));
  EXPECT_TRUE(result.report) << to_string(result.report.boundary_fault);
  EXPECT_EQ(result.report.steps, 1);
  EXPECT_LT(result.report.direction_error.mean, .005);
  EXPECT_LT(distortion(result), .05);
}

TEST(Exact_steps_with_boundary, says_why_a_boundary_cannot_be)
{
  const Mesh_view mesh = annulus(.4, 1, 48, 4);
  Boundary_condition condition = tangents_of_image(mesh);
  for (Eigen::Index k = 0; k < condition.targets.cols(); ++k) condition.targets.col(k) << 1, 0, 0;
  const CGP::Spin_result result = transformed(mesh, condition, CGP::no_potential(mesh));
  EXPECT_FALSE(result.report);
  EXPECT_NE(result.report.boundary_fault, CGP::Spin_report::Boundary_fault::none);
}

}  // namespace cgp_test::exact_steps_boundary_tests
