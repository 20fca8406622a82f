// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Scale_search.h
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Conformal_geometry_processing/spin/Scale_control.h>
#include <Conformal_geometry_processing/spin/Scale_search.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>

#include "support/limbs.h"

namespace cgp_test::scale_search_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;

CGP::Spin_transformation_options bounded_by(std::optional<double> bound)
{
  CGP::Spin_transformation_options options;
  options.scales.bound = bound;
  return options;
}

CGP::Spin_result transformed(const Mesh_view& mesh, const Eigen::VectorXd& rho,
                             const CGP::Spin_transformation_options& options)
{
  CGP::Spin_transformation transformation(mesh, options);
  return transformation.transform(Curvature_potential::on_vertices(rho));
}

TEST(Scale_search, keeps_limbs_within_the_bound)
{
  const Mesh_view mesh = dumbbell(4);
  for (const double frequency : {3., 8.}) {
    const Eigen::VectorXd rho = rings(mesh, .6, frequency);
    const CGP::Spin_result plain = transformed(mesh, rho, bounded_by(100));
    const CGP::Spin_result r = transformed(mesh, rho, bounded_by(2));
    EXPECT_TRUE(r.report) << to_string(r.report.fault());
    const auto& scales = r.report.scales;
    if (frequency == 3.) {
      EXPECT_GT(plain.report.scales.high / plain.report.scales.low, 4.2);
    }
    EXPECT_GE(scales.low, .5);
    EXPECT_LE(scales.high, 2);
    EXPECT_LE(r.report.conformality.quasi_conformal.mean,
              plain.report.conformality.quasi_conformal.mean + 1e-3);
    EXPECT_GE(scales.kept_correlation, frequency > 5 ? .9 : .65);
    EXPECT_EQ(r.report.conformality.flipped_faces, 0);
    EXPECT_EQ(r.report.conformality.scale.collapsed_share, 0);
  }
}

TEST(Scale_search, leaves_alone_what_is_within_the_bound)
{
  const Mesh_view mesh = dumbbell(3);
  const Eigen::VectorXd rho = rings(mesh, .2, 3);
  const CGP::Spin_result plain = transformed(mesh, rho, bounded_by(std::nullopt));
  const CGP::Spin_result r = transformed(mesh, rho, bounded_by(2));
  EXPECT_EQ(r.positions, plain.positions);
  EXPECT_EQ(r.report.scales.weight, 0);
  EXPECT_EQ(r.report.scales.kept_norm, 1);
  EXPECT_GT(r.report.scales.high, 1);
  EXPECT_EQ(plain.report.scales.bound, 0);
}

TEST(Scale_search, leaves_alone_what_has_the_wanted_factors)
{
  const Mesh_view mesh = dumbbell(4);
  const Eigen::VectorXd rho = rings(mesh, .6, 3);
  const CGP::Spin_result plain = transformed(mesh, rho, bounded_by(std::nullopt));
  ASSERT_TRUE(plain.report);
  ASSERT_GT(plain.report.substeps, 1);
  CGP::Spin_transformation_options options = bounded_by(1.5);
  options.scales.factors = components(plain.lambda).colwise().squaredNorm().transpose();
  const CGP::Spin_result r = transformed(mesh, rho, options);
  EXPECT_TRUE(r.positions == plain.positions);
  EXPECT_EQ(r.report.factorizations, plain.report.factorizations);
  EXPECT_NEAR(r.report.scales.excess(), 0, 1e-9);
}

// More of rho than that would be beyond the bound; and what is kept depends continuously on rho.
TEST(Scale_search, comes_up_to_the_bound_without_jumps)
{
  const Mesh_view mesh = dumbbell(3);
  const double step = 1.15;
  double kept = 0;
  for (double amplitude = .5; amplitude < 1.1; amplitude *= step) {
    const CGP::Spin_result r = transformed(mesh, rings(mesh, amplitude, 3), bounded_by(1.5));
    EXPECT_TRUE(r.report) << to_string(r.report.fault());
    const auto& scales = r.report.scales;
    ASSERT_GT(scales.weight, 0);
    EXPECT_LE(scales.excess(), 1);
    EXPECT_GE(scales.excess(), .85) << amplitude;
    const double now = amplitude * scales.kept_norm;  // grows, by no more than the amplitude
    if (kept > 0) {
      EXPECT_NEAR(std::log(now / kept), std::log(step) / 2, .12) << amplitude;
    }
    kept = now;
  }
}

