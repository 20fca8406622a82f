// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests spin/gauge.h
// Tests spin/Spin_report.h
#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "support/dense.h"
#include "support/meshes.h"

namespace cgp_test::spin_transformation_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;

Curvature_potential smooth(const Mesh_view& mesh, double amplitude = 1)
{
  return Curvature_potential::on_vertices(amplitude * rho_of_section_3_on_vertices(mesh));
}

Curvature_potential constant(const Mesh_view& mesh, double c)
{
  return Curvature_potential::on_faces(Eigen::VectorXd::Constant(mesh.size_of_faces(), c));
}

double greatest_displacement(const Points& a, const Points& b)
{
  return (a - b).colwise().norm().maxCoeff();
}

Eigen::Vector3d centroid(const Mesh_view& mesh)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    for (int c = 0; c < 3; ++c)
      sum += mesh.double_area_vector(f).norm() / 6 * mesh.position(mesh.corners(f)[at(c)]);
  return sum / area(mesh);
}

std::string refusal(const Mesh_view& mesh, const Curvature_potential& rho)
{
  try {
    (void)CGP::Spin_transformation(mesh, {}, "f").transform(rho);
  } catch (const CGP::Precondition_error& error) {
    return error.what();
  }
  return "";
}

TEST(Spin_transformation, by_rho_zero_leaves_the_surface_as_it_is)
{
  for (const Mesh_view& mesh :
       {radially_perturbed(icosphere(2), 0.2), torus(3, 1, 14, 9), block(2, 1, 3)}) {
    const CGP::Spin_result r = CGP::Spin_transformation(mesh).transform(constant(mesh, 0));
    EXPECT_TRUE(r.report);
    EXPECT_LT(greatest_displacement(r.positions, mesh.positions()), 1e-11);
    EXPECT_NEAR(r.report.conformality.quasi_conformal.max, 1, 1e-11);
    EXPECT_NEAR(r.report.min_spin_ratio, 1, 1e-12);
    EXPECT_LT(r.report.closure_residual, 1e-12);
  }
}

TEST(Spin_transformation, by_constant_rho_leaves_the_surface_as_it_is)
{
  const Mesh_view mesh = radially_perturbed(icosphere(2), 0.1);
  CGP::Spin_transformation transformation(mesh);
  for (const double c : {-0.3, 0.7, 5.}) {
    const CGP::Spin_result r = transformation.transform(constant(mesh, c));
    EXPECT_TRUE(r.report);
    EXPECT_NEAR(r.report.eigenvalue, -c, 1e-6);
    EXPECT_LT(greatest_displacement(r.positions, mesh.positions()), 1e-6);
  }
}

TEST(Spin_transformation, does_not_see_the_mean_of_rho)
{
  const Mesh_view mesh = icosphere(3);
  CGP::Spin_transformation transformation(mesh);
  const auto shifted = [&](double c) {
    Curvature_potential rho = smooth(mesh);
    rho.values.array() += c;
    return transformation.transform(rho);
  };
  const CGP::Spin_result by0 = shifted(0), by01 = shifted(0.1), by1 = shifted(1), by3 = shifted(3);
  EXPECT_LT(greatest_displacement(by01.positions, by0.positions), 0.03);
  EXPECT_LT(greatest_displacement(by1.positions, by0.positions), 0.03);
  EXPECT_LT(greatest_displacement(by3.positions, by1.positions), 1e-7);
}

TEST(Spin_transformation, keeps_area_and_centroid)
{
  const Mesh_view mesh = mapped(radially_perturbed(icosphere(2), 0.05), [](const auto& p) {
    return Eigen::Vector3d(3 * p + Eigen::Vector3d(5, -1, 2));
  });
  Curvature_potential rho = Curvature_potential::on_vertices(0.2 * mesh.positions().row(0));
  const CGP::Spin_result r = CGP::Spin_transformation(mesh).transform(rho);
  const Mesh_view result(r.positions, mesh.corners());
  EXPECT_NEAR(area(result), area(mesh), 1e-11 * area(mesh));
  EXPECT_LT((centroid(result) - centroid(mesh)).norm(), 1e-12);
}

TEST(Spin_transformation, returns_spins_that_turn_and_scale_the_edges_into_the_new_ones)
{
  const Mesh_view mesh = icosphere(3);
  const CGP::Spin_result r = CGP::Spin_transformation(mesh).transform(smooth(mesh));
  double difference = 0, total = 0;
  for (int k = 0; k < mesh.size_of_edges(); ++k) {
    const auto [i, j] = mesh.ends(k);
    const Eigen::Vector3d e = mesh.position(j) - mesh.position(i);
    const Eigen::Vector3d spun = CGP::spin((r.lambda[i] + r.lambda[j]) / 2., e);
    const Eigen::Vector3d found = r.positions.col(j) - r.positions.col(i);
    difference += (found - spun).squaredNorm();
    total += found.squaredNorm();
  }
  EXPECT_LT(std::sqrt(difference / total), 0.01);
  EXPECT_LT(r.report.closure_residual, 0.005);
}

