// Tests spin/Dirac_misfit.h spin/Spin_gauge.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Delaunay_view.h>
#include <Conformal_geometry_processing/spin/Relaxed_spins.h>
#include <Conformal_geometry_processing/spin/Spin_residual.h>
#include <Conformal_geometry_processing/spin/solve_dirac_equation.h>

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include "spin/relaxed_surfaces.h"
#include "support/meshes.h"
#include "support/random_delaunay.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace cgp_test::relaxed_spins_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Surface_ref;
using Metric = CGP::internal::Potential_metric;
using System = CGP::internal::Dirac_system;
using CGP::Curvature_potential;
using CGP::internal::Dirac_system;
using CGP::internal::Relaxed_spins;
using CGP::internal::Scale_residual;
using On = Curvature_potential::On;
using Spins = Quaternion_vector<double>;

Eigen::VectorXd heights(const Mesh_view& mesh)
{
  return mesh.positions().row(1);
}

void expect_inner_product(const Surface_ref& surface)
{
  const System system(surface);
  const Metric metric(system, .3);
  const int n = static_cast<int>(metric.areas().size());
  Eigen::MatrixXd d(n, 2);
  d << random_numbers(n, 1), random_numbers(n, 2);
  const Eigen::MatrixXd image = metric.apply(d);
  EXPECT_NEAR(d.col(0).dot(image.col(1)), d.col(1).dot(image.col(0)), 1e-10 * image.norm());
  EXPECT_GT(metric.squared_norm(d.col(0)), metric.areas().dot(d.col(0).cwiseAbs2()));
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(n);
  EXPECT_LT((metric.apply(ones) - metric.areas()).norm(), 1e-10 * image.norm());
}

/// 2 + z^2 of a plane mesh, a solution, or its mirror image
Spins square(const Mesh_view& mesh, double sign)
{
  Spins lambda(mesh.size_of_vertices());
  for (int v = 0; v < mesh.size_of_vertices(); ++v) {
    const Eigen::Vector3d p = mesh.position(v);
    lambda[v] = {2 + p.x() * p.x() - p.y() * p.y(), 0, 0, sign * 2 * p.x() * p.y()};
  }
  return lambda;
}

// Of the first order on sheets, of a higher one at vertices.
TEST(Misfit_sizes, are_small_at_vertices_for_what_the_discretisation_leaves)
{
  std::vector<CGP::internal::Misfit_sizes> sizes;
  for (const double h : {.1, .05}) {
    const Mesh_view mesh = random_domain(h, 3, {});
    const CGP::internal::Dirac_misfit::Geometry geometry(mesh);
    const Eigen::VectorXd rho = Eigen::VectorXd::Zero(mesh.size_of_vertices());
    sizes.push_back(CGP::internal::misfit_sizes(geometry, rho, square(mesh, -1)));
    const auto other = CGP::internal::misfit_sizes(geometry, rho, square(mesh, 1));
    EXPECT_TRUE(sizes.back().averages_out());
    EXPECT_FALSE(other.averages_out());
    EXPECT_NEAR(other.vertices, other.sheets, .05 * other.sheets);
  }
  EXPECT_NEAR(sizes[1].sheets, sizes[0].sheets / 2, .2 * sizes[0].sheets);
  EXPECT_LT(sizes[1].vertices / sizes[1].sheets, .9 * sizes[0].vertices / sizes[0].sheets);
}

TEST(Potential_metric, is_an_inner_product)
{
  const Mesh_view sphere = perturbed(icosphere(2), .1), torus = btorus(8);
  expect_inner_product(sphere);
  expect_inner_product(CGP::Delaunay_view(sphere));
  expect_inner_product(torus);
}

// The integral of y^2 over the unit sphere is 4 pi / 3, that of |grad y|^2 is 8 pi / 3.
TEST(Potential_metric, approximates_integrals)
{
  const double unit = 4 * std::acos(-1.) / 3;
  for (const double s : {0., .5, 2.}) {
    double before = 0;
    for (const int level : {2, 3}) {
      const Mesh_view mesh = icosphere(level);
      const Metric metric(System(mesh), s);
      const double error = std::abs(metric.squared_norm(heights(mesh)) / (unit * (1 + 2 * s)) - 1);
      EXPECT_LT(error, level > 2 ? .3 * before : .06);
      before = error;
    }
  }
}

