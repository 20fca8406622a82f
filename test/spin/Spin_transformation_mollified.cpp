// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Spin_transformation.h
// Tests include/Conformal_geometry_processing/operators/Curvature_potential.h
#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "support/bounded_meshes.h"
#include "support/dense.h"
#include "support/meshes.h"
#include "support/thin_faces.h"

namespace cgp_test::spin_transformation_mollified_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;
using Transformation = CGP::Spin_transformation;

CGP::Spin_transformation_options mollified(const CGP::Boundary_condition& condition = {},
                                           double share = 1e-6)
{
  CGP::Spin_transformation_options options;
  options.boundary = condition;
  options.mollification = share;
  return options;
}

Curvature_potential rho_of(const Mesh_view& mesh)
{
  return Curvature_potential::on_vertices(rho_of_section_3_on_vertices(mesh));
}

Curvature_potential smooth_rho(const Mesh_view& mesh, double strength)
{
  Eigen::VectorXd rho(mesh.size_of_vertices());
  for (int v = 0; v < rho.size(); ++v) {
    const Eigen::Vector3d p = mesh.position(v);
    rho[v] = strength * (std::sin(2 * p.x() + 1) * std::cos(1.5 * p.y()) + p.z() / 2);
  }
  return Curvature_potential::on_vertices(rho);
}

/// with a strength of rho that is possible with it
struct Condition {
  CGP::Boundary_condition condition;
  double strength;
};

