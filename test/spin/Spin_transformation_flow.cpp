// Tests include/Conformal_geometry_processing/spin/Spin_transformation.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "support/Counted_solver_traits.h"
#include "support/meshes.h"
#include "support/with_solvers.h"

namespace cgp_test::spin_transformation_flow_tests {

namespace CGP = Conformal_geometry_processing;

double greatest_displacement(const Points& a, const Points& b)
{
  return (a - b).colwise().norm().maxCoeff();
}

/// Willmore flow, rho = -tau H, by one object.
class Flow {
 public:
  explicit Flow(const Mesh_view& mesh)
      : m_mesh(mesh), transformation(mesh, with_solvers<Counted_solver_traits>())
  {}

  void step(double tau)
  {
    const CGP::Spin_result result = transformation.transform(
        CGP::Curvature_potential::on_vertices(-tau * CGP::mean_curvature(m_mesh)));
    EXPECT_TRUE(result.report.converged);
    m_mesh.set_positions(result.positions);
  }
  void move() { transformation.set_positions(m_mesh.positions()); }

  const auto& eigensolver() const { return transformation.system().solver(); }
  const auto& poisson_solver() { return transformation.reconstruction().solver().solver(); }
  double energy() const { return CGP::willmore_energy(m_mesh); }
  const Points& positions() const { return m_mesh.positions(); }

 private:
  Mesh_view m_mesh;

 public:
  CGP::Spin_transformation transformation;
};

/// Returns the message, and checks that the object is unchanged
std::string refusal(const Mesh_view& mesh, const Points& positions)
{
  const auto rho = CGP::Curvature_potential::on_vertices(rho_of_section_3_on_vertices(mesh));
  CGP::Spin_transformation transformation(mesh, {}, "f");
  const Points before = transformation.transform(rho).positions;
  try {
    transformation.set_positions(positions);
  } catch (const CGP::Precondition_error& error) {
    EXPECT_TRUE(transformation.transform(rho).positions == before);
    return error.what();
  }
  return "";
}

TEST(Spin_transformation_flow, analyzes_once_for_both_matrices_and_all_steps)
{
  Flow flow(bumpy_sphere(3));
  flow.step(0.1);
  EXPECT_EQ(flow.poisson_solver().ordering(), flow.eigensolver().ordering());
  const int analyses = Counted_solver_traits::analyses();
  for (int step = 0; step < 3; ++step, flow.step(0.1)) flow.move();
  EXPECT_EQ(Counted_solver_traits::analyses(), analyses);
}

TEST(Spin_transformation_flow, reaches_the_round_sphere)
{
  Flow flow(bumpy_sphere(3));
  double energy = flow.energy();
  for (int step = 0; step < 6; ++step, flow.move()) {
    flow.step(1);
    EXPECT_LT(flow.energy(), energy);
    energy = flow.energy();
  }
  Eigen::VectorXd radii = flow.positions().colwise().norm();
  EXPECT_LT((radii.array() / radii.mean() - 1).abs().maxCoeff(), 0.01);
}

TEST(Spin_transformation_flow, starts_from_positions_as_a_new_object_would)
{
  const Mesh_view first = bumpy_sphere(3), second = perturbed(bumpy_sphere(3, -0.2), 0.01);
  for (const double unit : {1., 1e6}) {
    const Mesh_view mesh =
        mapped(second, [unit](const Eigen::Vector3d& p) { return Eigen::Vector3d(unit * p); });
    const auto rho =
        CGP::Curvature_potential::on_vertices(rho_of_section_3_on_vertices(mesh) / unit);
    CGP::Spin_transformation transformation(first), other(mesh);
    transformation.dirac().tolerance = other.dirac().tolerance = 1e-10;
    (void)transformation.transform(rho);
    transformation.set_positions(mesh.positions());
    const CGP::Spin_result moved = transformation.transform(rho);
    const CGP::Spin_result expected = other.transform(rho);
    EXPECT_LT(greatest_displacement(moved.positions, expected.positions), 1e-8 * unit);
    EXPECT_NEAR(moved.report.eigenvalue, expected.report.eigenvalue, 1e-9 / unit);
    EXPECT_NEAR(moved.report.closure_residual, expected.report.closure_residual, 1e-9);
  }
}

TEST(Spin_transformation_flow, refuses_positions_that_are_no_surface_and_stays_as_it_was)
{
  const Mesh_view mesh = bumpy_sphere(2);
  EXPECT_NE(refusal(mesh, Points::Zero(3, 5)).find("f: 5 positions, one per vertex is needed: 162"),
            std::string::npos);
  Points p = mesh.positions();
  p(1, 7) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refusal(mesh, p).find("vertex 7"), std::string::npos);
  p = mesh.positions();
  p.col(mesh.corners(3)[0]) = p.col(mesh.corners(3)[1]);
  EXPECT_NE(refusal(mesh, p).find("of area zero"), std::string::npos);
}

}  // namespace cgp_test::spin_transformation_flow_tests
