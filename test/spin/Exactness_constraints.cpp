// Tests include/Conformal_geometry_processing/spin/Exactness_constraints.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Exactness_constraints.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <gtest/gtest.h>

#include <optional>

#include "support/handlebodies.h"
#include "support/meshes.h"

namespace cgp_test::exactness_constraints_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Exactness;

/// the constraints of a mesh with all they need around them
struct Followed {
  explicit Followed(const Mesh_view& surface, std::optional<Exactness> version = Exactness::adjoint)
      : mesh(surface), transformation(surface, options(version)), constraints(found())
  {}

  void move_to(const Points& positions)
  {
    mesh.set_positions(positions);
    transformation.set_positions(positions);
    constraints = found();
  }
  CGP::internal::Exactness_constraints found()
  {
    return transformation.exactness(CGP::Curvature_potential::On::vertices);
  }
  static CGP::Spin_transformation_options options(std::optional<Exactness> version)
  {
    CGP::Spin_transformation_options options;
    options.exactness = version;
    return options;
  }

  Mesh_view mesh;
  CGP::Spin_transformation transformation;
  CGP::internal::Exactness_constraints constraints;
};

Eigen::MatrixX3d edges(const Mesh_view& mesh)
{
  Eigen::MatrixX3d e(mesh.size_of_edges(), 3);
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    e.row(k) = (mesh.position(mesh.ends(k)[1]) - mesh.position(mesh.ends(k)[0])).transpose();
  return e;
}

/// the differential of the angle around the z axis: closed, and not exact
Eigen::VectorXd angle_form(const Mesh_view& mesh)
{
  Eigen::VectorXd form(mesh.size_of_edges());
  for (int k = 0; k < mesh.size_of_edges(); ++k) {
    const Eigen::Vector3d a = mesh.position(mesh.ends(k)[0]), b = mesh.position(mesh.ends(k)[1]);
    form[k] = std::atan2(a.x() * b.y() - a.y() * b.x(), a.x() * b.x() + a.y() * b.y());
  }
  return form;
}

TEST(Exactness_constraints, are_six_for_each_handle)
{
  EXPECT_EQ(Followed(torus(2, 1, 12, 8)).constraints.functions.cols(), 6);
  EXPECT_EQ(Followed(smooth_handlebody(2, 1)).constraints.functions.cols(), 12);
}

TEST(Exactness_constraints, are_none_for_spheres)
{
  const Followed sphere(icosphere(1));
  EXPECT_EQ(sphere.constraints.functions.rows(), 42);
  EXPECT_EQ(sphere.constraints.functions.cols(), 0);
  EXPECT_EQ(sphere.constraints.period_defect(Eigen::MatrixX3d::Random(120, 3)), 0);
}

TEST(Exactness_constraints, measure_the_harmonic_part_alone)
{
  const Followed f(torus(2, 1, 30, 20));
  const Eigen::MatrixX3d exact = edges(f.mesh);
  EXPECT_LT(f.constraints.period_defect(exact), 1e-12);
  Eigen::MatrixX3d harmonic = Eigen::MatrixX3d::Zero(exact.rows(), 3);
  harmonic.col(1) = angle_form(f.mesh);  // harmonic by symmetry
  EXPECT_NEAR(f.constraints.period_defect(harmonic), 1, 1e-9);
  EXPECT_NEAR(f.constraints.period_defect(harmonic * 5), 1, 1e-9);
}

TEST(Exactness_constraints, can_be_left_out_while_the_defect_is_measured)
{
  const Followed f(torus(2, 1, 12, 8), std::nullopt);
  EXPECT_EQ(f.constraints.functions.cols(), 0);
  Eigen::MatrixX3d harmonic = Eigen::MatrixX3d::Zero(f.mesh.size_of_edges(), 3);
  harmonic.col(0) = angle_form(f.mesh);
  EXPECT_GT(f.constraints.period_defect(harmonic), 0.9);
}

TEST(Exactness_constraints, follow_a_mesh_that_moves)
{
  for (const Exactness version : {Exactness::adjoint, Exactness::thesis}) {
    const Mesh_view first = torus(2, 1, 16, 12), second = perturbed(first, 0.02);
    Followed moved(first, version);
    const Followed expected(second, version);
    EXPECT_GT((moved.constraints.functions - expected.constraints.functions).norm(), 1e-3);
    moved.move_to(second.positions());
    EXPECT_LT((moved.constraints.functions - expected.constraints.functions).norm(), 1e-8);
    EXPECT_LT(moved.constraints.period_defect(edges(second)), 1e-12);
  }
}

}  // namespace cgp_test::exactness_constraints_tests