TEST(Spin_transformation, returns_spins_whose_scale_is_that_of_the_new_area)
{
  const Mesh_view mesh = icosphere(3);
  const CGP::Spin_result r = CGP::Spin_transformation(mesh).transform(smooth(mesh));
  const Eigen::VectorXd areas = CGP::vertex_areas(mesh);
  double new_area = 0;  // lengths grow by |lambda|^2
  for (int v = 0; v < mesh.size_of_vertices(); ++v)
    new_area += areas[v] * std::pow(squared_norm(r.lambda[v]), 2);
  EXPECT_NEAR(new_area / area({r.positions, mesh.corners()}), 1, 0.008);
}

TEST(Spin_transformation, sees_no_flip_where_the_surface_turns_by_more_than_a_right_angle)
{
  const Mesh_view mesh = icosphere(3);
  const CGP::Spin_result r = CGP::Spin_transformation(mesh).transform(smooth(mesh, 3));
  int turned = 0;
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    turned += mesh.double_area_vector(f).dot(mesh.double_area_vector(f, r.positions)) < 0;
  EXPECT_GT(turned, 20);
  EXPECT_EQ(r.report.conformality.flipped_faces, 0);
}

TEST(Spin_transformation, report_measures_the_result)
{
  const Mesh_view mesh = icosphere(2);
  CGP::Spin_transformation transformation(mesh);
  const CGP::Spin_result r = transformation.transform(smooth(mesh));
  const CGP::Spin_report& report = r.report;
  EXPECT_TRUE(report);
  EXPECT_TRUE(report.converged);
  EXPECT_FALSE(report.cancelled);
  EXPECT_LE(report.residual, 1e-8);
  EXPECT_NEAR(report.conformality.quasi_conformal.mean,
              CGP::quasi_conformal_error(mesh, r.positions).mean, 1e-12);
  EXPECT_NEAR(report.conformality.scale.max_scale,
              CGP::area_distortion(mesh, r.positions).max_scale, 1e-12);
  EXPECT_EQ(report.conformality.flipped_faces, 0);
  const auto sizes = CGP::components(r.lambda).colwise().norm().eval();
  EXPECT_NEAR(report.min_spin_ratio, sizes.minCoeff() / sizes.maxCoeff(), 1e-12);
  EXPECT_GT(report.gap, 0.5);
  for (const double seconds :
       {report.seconds.setup, report.seconds.assembly, report.seconds.factorization,
        report.seconds.eigenvectors, report.seconds.reconstruction, report.seconds.certificate})
    EXPECT_GT(seconds, 0);
  EXPECT_EQ(report.seconds.exactness, 0);  // on a sphere, nothing has to close
}

TEST(Spin_report_of_a_transformation, converts_to_true_only_when_converged_and_not_cancelled)
{
  CGP::Spin_report report;
  EXPECT_FALSE(report);
  report.converged = true;
  EXPECT_TRUE(report);
  report.cancelled = true;
  EXPECT_FALSE(report);
}

TEST(Spin_transformation, without_convergence_says_so)
{
  const Mesh_view mesh = icosphere(2);
  CGP::Spin_transformation transformation(mesh);
  transformation.dirac().max_iterations = 1;
  EXPECT_FALSE(transformation.transform(smooth(mesh)).report);
  transformation.dirac() = {};
  transformation.dirac().max_substeps = 1;
  EXPECT_FALSE(transformation.transform(smooth(mesh, 6)).report);
  transformation.dirac() = {};
  EXPECT_TRUE(transformation.transform(smooth(mesh)).report);
}

TEST(Spin_transformation, refuses_values_of_rho_that_do_not_fit)
{
  const Mesh_view mesh = icosphere(1);
  EXPECT_EQ(refusal(mesh, Curvature_potential::on_vertices(Eigen::VectorXd::Zero(80))),
            "f: rho has 80 values, one per vertex is needed: 42");
  EXPECT_EQ(refusal(mesh, Curvature_potential::on_faces(Eigen::VectorXd::Zero(42))),
            "f: rho has 42 values, one per face is needed: 80");
  Curvature_potential rho = smooth(mesh);
  rho.values[7] = std::numeric_limits<double>::quiet_NaN();
  rho.values[9] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal(mesh, rho),
            "f: 2 values of rho not finite, the first is vertex 7; finite values are needed");
  rho = constant(mesh, 0);
  rho.values[3] = -std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal(mesh, rho),
            "f: 1 value of rho not finite, the first is face 3; finite values are needed");
}

TEST(Spin_transformation, refuses_surfaces_it_cannot_transform)
{
  const Mesh_view two = disjoint_union(icosahedron(), icosahedron(), {9, 0, 0});
  EXPECT_EQ(refusal(two, smooth(two)),
            "f: the mesh has 2 components, the second begins at vertex 12; one component is "
            "needed, transform each alone");
}

}  // namespace cgp_test::spin_transformation_tests
