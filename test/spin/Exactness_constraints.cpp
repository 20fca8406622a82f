// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Exactness_constraints.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <gtest/gtest.h>

#include "support/handlebodies.h"
#include "support/meshes.h"
#include "support/random.h"

#include <optional>

namespace cgp_test::exactness_constraints_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Exactness;
using Conformal_geometry_processing::Spin_report;
using Conformal_geometry_processing::internal::Period_limit;

constexpr int n = 50;

Eigen::VectorXd some_areas()
{
  return (random_numbers(n, 1).array() + 2).matrix();
}

Eigen::MatrixXd random_functions(int k, std::uint64_t seed)
{
  return Eigen::Map<const Eigen::MatrixXd>(random_numbers(n * k, seed).eval().data(), n, k);
}

double product(const Eigen::VectorXd& a, const Eigen::VectorXd& b)
{
  return (some_areas().array() * a.array() * b.array()).sum();
}

TEST(Constraint_basis, leaves_nothing_along_any_group)
{
  const Eigen::MatrixXd a = random_functions(3, 2), b = 1e-6 * random_functions(4, 3);
  CGP::internal::Constraint_basis basis(some_areas());
  basis.add(a);
  basis.add(b);
  EXPECT_EQ(basis.rank(), 7);
  const Eigen::VectorXd v = basis.project_out(random_numbers(n, 4));
  EXPECT_GT(basis.norm(v), 1);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(product(a.col(k), v), 0, 1e-12);
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(product(b.col(k), v), 0, 1e-18);
}

TEST(Constraint_basis, takes_away_what_lies_in_it_and_nothing_else)
{
  const Eigen::MatrixXd a = random_functions(3, 2);
  CGP::internal::Constraint_basis basis(some_areas());
  basis.add(a);
  EXPECT_LT(basis.norm(basis.project_out(a * Eigen::Vector3d(1, -2, 3))), 1e-13);
  const Eigen::VectorXd v = basis.project_out(random_numbers(n, 4));
  const Eigen::VectorXd both = v + a * Eigen::Vector3d(5, 0, 1);
  EXPECT_LT((basis.project_out(both) - v).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(Constraint_basis, drops_what_depends_on_other_functions)
{
  const Eigen::MatrixXd a = random_functions(3, 2);
  Eigen::MatrixXd b = 1e-6 * random_functions(2, 3);
  CGP::internal::Constraint_basis basis(some_areas());
  basis.add(a);
  basis.add(a.col(0) - 2 * a.col(2) + 1e-5 * random_functions(1, 5));
  EXPECT_EQ(basis.rank(), 3);
  b.col(1) = b.col(0);
  basis.add(b);
  EXPECT_EQ(basis.rank(), 4);
}

TEST(Constraint_basis, is_empty_at_first)
{
  const CGP::internal::Constraint_basis basis(some_areas());
  const Eigen::VectorXd v = random_numbers(n, 4);
  EXPECT_EQ(basis.rank(), 0);
  EXPECT_EQ(basis.project_out(v), v);
  EXPECT_NEAR(basis.norm(v), std::sqrt(product(v, v)), 1e-13);
}

TEST(Constraint_basis, refuses_functions_of_another_size)
{
  CGP::internal::Constraint_basis basis(some_areas());
  EXPECT_THROW(basis.add(Eigen::MatrixXd::Ones(n + 1, 1)), CGP::Precondition_error);
}

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

Spin_report distorted_by(double distortion)
{
  Spin_report report;
  report.conformality.quasi_conformal.mean = 1 + distortion;
  return report;
}

TEST(Period_limit, is_what_is_given)
{
  for (const double distortion : {0., .04, 3.})
    EXPECT_EQ((Period_limit{.004, 1e-8}(distorted_by(distortion))), .004);
}

TEST(Period_limit, falls_with_the_discretisation_error_otherwise)
{
  const Period_limit limit{{}, 1e-8};
  for (const double distortion : {.06, .04, .02}) {
    EXPECT_LE(limit(distorted_by(distortion)), .25 * distortion * (1 + 1e-9));
    EXPECT_NEAR(limit(distorted_by(distortion)) / limit(distorted_by(distortion / 2)), 2, 1e-9);
  }
}

TEST(Period_limit, is_neither_below_two_per_mille_nor_above_two_per_cent)
{
  const Period_limit limit{{}, 1e-8};
  EXPECT_EQ(limit(distorted_by(0)), .002);
  EXPECT_EQ((Period_limit{{}, .003}(distorted_by(0))), .003);
  EXPECT_EQ(limit(distorted_by(3)), .02);
}

}  // namespace cgp_test::exactness_constraints_tests