/// free, the tangents kept, the binormals, the positions
std::vector<Condition> conditions(const Mesh_view& mesh)
{
  const CGP::internal::Boundary_frames frames = CGP::boundary_frames(mesh);
  CGP::Boundary_condition tangents, binormals, positions;
  tangents.kind = binormals.kind = CGP::Boundary_condition::Kind::directions;
  tangents.direction = {1, 0, 0};
  binormals.direction = {0, 0, 1};
  Points p(3, static_cast<Eigen::Index>(frames.vertices.size())), n = p;
  for (Eigen::Index k = 0; k < p.cols(); ++k) {
    p.col(k) = mesh.position(frames.vertices[static_cast<std::size_t>(k)]);
    n.col(k) = frames.normal(static_cast<std::size_t>(k));
  }
  positions = CGP::Boundary_condition::positions(p, n);
  return {{{}, .2}, {tangents, .5}, {binormals, .5}, {positions, .05}};
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

TEST(Mollified_spin_transformation, of_a_Delaunay_mesh_is_the_spin_transformation)
{
  const Mesh_view mesh = icosphere(2);
  for (const bool on_faces : {false, true}) {
    const Curvature_potential rho =
        on_faces ? Curvature_potential::on_faces(rho_of_section_3_on_faces(mesh)) : rho_of(mesh);
    Transformation usual(mesh), of_lengths(mesh, mollified());
    usual.dirac().tolerance = of_lengths.dirac().tolerance = 1e-10;
    const CGP::Spin_result expected = usual.transform(rho), result = of_lengths.transform(rho);
    EXPECT_TRUE(result.report);
    EXPECT_LT((result.positions - expected.positions).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT(greatest_difference(result.lambda, expected.lambda), 1e-9);
    EXPECT_NEAR(result.report.eigenvalue, expected.report.eigenvalue, 1e-9);
    EXPECT_NEAR(result.report.closure_residual, expected.report.closure_residual, 1e-9);
    EXPECT_NEAR(result.report.min_spin_ratio, expected.report.min_spin_ratio, 1e-9);
    EXPECT_NEAR(result.report.conformality.quasi_conformal.max,
                expected.report.conformality.quasi_conformal.max, 1e-8);
  }
}

TEST(Mollified_spin_transformation, makes_of_a_spoilt_mesh_the_same_shape)
{
  const Mesh_view clean = icosphere(4);
  const CGP::Spin_result expected = Transformation(clean).transform(rho_of(clean));
  ASSERT_TRUE(expected.report);
  for (const Mesh_view& mesh : {with_thin_faces(clean, 1e-9), spoilt(clean)}) {
    EXPECT_THROW(CGP::require_positive_areas(spoilt(clean), "test"), CGP::Precondition_error);
    const CGP::Spin_result result = Transformation(mesh, mollified()).transform(rho_of(mesh));
    EXPECT_TRUE(result.report);
    const Points old_vertices = result.positions.leftCols(clean.size_of_vertices());
    EXPECT_LT(CGP::align(old_vertices, expected.positions).max, 1e-3);
    EXPECT_NEAR(result.report.eigenvalue, expected.report.eigenvalue, 1e-3);
    EXPECT_LT(result.report.conformality.quasi_conformal.mean, 1.015);
    EXPECT_EQ(result.report.conformality.flipped_faces, 0);
  }
}

TEST(Mollified_spin_transformation, finds_the_branch_of_a_strong_rho_in_steps_as_the_other_does)
{
  const Mesh_view clean = icosphere(3), mesh = with_thin_faces(clean, 0, 1e-3);
  const auto strong = [](const Mesh_view& m) {
    return Curvature_potential::on_vertices(3 * rho_of(m).values.array() + .8);
  };
  const CGP::Spin_result expected = Transformation(clean).transform(strong(clean)),
                         result = Transformation(mesh, mollified()).transform(strong(mesh));
  EXPECT_TRUE(result.report);
  EXPECT_NEAR(result.report.eigenvalue, expected.report.eigenvalue, 1e-3);
  const Points old_vertices = result.positions.leftCols(clean.size_of_vertices());
  EXPECT_LT(CGP::align(old_vertices, expected.positions).max, 1e-3);
}

TEST(Mollified_spin_transformation, does_not_depend_on_scale_or_position)
{
  const Mesh_view mesh = spoilt(icosphere(2));
  const CGP::Spin_result expected = Transformation(mesh, mollified()).transform(rho_of(mesh));
  const double scale = std::ldexp(1., 40);
  Points p = scale * mesh.positions();
  p.row(1).array() += 8 * scale;
  const CGP::Spin_result result =
      Transformation(Mesh_view(p, mesh.corners()), mollified())
          .transform(Curvature_potential::on_vertices(rho_of(mesh).values / scale));
  EXPECT_NEAR(result.report.eigenvalue * scale, expected.report.eigenvalue, 1e-6);
  const Points back = (result.positions.colwise() - Eigen::Vector3d(0, 8 * scale, 0)) / scale;
  EXPECT_LT((back - expected.positions).cwiseAbs().maxCoeff(), 1e-5);
}

TEST(Mollified_spin_transformation, stops_when_it_is_told_to)
{
  const Mesh_view mesh = icosphere(1);
  const CGP::Spin_result result =
      Transformation(mesh, mollified())
          .transform(rho_of(mesh), [](const CGP::Eigensolver_progress&) { return false; });
  EXPECT_TRUE(result.report.cancelled);
  EXPECT_FALSE(result.report);
}

TEST(Mollified_spin_transformation, of_a_Delaunay_mesh_with_boundary_is_the_spin_transformation)
{
  const Mesh_view mesh = moved_disk(6);
  for (const Condition& condition : conditions(mesh)) {
    const Curvature_potential rho = smooth_rho(mesh, condition.strength);
    const CGP::Spin_result expected = Transformation(mesh, {condition.condition}).transform(rho);
    const CGP::Spin_result result =
        Transformation(mesh, mollified(condition.condition)).transform(rho);
    EXPECT_TRUE(expected.report && result.report);
    EXPECT_EQ(result.report.mollification.flipped_edges, 0);
    EXPECT_LT((result.positions - expected.positions).cwiseAbs().maxCoeff(), 1e-8);
    EXPECT_NEAR(result.report.eigenvalue, expected.report.eigenvalue, 1e-8);
    EXPECT_NEAR(result.report.closure_residual, expected.report.closure_residual, 1e-9);
    EXPECT_NEAR(result.report.direction_error.max, expected.report.direction_error.max, 1e-8);
  }
}

TEST(Mollified_spin_transformation, makes_of_a_spoilt_mesh_with_boundary_the_same_shape)
{
  const Mesh_view clean = moved_disk(18);
  for (const Condition& condition : conditions(clean)) {
    const CGP::Spin_result expected = Transformation(clean, {condition.condition})
                                          .transform(smooth_rho(clean, condition.strength));
    ASSERT_TRUE(expected.report);
    for (const Mesh_view& mesh : {with_thin_faces(clean, 0), spoilt(clean)}) {
      const CGP::Spin_result result = Transformation(mesh, mollified(condition.condition))
                                          .transform(smooth_rho(mesh, condition.strength));
      EXPECT_TRUE(result.report);
      EXPECT_GT(result.report.mollification.thin_faces, 100);
      const Points old_vertices = result.positions.leftCols(clean.size_of_vertices());
      EXPECT_LT(CGP::align(old_vertices, expected.positions).max, 1e-3);
      EXPECT_LT(result.report.conformality.quasi_conformal.mean, 1.01);
      EXPECT_EQ(result.report.conformality.flipped_faces, 0);
    }
  }
}

TEST(Mollified_spin_transformation, cannot_move_a_prescribed_boundary_or_to_no_surface)
{
  const Mesh_view mesh = disk(3);
  Transformation fixed(mesh, mollified(conditions(mesh).back().condition)), free(mesh, mollified());
  EXPECT_TRUE(
      contains(message_of([&] { fixed.set_positions(mesh.positions()); }), "prescribed boundary"));
  const Points few = mesh.positions().leftCols(3), none = 0 * mesh.positions();
  EXPECT_TRUE(
      contains(message_of([&] { free.set_positions(few); }), "3 positions, one per vertex"));
  EXPECT_TRUE(contains(message_of([&] { free.set_positions(none); }), "area zero"));
  Points bad = mesh.positions();
  bad(0, 0) = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(contains(message_of([&] { free.set_positions(bad); }), "not finite"));
  EXPECT_EQ(free.positions(), mesh.positions());
  EXPECT_EQ(free.domain().surface().size_of_vertices(), mesh.size_of_vertices());
}

TEST(Mollified_spin_transformation, measures_the_faces_that_are_not_thin)
{
  const Mesh_view clean = icosphere(2), mesh = with_thin_faces(clean, 1e-3);
  const auto whole =
      Transformation(clean, mollified()).transform(rho_of(clean)).report.mollification;
  EXPECT_EQ(whole.measured_faces, clean.size_of_faces());
  EXPECT_EQ(whole.measured_area, 1);
  const int thin = mesh.size_of_vertices() - clean.size_of_vertices();
  const CGP::Spin_result result = Transformation(mesh, mollified()).transform(rho_of(mesh));
  const auto& part = result.report.mollification;
  EXPECT_EQ(part.measured_faces, mesh.size_of_faces() - thin);
  EXPECT_GT(part.measured_area, 1 - 1e-3);
  EXPECT_LT(part.measured_area, 1);
  // The measurements of the report agree with the faces of the result, whose area is preserved.
  const Mesh_view sound = CGP::well_shaped_faces(mesh).mesh;
  const auto Q = CGP::quasi_conformal_error(sound, result.positions);
  EXPECT_NEAR(result.report.conformality.quasi_conformal.mean, Q.mean, 1e-9);
  EXPECT_NEAR(result.report.conformality.quasi_conformal.max, Q.max, 1e-9);
  EXPECT_NEAR(CGP::face_areas(Mesh_view(result.positions, sound.corners())).sum(),
              CGP::face_areas(sound).sum(), 1e-9);
}

TEST(Mollified_spin_transformation, measures_its_time_and_takes_generators_along)
{
  const Mesh_view mesh = torus(1, .4, 12, 8);
  Transformation transformation(mesh, mollified());
  const Eigen::MatrixXd forms =
      transformation.exactness(Curvature_potential::On::vertices).forms->one_forms();
  EXPECT_EQ(forms.rows(), transformation.domain().surface().size_of_edges());
  EXPECT_EQ(forms.cols(), 2);
  const auto seconds = transformation.transform(rho_of(mesh)).report.seconds;
  EXPECT_GT(seconds.setup, 0);
  EXPECT_GT(seconds.reconstruction, 0);
  EXPECT_GT(seconds.certificate, 0);
}

TEST(Mollified_spin_transformation, refuses_what_is_no_surface_and_wrong_numbers)
{
  EXPECT_TRUE(contains(message_of([] { Transformation(Mesh_view(), mollified()); }), "no faces"));
  const Mesh_view mesh = icosphere(1);
  const Mesh_view line(mesh.positions().array().colwise() * Eigen::Array3d(1, 0, 0),
                       mesh.corners());
  EXPECT_TRUE(
      contains(message_of([&] { Transformation(line, mollified()); }), "all faces have area zero"));
  for (const double share : {0., 1., std::numeric_limits<double>::quiet_NaN()})
    EXPECT_TRUE(contains(message_of([&] { Transformation(mesh, mollified({}, share)); }),
                         "between 0 and 1"));
  Transformation transformation(mesh, mollified(), "caller");
  Eigen::VectorXd rho = Eigen::VectorXd::Zero(mesh.size_of_vertices());
  EXPECT_TRUE(contains(
      message_of([&] { (void)transformation.transform(Curvature_potential::on_faces(rho)); }),
      "caller: rho has 42 values"));
  rho[4] = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(contains(
      message_of([&] { (void)transformation.transform(Curvature_potential::on_vertices(rho)); }),
      "vertex 4"));
}

}  // namespace cgp_test::spin_transformation_mollified_tests
