// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Dirac_line.h
#include <Conformal_geometry_processing/spin/Dirac_line.h>
#include <Conformal_geometry_processing/spin/Spin_derivative.h>
#include <Conformal_geometry_processing/spin/solve_dirac_equation.h>

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <utility>

#include "support/limbs.h"

namespace cgp_test::dirac_line_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;
using CGP::internal::Dirac_solution;

/// the solution for a rho, its derivative along d and the line along d
class Line {
 public:
  Line(const Mesh_view& mesh, Eigen::VectorXd rho, Eigen::VectorXd change)
      : m_system(mesh), m_rho(std::move(rho)), m_change(std::move(change))
  {
    m_at = solved(m_system, 0);
    const Curvature_potential potential =
        Curvature_potential::on_vertices(m_rho.array() + m_at.eigenvalue);
    const CGP::internal::Spin_derivative S(m_system, potential, m_at.lambda);
    m_dlambda = S.apply(m_change).col(0);
    m_line.emplace(m_system, Curvature_potential::on_vertices(m_rho), m_at, m_change, m_dlambda);
  }

  const CGP::internal::Dirac_line& predicted() const { return *m_line; }
  const Dirac_solution& at() const { return m_at; }

  Dirac_solution solved(double t) const
  {
    CGP::internal::Dirac_system another(m_system.surface());
    return solved(another, t);
  }

  Dirac_solution to_first_order(double t) const
  {
    Dirac_solution s = m_at;
    CGP::components(s.lambda) += t * CGP::components(m_dlambda);
    return s;
  }

  double length(const Dirac_solution& s) const
  {
    return std::sqrt(m_system.squared_norm(s.lambda));
  }

  /// the sine of the angle between spins
  double distance(const Dirac_solution& a, const Dirac_solution& b) const
  {
    const double cosine = m_system.overlap(a.lambda, b.lambda);
    return std::sqrt(std::max(0., 1 - cosine * cosine));
  }

 private:
  Dirac_solution solved(CGP::internal::Dirac_system& system, double t) const
  {
    CGP::Dirac_options options;
    options.tolerance = 1e-11;
    const auto rho = Curvature_potential::on_vertices(m_rho + t * m_change);
    Dirac_solution s = CGP::solve_dirac_equation(system, rho, options);
    EXPECT_TRUE(s.converged);
    return s;
  }

  CGP::internal::Dirac_system m_system;
  Eigen::VectorXd m_rho, m_change;
  Dirac_solution m_at;
  Quaternion_vector<double> m_dlambda;
  std::optional<CGP::internal::Dirac_line> m_line;
};

// Near another eigenvalue, the derivative is soon as far from the spins as those of t = 0 are.
TEST(Dirac_line, predicts_spins_on_limbs_where_the_derivative_does_not)
{
  const Mesh_view mesh = dumbbell(3);
  const Line line(mesh, rings(mesh, .5, 3), rings(mesh, .3, 2));
  for (const double t : {.25, .5, 1.}) {
    const auto predicted = line.predicted().at(t);
    ASSERT_TRUE(predicted) << t;
    const Dirac_solution expected = line.solved(t);
    const double error = line.distance(*predicted, expected);
    EXPECT_LT(error, line.distance(line.to_first_order(t), expected) / 5) << t;
    EXPECT_NEAR(predicted->eigenvalue, expected.eigenvalue, 0.01) << t;
  }
}

// It has the derivative in its span, and therefore an error of second order at most.
TEST(Dirac_line, has_the_derivative)
{
  const Mesh_view mesh = perturbed(icosphere(3), .03);
  const Line line(mesh, rings(mesh, .5, 3), rings(mesh, 1, 4));
  EXPECT_LT(line.distance(*line.predicted().at(0), line.at()), 1e-7);
  EXPECT_NEAR(line.predicted().at(0)->eigenvalue, line.at().eigenvalue, 1e-12);
  const auto error = [&](double t) {
    return line.distance(line.predicted().at(t).value(), line.solved(t));
  };
  EXPECT_LT(error(.05), error(.1) / 3.5);
  EXPECT_LT(error(.1), 1.1 * line.distance(line.to_first_order(.1), line.solved(.1)));
}

TEST(Dirac_line, keeps_the_length_of_the_spins)
{
  const Mesh_view mesh = perturbed(icosphere(2), .03);
  const Line line(mesh, rings(mesh, .5, 3), rings(mesh, 1, 4));
  EXPECT_NEAR(line.length(*line.predicted().at(.3)), line.length(line.at()), 1e-12);
  EXPECT_EQ(line.predicted().number_of_solves(), 4);
}

TEST(Dirac_line, does_not_predict_what_has_nothing_in_common)
{
  const Mesh_view mesh = perturbed(icosphere(3), .03);
  const Line line(mesh, rings(mesh, .5, 3), rings(mesh, 60, 4));
  EXPECT_FALSE(line.predicted().at(1));
  EXPECT_TRUE(line.predicted().at(1. / 64));
}

// Where rho does not change the spins, there is no derivative to span anything.
TEST(Dirac_line, along_constants_changes_the_eigenvalue_alone)
{
  const Mesh_view mesh = perturbed(icosphere(2), .03);
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(mesh.size_of_vertices());
  const Line line(mesh, rings(mesh, .5, 3), ones);
  const auto predicted = line.predicted().at(1);
  ASSERT_TRUE(predicted);
  EXPECT_LT(line.distance(*predicted, line.at()), 1e-6);
  EXPECT_NEAR(predicted->eigenvalue, line.at().eigenvalue - 1, 1e-6);
}

}  // namespace cgp_test::dirac_line_tests
