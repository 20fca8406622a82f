// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Spin_transformation.h
#include "spin/boundary_cases.h"

namespace cgp_test::spin_transformation_boundary_invariance_tests {

class Invariance_with_a_boundary : public testing::TestWithParam<int> {
 protected:
  CGP::Spin_result result(const Mesh_view& surface, const Boundary_condition& of_boundary,
                          const Eigen::VectorXd& values) const
  {
    CGP::Dirac_options options;
    options.tolerance = 1e-10;
    return transformed(surface, of_boundary, Curvature_potential::on_vertices(values), options);
  }

  /// the result of everything multiplied by s, multiplied by 1/s
  CGP::Spin_result scaled_back(double s) const
  {
    CGP::Spin_result r = result(scaled(mesh, s), cgp_test::scaled(condition, s), rho.values / s);
    r.positions /= s;
    r.report.eigenvalue *= s;
    return r;
  }

  const Mesh_view mesh = uneven_cap();
  const Curvature_potential rho = rho_of_uneven_cap();
  const Boundary_condition condition = conditions_of_uneven_cap()[at(GetParam())];
  const CGP::Spin_result expected = result(mesh, condition, rho.values);
};

std::string name(const testing::TestParamInfo<int>& info)
{
  return std::vector<std::string>{"free", "tangents", "binormals", "mixture",
                                  "positions"}[at(info.param)];
}

INSTANTIATE_TEST_SUITE_P(Of_every_kind, Invariance_with_a_boundary, testing::Range(0, 5), name);

TEST_P(Invariance_with_a_boundary, under_doing_it_again)
{
  CGP::Spin_transformation transformation(mesh, {condition});
  transformation.dirac().tolerance = 1e-10;
  for (int i = 0; i < 2; ++i) {
    const CGP::Spin_result r = transformation.transform(rho);
    EXPECT_EQ(r.positions, expected.positions);
    EXPECT_EQ(r.lambda, expected.lambda);
  }
  const CGP::Spin_result last = std::move(transformation).transform(rho);
  EXPECT_EQ(last.positions, expected.positions);
}

TEST_P(Invariance_with_a_boundary, under_scaling_by_powers_of_two_to_the_last_bit)
{
  for (const int exponent : {-100, -7, 5, 99}) {
    const CGP::Spin_result r = scaled_back(std::ldexp(1., exponent));
    EXPECT_EQ(r.positions, expected.positions) << exponent;
    EXPECT_EQ(r.lambda, expected.lambda);
    EXPECT_EQ(r.report.eigenvalue, expected.report.eigenvalue);
    EXPECT_EQ(r.report.direction_error.max, expected.report.direction_error.max);
  }
}

TEST_P(Invariance_with_a_boundary, under_scaling_by_anything)
{
  for (const double s : {1e-30, .3, 7e15}) {
    const CGP::Spin_result r = scaled_back(s);
    EXPECT_LT((r.positions - expected.positions).cwiseAbs().maxCoeff(), 1e-8) << s;
    EXPECT_NEAR(r.report.eigenvalue, expected.report.eigenvalue, 1e-8);
  }
}

TEST_P(Invariance_with_a_boundary, under_rigid_motion_of_mesh_and_targets)
{
  const Eigen::Matrix3d R = Random(3).rotation();
  const Eigen::Vector3d t(5, -20, 7);
  const auto moved =
      mapped(mesh, [&](const Eigen::Vector3d& p) -> Eigen::Vector3d { return R * p + t; });
  Boundary_condition turned = condition;
  turned.targets = R * condition.targets;
  turned.normals = R * condition.normals;
  if (condition.kind == Boundary_condition::Kind::positions) turned.targets.colwise() += t;
  const CGP::Spin_result r = result(moved, turned, rho.values);
  EXPECT_LT((r.positions - ((R * expected.positions).colwise() + t)).cwiseAbs().maxCoeff(), 1e-7);
  EXPECT_NEAR(r.report.eigenvalue, expected.report.eigenvalue, 1e-7);
}

TEST_P(Invariance_with_a_boundary, under_other_lengths_of_directions_and_normals)
{
  for (const int exponent : {4, -800, 800}) {
    const double factor = std::ldexp(1., exponent);
    Boundary_condition longer = condition;
    longer.normals *= factor;
    if (condition.kind == Boundary_condition::Kind::directions) longer.targets *= factor;
    longer.direction *= factor;
    const CGP::Spin_result r = result(mesh, longer, rho.values);
    EXPECT_LT((r.positions - expected.positions).cwiseAbs().maxCoeff(), 1e-9) << exponent;
  }
}

TEST_P(Invariance_with_a_boundary, under_a_move_of_the_mesh_and_back)
{
  if (condition.kind == Boundary_condition::Kind::positions) return;  // cannot move
  CGP::Spin_transformation transformation(perturbed(mesh, .01, 9), {condition});
  transformation.dirac().tolerance = 1e-10;
  (void)transformation.transform(rho);
  transformation.set_positions(mesh.positions());
  const CGP::Spin_result r = transformation.transform(rho);
  EXPECT_LT((r.positions - expected.positions).cwiseAbs().maxCoeff(), 1e-8);
}

}  // namespace cgp_test::spin_transformation_boundary_invariance_tests
