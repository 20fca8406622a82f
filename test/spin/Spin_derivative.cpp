// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests operators/dirac_energy.h spin/Spin_residual.h spin/Poisson_reconstruction.h
#include <Conformal_geometry_processing/spin/Spin_derivative.h>
#include <Conformal_geometry_processing/spin/Spin_residual.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "support/meshes.h"

namespace cgp_test::spin_derivative_tests {

/// The derivative of transformations against differences of transformations, and its transpose
/// against itself: on coarse irregular surfaces, where an approximate derivative would be off by
/// percents.

namespace CGP = Conformal_geometry_processing;
using On = CGP::Curvature_potential::On;
using Boundary = CGP::Boundary_condition;

struct Case {
  std::string name;
  Mesh_view mesh;
  On on;
  double amplitude;  // of rho
  CGP::Spin_transformation_options options = {};
};

std::vector<Case> cases()
{
  std::vector<Case> all{
      {"sphere", perturbed(icosphere(2), .05), On::vertices, 1},
      {"sphere, faces", perturbed(icosphere(2), .05), On::faces, 2},
      {"torus", btorus(12), On::vertices, 1},
      {"far from the origin",
       mapped(perturbed(icosphere(1), .1),
              [](const Eigen::Vector3d& p) { return Eigen::Vector3d(8 * p.array() + 9); }),
       On::vertices, .1},
      {"intrinsic triangulation", perturbed(icosphere(2), .15), On::faces, 1},
      {"free disk", jittered_disk(6, .2), On::vertices, 1},
      {"tangents", jittered_disk(6, .2), On::vertices, .5},
      {"binormals", jittered_disk(6, .2), On::vertices, .5}};
  all[4].options.mollification = 1e-6;
  all[6].options.boundary = Boundary::tangents();
  all[7].options.boundary = Boundary::binormals();
  return all;
}

Eigen::VectorXd without_mean(Eigen::VectorXd v)
{
  v.array() -= v.mean();
  return v;
}

/// a transformation with its derivative; directions of rho are random
class Derivative {
 public:
  explicit Derivative(const Case& c)
      : transformation(c.mesh, c.options),
        m_rho{c.on, Eigen::VectorXd(c.on == On::vertices ? c.mesh.size_of_vertices()
                                                         : c.mesh.size_of_faces())}
  {
    for (int i = 0; i < m_rho.values.size(); ++i) {
      const Eigen::Vector3d p = c.mesh.position(c.on == On::vertices ? i : c.mesh.corners(i)[0]);
      m_rho.values[i] = c.amplitude * (std::sin(3 * p.y()) + .5 * p.x());
    }
    direction = random_numbers(static_cast<int>(m_rho.values.size()), 3);
    found = at(0);
    Eigen::VectorXd potential = m_rho.values;
    if (system().is_closed()) potential.array() += found.report.eigenvalue;
    spins.emplace(system(), CGP::Curvature_potential{c.on, potential * unit()}, found.lambda,
                  1e-12);
    positions.emplace(system(), transformation.reconstruction(), transformation.domain().measured(),
                      found.lambda, transformation.domain().frame().to_frame(found.positions));
  }

  CGP::Spin_result at(double t)
  {
    transformation.dirac().tolerance = 1e-13;
    CGP::Spin_result r = transformation.step({m_rho.on, m_rho.values + t * direction});
    EXPECT_TRUE(r.report.converged) << r.report.residual;
    return r;
  }

  const CGP::internal::Dirac_system& system() { return transformation.system(); }
  double unit() const { return transformation.domain().unit(); }

  CGP::Spin_transformation transformation;
  Eigen::VectorXd direction;
  CGP::Spin_result found;
  std::optional<CGP::internal::Spin_derivative> spins;
  std::optional<CGP::internal::Position_derivative> positions;

 private:
  CGP::Curvature_potential m_rho;
};

TEST(Spin_derivative, is_the_limit_of_differences)
{
  const double step = 1e-4;
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    Derivative d(c);
    const CGP::Spin_result after = d.at(step), before = d.at(-step);
    d.at(0);  // whose factor the derivative uses
    const Quaternion_vector<double> dlambda = d.spins->apply(d.direction * d.unit()).col(0);
    const Eigen::VectorXd u =
        without_mean(CGP::internal::log_scale_change(d.found.lambda, dlambda).col(0));
    const Eigen::VectorXd du = without_mean(
        (CGP::internal::log_scales(after.lambda) - CGP::internal::log_scales(before.lambda)) /
        (2 * step));
    EXPECT_LT((u - du).norm(), 1e-6 * du.norm());
    const Points f = d.unit() * d.positions->apply(dlambda);
    const Points df = (after.positions - before.positions) / (2 * step);
    EXPECT_LT((f - df).norm(), 1e-6 * df.norm());
    if (!d.system().is_closed()) continue;
    const double gamma = d.spins->gamma_change(d.direction * d.unit())[0] / d.unit();
    EXPECT_NEAR(gamma, (after.report.eigenvalue - before.report.eigenvalue) / (2 * step),
                1e-6 * d.direction.norm());
  }
}

TEST(Spin_derivative, has_its_transpose)
{
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    Derivative d(c);
    const int n = c.mesh.size_of_vertices();
    const Quaternion_vector<double> dlambda = d.spins->apply(d.direction).col(0);
    const Eigen::VectorXd y = without_mean(random_numbers(n, 5));
    const Eigen::VectorXd of_scales =
        d.spins->apply_transpose(CGP::internal::log_scale_gradient(d.found.lambda, y));
    const double scales = y.dot(CGP::internal::log_scale_change(d.found.lambda, dlambda).col(0));
    EXPECT_NEAR(d.direction.dot(of_scales), scales, 1e-11 * d.direction.norm() * of_scales.norm());
    Points z(3, n);
    for (int k = 0; k < 3; ++k) z.row(k) = random_numbers(n, 7 + k).transpose();
    const Eigen::VectorXd of_positions = d.spins->apply_transpose(d.positions->apply_transpose(z));
    const double moved = z.cwiseProduct(d.positions->apply(dlambda)).sum();
    EXPECT_NEAR(d.direction.dot(of_positions), moved,
                1e-11 * d.direction.norm() * of_positions.norm());
  }
}

TEST(Spin_derivative, of_constants_is_that_of_gamma_alone)
{
  Derivative d(cases()[0]);
  const Eigen::MatrixXd constant = Eigen::MatrixXd::Ones(d.direction.size(), 1);
  EXPECT_NEAR(d.spins->gamma_change(constant)[0], -1, 1e-12);
  EXPECT_LT(CGP::components(Quaternion_vector<double>(d.spins->apply(constant).col(0))).norm(),
            1e-10 * CGP::components(d.found.lambda).norm());
}

TEST(Spin_derivative, treats_several_columns_like_each)
{
  Derivative d(cases()[2]);
  Eigen::MatrixXd both(d.direction.size(), 2);
  both << d.direction, random_numbers(static_cast<int>(d.direction.size()), 9);
  const auto all = d.spins->apply(both);
  for (int k = 0; k < 2; ++k) {
    const Quaternion_vector<double> one = d.spins->apply(both.col(k)).col(0), other = all.col(k);
    EXPECT_LT((CGP::components(one) - CGP::components(other)).norm(),
              1e-10 * CGP::components(one).norm());
  }
}

}  // namespace cgp_test::spin_derivative_tests
