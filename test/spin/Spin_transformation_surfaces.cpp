// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Spin_transformation.h
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>

#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "spin/boundary_cases.h"
#include "support/dense.h"
#include "support/meshes.h"

namespace cgp_test::spin_transformation_surfaces_tests {

/// What does not depend on whether the surface is the mesh or, with mollification, its intrinsic
/// Delaunay triangulation.

using Transformation = CGP::Spin_transformation;

CGP::Spin_transformation_options options_with(std::optional<double> mollification,
                                              const Boundary_condition& condition = {})
{
  CGP::Spin_transformation_options options;
  options.boundary = condition;
  options.mollification = mollification;
  return options;
}

const std::optional<double> shares[] = {std::nullopt, 1e-6};

Curvature_potential waves(const Mesh_view& mesh, double strength)
{
  return potential_on_vertices(mesh, [=](const Eigen::Vector3d& p) {
    return strength * (std::sin(p.x() + 1) * std::cos(p.y()) + p.z() / 2);
  });
}

void expect_same_bits(const CGP::Spin_result& a, const CGP::Spin_result& b)
{
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.lambda, b.lambda);
  EXPECT_EQ(a.report.eigenvalue, b.report.eigenvalue);
  EXPECT_EQ(a.report.closure_residual, b.report.closure_residual);
  EXPECT_EQ(a.report.steps, b.report.steps);
  EXPECT_EQ(a.report.iterations, b.report.iterations);
}