// With a weight that vanishes.
TEST(Potential_metric, smooths)
{
  const Mesh_view mesh = perturbed(icosphere(3), .03);
  const System system(mesh);
  Metric rough(system, 0), smooth(system, 1);
  for (Metric* metric : {&rough, &smooth}) metric->couple(1e-14);
  const Eigen::VectorXd y = rough.areas().cwiseProduct(heights(mesh));
  const Eigen::VectorXd b = rough.areas().cwiseProduct(random_numbers(mesh.size_of_vertices(), 1));
  const Eigen::VectorXd d = smooth.solve_coupled(b), of_height = smooth.solve_coupled(y);
  EXPECT_LT((smooth.apply(d) - b).norm(), 1e-6 * b.norm());
  EXPECT_LT(rough.squared_norm(d), .05 * rough.squared_norm(rough.solve_coupled(b)));
  EXPECT_NEAR(heights(mesh).dot(rough.areas().cwiseProduct(of_height)) / heights(mesh).dot(y),
              1. / 3, .03);
}

/// a problem with a weight of scales, at spins and a potential that are nothing special
struct Problem {
  Dirac_system system;
  Scale_residual scales;
  Relaxed_spins spins;

  Problem(const Surface_ref& surface, const Eigen::VectorXd& rho, double weight,
          Relaxed_spins::Options options = {}, const CGP::Boundary_condition& boundary = {})
      : system(surface, boundary),
        scales(system.areas(), Eigen::VectorXd::Zero(system.areas().size())),
        spins(system, rho, {&scales}, options)
  {
    scales.set_weight(weight);
  }

  void perturb()
  {
    Spins lambda = .2 * random_quaternions(surface_size(), 1);
    for (auto& q : lambda) q.w += 1;
    spins.restart(lambda, .3 * random_numbers(static_cast<int>(spins.rho().size()), 2));
  }

  int surface_size() const { return static_cast<int>(system.areas().size()); }
};

Relaxed_spins::Options exactly(const CGP::internal::Misfit_weights& weights = {})
{
  Relaxed_spins::Options options;
  options.weights = weights;
  options.tolerance = 1e-10;
  options.max_iterations = 400;
  return options;
}

/// components of spins, then the potential
Eigen::VectorXd joined(const Spins& y, const Eigen::VectorXd& d)
{
  Eigen::VectorXd all(4 * y.size() + d.size());
  all << Eigen::Map<const Eigen::VectorXd>(CGP::components(y).data(), 4 * y.size()), d;
  return all;
}

double sum_at(Problem& p, const Spins& lambda, const Eigen::VectorXd& rho)
{
  const double length = std::sqrt(p.system.squared_norm(lambda) / p.system.areas().sum());
  p.spins.restart(lambda, rho);
  EXPECT_NEAR(length, 1, 1e-6);
  return p.spins.terms().sum();
}

// Along changes that keep the length of lambda.
void expect_gradient(const Surface_ref& surface, const Eigen::VectorXd& rho)
{
  Problem p(surface, rho, .7);
  p.perturb();
  const Spins lambda = p.spins.lambda();
  const Eigen::VectorXd at = p.spins.rho();
  const auto g = p.spins.gradient();
  Spins y = random_quaternions(p.surface_size(), 5);
  const double along = inner_product(lambda, p.system.areas(), y).w / p.system.areas().sum();
  for (Eigen::Index v = 0; v < y.size(); ++v) y[v] -= along * lambda[v];
  const Eigen::VectorXd d = random_numbers(static_cast<int>(at.size()), 6);
  const double h = 1e-5;
  const double slope =
      (sum_at(p, lambda + h * y, at + h * d) - sum_at(p, lambda - h * y, at - h * d)) / (2 * h);
  const double expected = 2 * (inner_product(g.spins, y).w + g.potential.dot(d));
  EXPECT_NEAR(slope, expected, 1e-6 * std::abs(expected));
}

TEST(Relaxed_spins, knows_the_derivative_of_the_sum)
{
  const Mesh_view mesh = ellipsoid(2);
  expect_gradient(mesh, waves_on(mesh, 1));
  expect_gradient(CGP::Delaunay_view(mesh), waves_on(mesh, 1));
}

void expect_positive(Problem& p)
{
  p.perturb();
  p.spins.linearize();
  const Spins a = p.system.projected(random_quaternions(p.surface_size(), 3)).col(0),
              b = p.system.projected(random_quaternions(p.surface_size(), 4)).col(0);
  const Spins Sa = p.spins.schur_product(a).col(0), Sb = p.spins.schur_product(b).col(0);
  EXPECT_NEAR(inner_product(a, Sb).w, inner_product(b, Sa).w,
              1e-10 * CGP::components(a).norm() * CGP::components(Sb).norm());
  EXPECT_GT(inner_product(a, Sa).w, 0);
  EXPECT_GT(inner_product(b, Sb).w, 0);
  CGP::internal::Relaxed_spins::Vectors both(a.size(), 2);
  both << a, b;
  const auto products = p.spins.schur_product(both);
  const Spins da = products.col(0) - Sa, db = products.col(1) - Sb;
  EXPECT_LT(CGP::components(da).norm(), 1e-12 * CGP::components(Sa).norm());
  EXPECT_LT(CGP::components(db).norm(), 1e-12 * CGP::components(Sb).norm());
}