TEST(Scale_search, with_a_smaller_bound_keeps_less)
{
  const Mesh_view mesh = dumbbell(3);
  const Eigen::VectorXd rho = rings(mesh, .6, 5);
  double kept = 1;
  for (const double bound : {3., 1.5, 1.1}) {
    const CGP::Spin_result r = transformed(mesh, rho, bounded_by(bound));
    EXPECT_TRUE(r.report) << to_string(r.report.fault());
    EXPECT_LE(r.report.scales.excess(), 1 + 1e-9);
    EXPECT_LT(r.report.scales.kept_norm, kept + 1e-9);
    kept = r.report.scales.kept_norm;
  }
}

// Rings that the mesh hardly samples: what it cannot represent is left out.
TEST(Scale_search, closes_the_edges)
{
  const Mesh_view mesh = perturbed(icosphere(1), .02);
  const Eigen::VectorXd rho = rings(mesh, 3, 5);
  EXPECT_EQ(transformed(mesh, rho, bounded_by(std::nullopt)).report.fault(),
            CGP::Spin_report::Fault::open);
  const CGP::Spin_result r = transformed(mesh, rho, bounded_by(2));
  EXPECT_TRUE(r.report) << to_string(r.report.fault());
  EXPECT_GT(r.report.scales.kept_correlation, .9);
}

// Powers of two are exact, and constants have no effect.
TEST(Scale_search, depends_neither_on_the_unit_nor_on_constants)
{
  const Mesh_view mesh = dumbbell(3), large = scaled(mesh, 16);
  const Eigen::VectorXd rho = rings(mesh, .6, 4);
  const CGP::Spin_result r = transformed(mesh, rho, bounded_by(1.5));
  const CGP::Spin_result of_large = transformed(large, rho / 16, bounded_by(1.5));
  EXPECT_EQ(of_large.positions, 16 * r.positions);
  const Eigen::VectorXd shifted = rho.array() + 1;
  const CGP::Spin_result other = transformed(mesh, shifted, bounded_by(1.5));
  EXPECT_NEAR(other.report.scales.kept_norm, r.report.scales.kept_norm, 1e-4);
}

TEST(Scale_search, makes_a_part_larger)
{
  const Mesh_view mesh = dumbbell(4);
  CGP::Spin_transformation_options options = bounded_by(1.3);
  options.scales.factors.resize(mesh.size_of_vertices());
  for (int v = 0; v < mesh.size_of_vertices(); ++v)
    options.scales.factors[v] = std::exp2(std::tanh(2 * mesh.position(v).y()) / 2);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(mesh.size_of_vertices());
  const CGP::Spin_result r = transformed(mesh, none, options);
  EXPECT_TRUE(r.report) << to_string(r.report.fault());
  const auto radius = [](const Points& p, bool upper) {
    const Eigen::VectorXd y = (upper ? 1 : -1) * p.row(1).transpose();
    const double end = y.maxCoeff();
    double largest = 0;  // distance from the axis in the outer ball
    for (Eigen::Index v = 0; v < y.size(); ++v)
      if (y[v] > .3 * end) largest = std::max(largest, std::hypot(p(0, v), p(2, v)));
    return largest;
  };
  EXPECT_GT(radius(r.positions, true) / radius(r.positions, false), 1.4);
}

TEST(Scale_search, ignores_places_without_weight)
{
  const Mesh_view mesh = dumbbell(3);
  const Eigen::VectorXd rho = rings(mesh, .6, 3);
  CGP::Spin_transformation_options options = bounded_by(1.5);
  const CGP::Spin_result all = transformed(mesh, rho, options);
  options.scales.weights.resize(mesh.size_of_vertices());
  for (int v = 0; v < mesh.size_of_vertices(); ++v)
    options.scales.weights[v] = mesh.position(v).y() > 0;
  const CGP::Spin_result half = transformed(mesh, rho, options);
  EXPECT_TRUE(all.report);
  EXPECT_TRUE(half.report);
  EXPECT_LT(half.report.scales.distance(), all.report.scales.distance());
}