/// both to 1e-10 on a mesh that is Delaunay
void expect_agreement(const Mesh_view& mesh, const Curvature_potential& rho,
                      const Boundary_condition& condition = {})
{
  Transformation usual(mesh, options_with(shares[0], condition)),
      mollified(mesh, options_with(shares[1], condition));
  usual.dirac().tolerance = mollified.dirac().tolerance = 1e-12;
  const CGP::Spin_result a = usual.transform(rho), b = mollified.transform(rho);
  EXPECT_TRUE(a.report && b.report);
  EXPECT_EQ(b.report.mollification.flipped_edges, 0);
  EXPECT_LT((a.positions - b.positions).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_LT(greatest_difference(a.lambda, b.lambda), 1e-10);
  EXPECT_NEAR(a.report.eigenvalue, b.report.eigenvalue, 1e-10);
}

TEST(Spin_transformation_surfaces, is_reusable_on_a_torus)
{
  const Mesh_view mesh = torus(3, 1, 48, 24);
  const Curvature_potential rho = waves(mesh, .3);
  for (const std::optional<double>& mollification : shares) {
    Transformation transformation(mesh, options_with(mollification));
    const CGP::Spin_result first = transformation.transform(rho);
    EXPECT_TRUE(first.report);
    EXPECT_GT((first.positions - mesh.positions()).colwise().norm().maxCoeff(), .1);
    EXPECT_LT(first.report.period_defect, .002);
    EXPECT_LT(mean_Q(first), 1.15);
    EXPECT_EQ(transformation.positions(), mesh.positions());
    expect_same_bits(transformation.transform(rho), first);
    Transformation fresh(mesh, options_with(mollification));
    expect_same_bits(std::move(fresh).transform(rho), first);
    transformation.set_positions(perturbed(mesh, .01).positions());
    EXPECT_NE(transformation.transform(rho).positions, first.positions);
    transformation.set_positions(mesh.positions());
    expect_same_bits(transformation.transform(rho), first);
  }
}

TEST(Spin_transformation_surfaces, is_reusable_on_an_annulus)
{
  const Mesh_view mesh = annulus(.4, 1, 36, 8);
  const Curvature_potential rho = waves(mesh, .5);
  for (const std::optional<double>& mollification : shares)
    for (const Boundary_condition& condition :
         {Boundary_condition::free(), Boundary_condition::binormals()}) {
      Transformation transformation(mesh, options_with(mollification, condition));
      const CGP::Spin_result first = transformation.transform(rho);
      EXPECT_TRUE(first.report.converged);
      expect_same_bits(transformation.transform(rho), first);
      expect_same_bits(Transformation(mesh, options_with(mollification, condition)).transform(rho),
                       first);
    }
}

TEST(Spin_transformation_surfaces, is_as_before_after_it_was_cancelled_on_a_torus)
{
  const Mesh_view mesh = torus(3, 1, 24, 12);
  const Curvature_potential rho = waves(mesh, .3);
  for (const std::optional<double>& mollification : shares) {
    Transformation transformation(mesh, options_with(mollification));
    const CGP::Spin_result expected = transformation.transform(rho);
    int asked = 0;
    const int half = expected.report.iterations / 2;
    const CGP::Spin_result cancelled = transformation.transform(
        rho, [&](const CGP::Eigensolver_progress&) { return asked++ < half; });
    EXPECT_TRUE(cancelled.report.cancelled);
    EXPECT_FALSE(cancelled.report);
    EXPECT_EQ(transformation.positions(), mesh.positions());
    expect_same_bits(transformation.transform(rho), expected);
  }
}

TEST(Spin_transformation_surfaces, refuses_to_be_called_by_its_own_visitor)
{
  const Mesh_view sphere = icosphere(2), ring = torus(3, 1, 24, 12);
  for (const Mesh_view& mesh : {sphere, ring}) {
    const Curvature_potential rho = waves(mesh, .3);
    CGP::Spin_transformation_options options;
    options.scales.bound = 1.01;  // also in the search for a bounded rho
    Transformation transformation(mesh, options);
    const CGP::Spin_result expected = transformation.transform(rho);
    const std::function<void()> calls[] = {[&] { (void)transformation.transform(rho); },
                                           [&] { (void)std::move(transformation).transform(rho); },
                                           [&] { (void)transformation.step(rho); },
                                           [&] { (void)transformation.integrate(expected.lambda); },
                                           [&] { transformation.set_positions(mesh.positions()); }};
    for (const std::function<void()>& call : calls) {
      int refused = 0;
      const auto catching = [&](const CGP::Eigensolver_progress&) {
        EXPECT_THROW(call(), CGP::Precondition_error);
        ++refused;
        return true;
      };
      expect_same_bits(transformation.transform(rho, catching), expected);
      EXPECT_GT(refused, 0);
      const auto throwing = [&](const CGP::Eigensolver_progress&) {
        call();
        return true;
      };
      EXPECT_THROW((void)transformation.transform(rho, throwing), CGP::Precondition_error);
      expect_same_bits(transformation.transform(rho), expected);
    }
  }
}

TEST(Spin_transformation_surfaces, of_a_sphere_is_a_single_step)
{
  const Mesh_view mesh = icosphere(2);
  for (const std::optional<double>& mollification : shares) {
    Transformation transformation(mesh, options_with(mollification));
    const CGP::Spin_result result = transformation.transform(waves(mesh, 1));
    EXPECT_EQ(result.report.steps, 1);
    EXPECT_EQ(result.report.reached, 1);
    EXPECT_EQ(result.report.missing_share, 0);
    expect_same_bits(transformation.step(waves(mesh, 1)), result);
  }
}

TEST(Spin_transformation_surfaces, without_exactness_is_a_single_step)
{
  const Mesh_view mesh = torus(3, 1, 24, 12);
  for (const std::optional<double>& mollification : shares) {
    CGP::Spin_transformation_options options = options_with(mollification);
    options.exactness = std::nullopt;
    Transformation plain(mesh, options), exact(mesh, options_with(mollification));
    const CGP::Spin_result result = plain.transform(waves(mesh, .3));
    EXPECT_EQ(result.report.steps, 1);
    expect_same_bits(exact.step(waves(mesh, .3)), result);
    const double open = exact.exactness(Curvature_potential::On::vertices)
                            .period_defect(CGP::transformed_edges(mesh, result.lambda));
    EXPECT_GT(open, 20 * exact.transform(waves(mesh, .3)).report.period_defect);
  }
}

TEST(Spin_transformation_surfaces, agrees_on_a_Delaunay_mesh_with_and_without_mollification)
{
  const Mesh_view sphere = icosphere(2);
  expect_agreement(sphere, Curvature_potential::on_vertices(rho_of_section_3_on_vertices(sphere)));
  expect_agreement(sphere, Curvature_potential::on_faces(rho_of_section_3_on_faces(sphere)));
  const Mesh_view mesh = moved_disk(6);
  for (const Boundary_condition& condition :
       {Boundary_condition::free(), Boundary_condition::tangents(),
        Boundary_condition::binormals()})
    expect_agreement(mesh, waves(mesh, .2), condition);
}

// A disk as large as numbers can be, whose image does not fit.
TEST(Spin_transformation_surfaces, has_no_direction_errors_where_coordinates_overflow)
{
  const Mesh_view flat = disk(3);
  Quaternion_vector<double> spins(flat.size_of_vertices());
  for (int v = 0; v < spins.size(); ++v) {
    const Complex root = std::sqrt(1. + .6 * complex_of(flat.position(v)));
    spins[v] = {root.real(), 0, 0, -root.imag()};
  }
  for (const std::optional<double>& mollification : shares)
    for (const double scale : {1e300, .89e308}) {
      const Mesh_view mesh = mapped(flat, [=](const Eigen::Vector3d& p) -> Eigen::Vector3d {
        return scale * (p + Eigen::Vector3d(1, 1, 0));
      });
      const CGP::Spin_report report =
          Transformation(mesh, options_with(mollification, Boundary_condition::tangents()))
              .integrate(spins)
              .report;
      const bool fits = scale < 1e307;
      // Measures of the map overflow for both.
      EXPECT_EQ(report.converged, fits);
      EXPECT_EQ(std::isnan(report.direction_error.mean), !fits);
    }
}

}  // namespace cgp_test::spin_transformation_surfaces_tests
