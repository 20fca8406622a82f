// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Spin_transformation.h
#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <gtest/gtest.h>

#include <vector>

#include "spin/solved.h"
#include "support/meshes.h"
#include "support/moebius.h"

namespace cgp_test::spin_transformation_convergence_cholmod_tests {

/// The spin transformation of round spheres by a smooth rho, on four meshes. The numbers come from
/// an implementation of the same formulas that shares no code with this one.

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;

struct Expected {
  double gamma, mu, Q_mean, Q_max, willmore, curvature_error;
};

struct Measured {
  double h, gamma, mu, Q_mean, Q_max, willmore, predicted_willmore, curvature_error;
  double cross_ratio, closure;
};

/// |H~ |lambda|^2 - (H + rho + gamma)| / |H + rho + gamma| at the vertices, in L2
double curvature_error(const Mesh_view& sphere, const CGP::Spin_result& r, double sign)
{
  const Eigen::VectorXd areas = CGP::voronoi_areas(sphere);
  const Eigen::VectorXd rho = rho_of_section_3_on_vertices(sphere);
  const Eigen::VectorXd H = CGP::mean_curvature(Mesh_view(r.positions, sphere.corners()));
  double difference = 0, total = 0;
  for (int v = 0; v < sphere.size_of_vertices(); ++v) {
    const double expected = 1 + sign * (rho[v] + r.report.eigenvalue);
    difference += areas[v] * std::pow(H[v] * squared_norm(r.lambda[v]) - expected, 2);
    total += areas[v] * expected * expected;
  }
  return std::sqrt(difference / total);
}

double predicted_willmore(const Mesh_view& sphere, double gamma)
{
  const Eigen::ArrayXd H = 1 + rho_of_section_3_on_vertices(sphere).array() + gamma;
  return CGP::voronoi_areas(sphere).dot(H.square().matrix());
}

Measured measure(const Mesh_view& sphere, const Curvature_potential& rho)
{
  CGP::Spin_transformation transformation(sphere);
  const CGP::Spin_result r = transformation.transform(rho);
  const CGP::Conformality& c = r.report.conformality;
  EXPECT_TRUE(r.report);
  EXPECT_EQ(r.report.substeps, 1);
  EXPECT_EQ(c.flipped_faces, 0);
  return {mean_edge_length(sphere),
          r.report.eigenvalue,
          solved(sphere, rho).energy + r.report.eigenvalue * r.report.eigenvalue,
          c.quasi_conformal.mean,
          c.quasi_conformal.max,
          CGP::willmore_energy(Mesh_view(r.positions, sphere.corners())),
          predicted_willmore(sphere, r.report.eigenvalue),
          curvature_error(sphere, r, 1),
          c.length_cross_ratio.rms,
          r.report.closure_residual};
}

void expect_near_relatively(double value, double expected, double tolerance)
{
  EXPECT_NEAR(value, expected, tolerance * std::abs(expected));
}

std::vector<double> column(const std::vector<Measured>& rows, double Measured::*field,
                           double offset = 0)
{
  std::vector<double> values;
  for (const Measured& row : rows) values.push_back(row.*field - offset);
  return values;
}

void expect_table(const std::vector<Measured>& rows, const std::vector<Expected>& table)
{
  for (std::size_t i = 0; i < table.size(); ++i) {
    SCOPED_TRACE("icosphere " + std::to_string(i + 2));
    // The table is of X(rho), the result of X(rho + gamma): they differ by the discretisation
    // error.
    const double squared = std::pow(4., -double(i));  // h^2, relative to the coarsest mesh
    expect_near_relatively(rows[i].gamma, table[i].gamma, 1e-6 + 2e-3 * squared * squared);
    expect_near_relatively(rows[i].mu, table[i].mu, 1e-6 + 4e-3 * squared);
    expect_near_relatively(rows[i].Q_mean - 1, table[i].Q_mean - 1, 1e-4 + 5e-3 * squared);
    expect_near_relatively(rows[i].Q_max - 1, table[i].Q_max - 1, 1e-4 + 5e-3 * squared);
    expect_near_relatively(rows[i].willmore, table[i].willmore, 1e-4 + 1e-4 * squared);
    expect_near_relatively(rows[i].curvature_error, table[i].curvature_error, 0.05);
  }
}

/// icosphere 5, which is tabled with fewer digits
void expect_finest(const Measured& row, double Q_mean, double Q_max)
{
  expect_near_relatively(row.gamma, -0.033112, 2e-5);
  expect_near_relatively(row.Q_mean - 1, Q_mean, 1e-4);
  expect_near_relatively(row.Q_max - 1, Q_max, 4e-4);
}

void expect_orders(const std::vector<Measured>& rows)
{
  const std::vector<double> h = column(rows, &Measured::h);
  const double Q_slope = slope(h, column(rows, &Measured::Q_mean, 1));
  EXPECT_GE(Q_slope, 0.95);
  EXPECT_LE(Q_slope, 1.05);
  EXPECT_NEAR(slope(h, column(rows, &Measured::cross_ratio)), 2, 0.2);
  EXPECT_GE(slope(h, column(rows, &Measured::closure)), 1.8);
  EXPECT_GE(slope(h, column(rows, &Measured::curvature_error)), 1.6);
  const double limit = -0.033132;  // of gamma, extrapolated from the finest meshes of the table
  EXPECT_GE(slope(h, column(rows, &Measured::gamma, limit)), 1.8);
  const Measured& finest = rows.back();
  EXPECT_NEAR(finest.willmore / finest.predicted_willmore, 1, 2e-3);
}

/// The change of mean curvature by the inversion of a torus of radii 2 and 1
Eigen::VectorXd rho_of_inversion(const Mesh_view& mesh, const Eigen::Vector3d& center)
{
  Eigen::VectorXd rho(mesh.size_of_vertices());
  for (int v = 0; v < mesh.size_of_vertices(); ++v) {
    const Eigen::Vector3d p = mesh.position(v), q = p - center;
    const Eigen::Vector3d N = p - 2 * Eigen::Vector3d(p.x(), p.y(), 0).normalized();
    rho[v] = -2 * q.dot(N) / q.squaredNorm();
  }
  return rho;
}

TEST(Spin_transformation, converges_as_tabled_for_rho_on_vertices)
{
  std::vector<Measured> rows;
  for (int level = 2; level <= 5; ++level) {
    const Mesh_view sphere = icosphere(level);
    rows.push_back(
        measure(sphere, Curvature_potential::on_vertices(rho_of_section_3_on_vertices(sphere))));
  }
  expect_table(rows,
               {{-0.0316385232, 0.004883014329, 1.054251999, 1.095775631, 13.9634795, 6.7e-02},
                {-0.03280656968, 0.0021887702, 1.028802727, 1.053328636, 14.7394774, 1.8e-02},
                {-0.03305347308, 0.001381131749, 1.014557272, 1.027315175, 14.9666139, 5.0e-03}});
  expect_finest(rows.back(), 7.282e-3, 1.367e-2);
  expect_orders(rows);
}

TEST(Spin_transformation, converges_as_tabled_for_rho_on_faces)
{
  std::vector<Measured> rows;
  for (int level = 2; level <= 5; ++level) {
    const Mesh_view sphere = icosphere(level);
    rows.push_back(
        measure(sphere, Curvature_potential::on_faces(rho_of_section_3_on_faces(sphere))));
  }
  expect_table(rows,
               {{-0.03185043025, 0.005494322951, 1.057190738, 1.101785985, 14.1976709, 3.8e-02},
                {-0.03282044626, 0.002231510497, 1.029175303, 1.0543131, 14.8157704, 1.1e-02},
                {-0.03305390739, 0.001383861056, 1.014602842, 1.0274077, 14.9870136, 3.4e-03}});
  expect_finest(rows.back(), 7.288e-3, 1.367e-2);
  expect_orders(rows);
}

TEST(Spin_transformation, turns_positive_rho_into_more_mean_curvature)
{
  const Mesh_view sphere = icosphere(3);
  CGP::Spin_transformation transformation(sphere);
  const CGP::Spin_result r = transformation.transform(
      Curvature_potential::on_vertices(rho_of_section_3_on_vertices(sphere)));
  EXPECT_LT(curvature_error(sphere, r, 1), 0.03);
  EXPECT_GT(curvature_error(sphere, r, -1), 0.8);
}

TEST(Spin_transformation, by_the_curvature_of_an_inversion_inverts_a_torus)
{
  const Eigen::Vector3d center(1, 1, 5);
  std::vector<double> h, Q, cross_ratio, shape;
  for (const int n : {16, 32, 64}) {
    const Mesh_view mesh = torus(2, 1, 2 * n, n);
    // The inversion is a single transformation, exact up to the discretisation.
    const CGP::Spin_result r = CGP::Spin_transformation(mesh).step(
        Curvature_potential::on_vertices(rho_of_inversion(mesh, center)));
    h.push_back(mean_edge_length(mesh));
    Q.push_back(r.report.conformality.quasi_conformal.mean - 1);
    cross_ratio.push_back(r.report.conformality.length_cross_ratio.rms);
    shape.push_back(CGP::align(r.positions, inverted(mesh, center).positions()).rms);
  }
  EXPECT_NEAR(slope(h, Q), 1, 0.05);
  EXPECT_NEAR(slope(h, cross_ratio), 2, 0.2);
  EXPECT_NEAR(slope(h, shape), 2, 0.2);
}

}  // namespace cgp_test::spin_transformation_convergence_cholmod_tests