TEST(Relaxed_spins, has_a_symmetric_and_positive_complement)
{
  const Mesh_view closed = ellipsoid(2), disk = bounded_cap();
  Problem p(closed, waves_on(closed, 1), .7), free(disk, waves_on(disk, 1), .7),
      sheets(closed, waves_on(closed, 1), 1e-9, exactly({50, 1e-9})),
      vertices(closed, waves_on(closed, 1), 1e-9, exactly({1e-9, 50})),
      held(disk, waves_on(disk, 1), .7, {}, CGP::Boundary_condition::directions({1, 0, 0}));
  expect_positive(p);
  expect_positive(free);
  expect_positive(held);
  expect_positive(sheets);
  expect_positive(vertices);
}

// A right factor of unit length changes nothing but the factor.
TEST(Relaxed_spins, does_not_see_the_gauge)
{
  const Mesh_view mesh = ellipsoid(2);
  Problem p(mesh, waves_on(mesh, 1), .7, exactly());
  p.perturb();
  const Spins lambda = p.spins.lambda();
  const Eigen::VectorXd rho = p.spins.rho();
  const double sum = p.spins.terms().sum();
  p.spins.linearize();
  const auto step = p.spins.step();
  const Quaternion<double> q{.5, -.5, .5, .5};
  Spins turned = lambda;
  for (auto& l : turned) l = 3. * (l * q);
  p.spins.restart(turned, rho);
  EXPECT_NEAR(p.spins.terms().sum(), sum, 1e-12 * sum);
  p.spins.linearize();
  const auto other = p.spins.step();
  Spins difference = other.spins;
  for (Eigen::Index v = 0; v < turned.size(); ++v) difference[v] -= step.spins[v] * q;
  EXPECT_LT(CGP::components(difference).norm(), 1e-7 * CGP::components(step.spins).norm());
  EXPECT_LT((other.potential - step.potential).norm(), 1e-7 * step.potential.norm());
  const Quaternion<double> along = inner_product(lambda, p.system.areas(), step.spins);
  EXPECT_LT(norm(along), 1e-8 * p.system.areas().sum());
}

/// half the Hessian of Gauss and Newton on all unknowns, from derivatives of the terms alone, with
/// the bound of what rho' does to the misfit for that itself
Eigen::MatrixXd dense_hessian(Problem& p)
{
  const CGP::internal::Dirac_misfit::Geometry geometry(p.system.surface());
  const CGP::internal::Dirac_misfit linear(geometry, p.spins.weights(), p.spins.rho(),
                                           p.spins.lambda());
  const CGP::internal::Potential_metric metric(p.system, .1 / p.system.unit());
  const int n = p.surface_size();
  const Eigen::VectorXd &a = metric.areas(), zero = Eigen::VectorXd::Zero(n);
  const Spins nothing = Spins::Constant(linear.residual().misfit.size(), {});
  Eigen::MatrixXd A(5 * n, 5 * n);
  p.scales.set_spins(p.spins.lambda());
  for (int k = 0; k < 4 * n; ++k) {
    Spins y = Spins::Constant(n, {});
    CGP::components(y)(k % 4, k / 4) = 1;
    const auto r = linear.apply(y);
    A.col(k) =
        joined(linear.adjoint(r.misfit, zero) + p.scales.gradient(p.scales.change(y)), -r.turned);
  }
  for (int k = 0; k < n; ++k) {
    const Eigen::VectorXd d = Eigen::VectorXd::Unit(n, k);
    const Eigen::VectorXd Kd = metric.apply(d).col(0) - a * (a[k] / a.sum());
    A.col(4 * n + k) =
        joined(linear.adjoint(nothing, d), Kd + p.spins.weights().sum() * a.cwiseProduct(d));
  }
  return A;
}

/// the four directions of the gauge, as columns
Eigen::MatrixXd gauge(const Problem& p, Eigen::Index rows)
{
  Eigen::MatrixXd G = Eigen::MatrixXd::Zero(rows, 4);
  for (int k = 0; k < 4; ++k) {
    const Quaternion<double> q{k == 0 ? 1. : 0, k == 1 ? 1. : 0, k == 2 ? 1. : 0, k == 3 ? 1. : 0};
    for (int v = 0; v < p.surface_size(); ++v) {
      const Quaternion<double> l = p.system.areas()[v] * (p.spins.lambda()[v] * q);
      G.col(k).segment<4>(4 * v) << l.w, l.x, l.y, l.z;
    }
  }
  return G;
}