TEST(Scale_search, comes_at_least_as_near_to_rho_from_a_part_of_it_as_from_none)
{
  const Mesh_view mesh = dumbbell(3);
  CGP::internal::Dirac_system system(mesh);
  const CGP::internal::Scale_control control{2., {}, {}};
  const CGP::Poisson_reconstruction reconstruction(system.surface(),
                                                   CGP::vertex_graph(system.surface()));
  CGP::internal::Scale_search search(system, Curvature_potential::on_vertices(rings(mesh, .6, 3)),
                                     control, reconstruction, nullptr, {});
  using Trial = std::decay_t<decltype(search.best())>;
  const auto run = [&](double share, const Trial* from) {
    const auto found = search.run(share, from, {}, CGP::internal::Always_go_further());
    EXPECT_TRUE(found.converged);
    EXPECT_LE(search.scales().excess(), 1);
    return search.scales().distance();
  };
  const double all = run(1, nullptr), part = run(.75, nullptr);
  EXPECT_GT(part, 1.05 * all);
  const Trial from = search.best();
  EXPECT_LT(run(1, &from), 1.02 * all);
}

TEST(Scale_search, keeps_handles_closed)
{
  const Mesh_view mesh = btorus(24);
  const CGP::Spin_result r = transformed(mesh, rings(mesh, 3, 4), bounded_by(1.5));
  EXPECT_TRUE(r.report) << to_string(r.report.fault());
  EXPECT_LE(r.report.scales.excess(), 1 + 1e-9);
  EXPECT_LT(r.report.period_defect, 1e-3);
}

// All of rho leaves the handle open, whatever the weights: the search stays at a crossing of
// branches before it has closed it.
TEST(Scale_search, takes_a_part_of_rho_where_handles_stay_open)
{
  const double pi = std::acos(-1.);
  const Mesh_view mesh = scaled_to_area(irregular_torus(3, 1, 16, 10), 4 * pi);
  const CGP::Spin_result r = transformed(mesh, rings(mesh, 3, 3), bounded_by(2));
  EXPECT_TRUE(r.report) << to_string(r.report.fault());
  EXPECT_LE(r.report.scales.excess(), 1);
  EXPECT_LE(r.report.period_defect, r.report.period_limit);
  EXPECT_GT(r.report.scales.kept_correlation, .8);
}

// Where it fails with all of rho, it goes on from what it finds for a half.
TEST(Scale_search, keeps_no_less_of_a_little_more_where_handles_are_closed)
{
  const Mesh_view mesh = scaled_to_area(irregular_torus(3, 1, 16, 10), 4 * std::acos(-1.));
  double last = 0;
  for (double amplitude = .5; amplitude < 5; amplitude *= 1.2) {
    const auto report = transformed(mesh, rings(mesh, amplitude, 3), bounded_by(2)).report;
    EXPECT_TRUE(report) << amplitude << ": " << to_string(report.fault());
    const double now = amplitude * report.scales.kept_norm;
    EXPECT_GT(now, .75 * last) << amplitude;
    last = now;
  }
}

// What counts as closed for the verdict does so for the search: it may keep more, and does where
// the minimum has an open handle.
TEST(Scale_search, keeps_more_of_rho_where_handles_may_open_further)
{
  const Mesh_view mesh = scaled_to_area(irregular_torus(3, 1, 14, 8), 4 * std::acos(-1.));
  for (const double frequency : {3., 5.}) {
    const auto kept_within = [&](double limit) {
      CGP::Spin_transformation_options options = bounded_by(2);
      options.max_period_defect = limit;
      const auto report = transformed(mesh, rings(mesh, 1.5, frequency), options).report;
      EXPECT_TRUE(report) << to_string(report.fault());
      EXPECT_LE(report.period_defect, limit);
      return report.scales.kept_norm;
    };
    const double least_gain = frequency == 3. ? 1.08 : 1;
    EXPECT_GE(kept_within(.02), least_gain * kept_within(.001)) << frequency;
  }
}

TEST(Scale_search, bounds_disks)
{
  const Mesh_view mesh = scaled(jittered_disk(16, .2), 3);
  Eigen::VectorXd rho(mesh.size_of_vertices());
  for (int v = 0; v < rho.size(); ++v) rho[v] = 1.5 * std::sin(2 * mesh.position(v).x());
  for (const auto& condition :
       {CGP::Boundary_condition::free(), CGP::Boundary_condition::tangents()}) {
    CGP::Spin_transformation_options options = bounded_by(1.2);
    options.boundary = condition;
    const CGP::Spin_result r = transformed(mesh, rho, options);
    EXPECT_TRUE(r.report) << to_string(r.report.fault());
    EXPECT_LE(r.report.scales.excess(), 1 + 1e-9);
  }
}

}  // namespace cgp_test::scale_search_tests
