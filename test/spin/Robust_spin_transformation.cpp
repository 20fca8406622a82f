// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
// Tests spin/Robust_spin_transformation.h, spin/report_of_solution.h, spin/require_potential.h
#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/spin/Robust_spin_transformation.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "support/bounded_meshes.h"
#include "support/dense.h"
#include "support/meshes.h"
#include "support/thin_faces.h"

namespace {

using namespace cgp_test;
namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;
using Robust = CGP::Robust_spin_transformation<>;

Curvature_potential rho_of(const Mesh_view& mesh)
{
  return Curvature_potential::on_vertices(rho_of_section_3_on_vertices(mesh));
}

template <class Call>
std::string message_of(Call call)
{
  try {
    call();
  } catch (const CGP::Precondition_error& error) {
    return error.what();
  }
  return "not refused";
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST(Robust_spin_transformation, of_a_Delaunay_mesh_is_the_spin_transformation)
{
  const Mesh_view mesh = icosphere(2);
  for (const bool on_faces : {false, true}) {
    const Curvature_potential rho =
        on_faces ? Curvature_potential::on_faces(rho_of_section_3_on_faces(mesh)) : rho_of(mesh);
    const CGP::Spin_result expected = CGP::Spin_transformation<>(mesh).transform(rho),
                           result = Robust(mesh).transform(rho);
    EXPECT_TRUE(result.report);
    EXPECT_LT((result.positions - expected.positions).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT(greatest_difference(result.lambda, expected.lambda), 1e-9);
    EXPECT_NEAR(result.report.eigenvalue, expected.report.eigenvalue, 1e-9);
    EXPECT_NEAR(result.report.closure_residual, expected.report.closure_residual, 1e-9);
    EXPECT_NEAR(result.report.conformality.quasi_conformal.max,
                expected.report.conformality.quasi_conformal.max, 1e-8);
  }
}

TEST(Robust_spin_transformation, makes_of_a_spoilt_mesh_the_same_shape)
{
  const Mesh_view clean = icosphere(4);
  const CGP::Spin_result expected = CGP::Spin_transformation<>(clean).transform(rho_of(clean));
  ASSERT_TRUE(expected.report);
  for (const Mesh_view& mesh : {with_thin_faces(clean, 1e-9), spoilt(clean)}) {
    EXPECT_THROW(CGP::require_positive_areas(spoilt(clean), "test"), CGP::Precondition_error);
    const CGP::Spin_result result = Robust(mesh).transform(rho_of(mesh));
    EXPECT_TRUE(result.report);
    const Points old_vertices = result.positions.leftCols(clean.size_of_vertices());
    EXPECT_LT(CGP::align(old_vertices, expected.positions).max, 1e-3);
    EXPECT_NEAR(result.report.eigenvalue, expected.report.eigenvalue, 1e-3);
    EXPECT_LT(result.report.conformality.quasi_conformal.mean, 1.015);
    EXPECT_EQ(result.report.conformality.flipped_faces, 0);
  }
}

TEST(Robust_spin_transformation, finds_the_branch_of_a_strong_rho_in_steps_as_the_other_does)
{
  const Mesh_view clean = icosphere(3), mesh = with_thin_faces(clean, 0, 1e-3);
  const auto strong = [](const Mesh_view& m) {
    return Curvature_potential::on_vertices(3 * rho_of(m).values.array() + .8);
  };
  const CGP::Spin_result expected = CGP::Spin_transformation<>(clean).transform(strong(clean)),
                         result = Robust(mesh).transform(strong(mesh));
  EXPECT_TRUE(result.report);
  EXPECT_NEAR(result.report.eigenvalue, expected.report.eigenvalue, 1e-3);
  const Points old_vertices = result.positions.leftCols(clean.size_of_vertices());
  EXPECT_LT(CGP::align(old_vertices, expected.positions).max, 1e-3);
}

TEST(Robust_spin_transformation, does_not_depend_on_scale_or_position)
{
  const Mesh_view mesh = spoilt(icosphere(2));
  const CGP::Spin_result expected = Robust(mesh).transform(rho_of(mesh));
  const double scale = std::ldexp(1., 40);
  Points p = scale * mesh.positions();
  p.row(1).array() += 8 * scale;
  const CGP::Spin_result result =
      Robust(Mesh_view(p, mesh.corners()))
          .transform(Curvature_potential::on_vertices(rho_of(mesh).values / scale));
  EXPECT_NEAR(result.report.eigenvalue * scale, expected.report.eigenvalue, 1e-6);
  const Points back = (result.positions.colwise() - Eigen::Vector3d(0, 8 * scale, 0)) / scale;
  EXPECT_LT((back - expected.positions).cwiseAbs().maxCoeff(), 1e-5);
}

TEST(Robust_spin_transformation, stops_when_it_is_told_to)
{
  const Mesh_view mesh = icosphere(1);
  const CGP::Spin_result result =
      Robust(mesh).transform(rho_of(mesh), {}, [](const CGP::Eigen_progress&) { return false; });
  EXPECT_TRUE(result.report.cancelled);
  EXPECT_FALSE(result.report);
}

TEST(Robust_spin_transformation, refuses_what_is_no_closed_surface_and_wrong_numbers)
{
  EXPECT_TRUE(contains(message_of([] { Robust{disk(3)}; }), "boundary"));
  EXPECT_TRUE(contains(message_of([] { Robust{Mesh_view()}; }), "no faces"));
  const Mesh_view mesh = icosphere(1);
  const Mesh_view line(mesh.positions().array().colwise() * Eigen::Array3d(1, 0, 0),
                       mesh.corners());
  EXPECT_TRUE(contains(message_of([&] { Robust{line}; }), "all faces have area zero"));
  for (const double mollification : {0., 1., std::numeric_limits<double>::quiet_NaN()})
    EXPECT_TRUE(contains(message_of([&] { Robust{mesh, mollification}; }), "between 0 and 1"));
  Robust transformation(mesh, 1e-6, "caller");
  Eigen::VectorXd rho = Eigen::VectorXd::Zero(mesh.size_of_vertices());
  EXPECT_TRUE(contains(
      message_of([&] { (void)transformation.transform(Curvature_potential::on_faces(rho)); }),
      "caller: rho has 42 values"));
  rho[4] = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(contains(
      message_of([&] { (void)transformation.transform(Curvature_potential::on_vertices(rho)); }),
      "vertex 4"));
}