// With the gauge as constraints.
TEST(Relaxed_spins, takes_the_least_squares_step)
{
  const Mesh_view mesh = ellipsoid(1);
  Problem p(mesh, waves_on(mesh, 1), .7, exactly({1, 4}));
  p.perturb();
  const Eigen::MatrixXd A = dense_hessian(p);
  const Eigen::MatrixXd G = gauge(p, A.rows());
  const auto g = p.spins.gradient();
  Eigen::MatrixXd saddle = Eigen::MatrixXd::Zero(A.rows() + 4, A.rows() + 4);
  saddle << A, G, G.transpose(), Eigen::MatrixXd::Zero(4, 4);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(saddle.rows());
  right.head(A.rows()) = -joined(g.spins, g.potential);
  const Eigen::VectorXd expected = saddle.fullPivLu().solve(right).head(A.rows());
  p.spins.linearize();
  const auto step = p.spins.step();
  EXPECT_LT((joined(step.spins, step.potential) - expected).norm(), 1e-6 * expected.norm());
  EXPECT_LT(step.slope, 0);
}

TEST(Relaxed_spins, never_ascends)
{
  const Mesh_view mesh = ellipsoid(2);
  Problem p(mesh, waves_on(mesh, 30), .01);
  p.perturb();
  for (int i = 0; i < 12; ++i) {
    const double before = p.spins.terms().sum();
    const auto progress = p.spins.advance();
    EXPECT_LE(p.spins.terms().sum(), before * (1 + 1e-12));
    EXPECT_NEAR(p.spins.terms().sum(), progress.after, 1e-10 * before);
    if (progress.length == 0) break;
  }
  EXPECT_NEAR(p.system.squared_norm(p.spins.lambda()), p.system.areas().sum(), 1e-9);
}

/// spins after some steps
Spins found(const Mesh_view& mesh, const Eigen::VectorXd& rho, double weight)
{
  Problem p(mesh, rho, weight, exactly());
  for (int i = 0; i < 8; ++i) p.spins.advance();
  return p.spins.lambda();
}

double distance(const Spins& a, const Spins& b)
{
  return CGP::components(Spins(a - b)).norm() / CGP::components(b).norm();
}

TEST(Relaxed_spins, does_not_depend_on_the_unit_of_length)
{
  const Mesh_view mesh = ellipsoid(2);
  const Eigen::VectorXd rho = waves_on(mesh, 1);
  const Spins expected = found(mesh, rho, .7);
  EXPECT_LT(distance(found(scaled(mesh, 8), rho / 8, .7 / 64), expected), 1e-7);
}

TEST(Relaxed_spins, does_not_see_constants_of_rho)
{
  const Mesh_view mesh = ellipsoid(2);
  const Eigen::VectorXd rho = waves_on(mesh, 1), higher = rho.array() + 2;
  EXPECT_LT(distance(found(mesh, higher, .7), found(mesh, rho, .7)), 1e-6);
}

/// between the eigenvector of rho and spins without residuals
double error_of_spins(const Mesh_view& mesh, double weight)
{
  const Eigen::VectorXd rho = waves_on(mesh, .5);
  Dirac_system system(mesh);
  const Spins exact =
      CGP::solve_dirac_equation(system, Curvature_potential::on_vertices(rho)).lambda;
  Problem p(mesh, rho, 1e-12, exactly({weight, .01 * weight}));
  p.spins.restart(p.spins.start(), rho);
  for (int i = 0; i < 8; ++i) p.spins.advance();
  const double overlap = (std::min)(system.overlap(p.spins.lambda(), exact), 1.);
  return std::sqrt(1 - overlap * overlap);
}

// Without residuals, rho' is rho up to the constant for which X has its smallest eigenvalue, and
// lambda the eigenvector, up to the discretization, as the weights become *small*.
TEST(Relaxed_spins, tends_to_the_solution_of_the_dirac_equation)
{
  EXPECT_LT(error_of_spins(icosphere(2), .1), error_of_spins(icosphere(2), 1));
  double last = .001;
  for (const int level : {2, 3, 4}) {
    const double error = error_of_spins(icosphere(level), .01);
    EXPECT_LT(error, last / 3) << level;
    last = error;
  }
}

}  // namespace cgp_test::relaxed_spins_tests
