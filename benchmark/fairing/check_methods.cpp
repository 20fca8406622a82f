// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// What each method does to round spheres, and laws that its energy obeys.
#include <Conformal_geometry_processing/measure/energies.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>

#include "../support/workloads.h"
#include "Method.h"
#include "circle_angle_energy.h"
#include "discrete_willmore.h"
#include "explicit_flows.h"
#include "implicit_bi_laplacian.h"
#include "implicit_mean_curvature.h"
#include "isometric_bending.h"
#include "modified_mean_curvature.h"
#include "volume_controlled_mean_curvature.h"

namespace cgp_benchmark {
namespace {

bool all_is_well;

void expect(const char* what, double value, double wanted, double tolerance)
{
  const bool is_well = std::abs(value - wanted) <= tolerance;
  all_is_well = all_is_well && is_well;
  std::printf("%-7s %-66s %.9g (%.9g)\n", is_well ? "ok" : "WRONG", what, value, wanted);
}

/// the radius of the unit sphere after so many steps
template <class Flow>
double radius_after(int level, double time_step, int steps)
{
  Flow flow(cgp_test::icosphere(level), time_step);
  for (int i = 0; i < steps; ++i) flow.step();
  return flow.mesh().positions().colwise().norm().mean();
}

// dR/dt = -1 / R for flows of mean curvature, so R = sqrt(1 - 2 t).
template <class Flow>
void expect_mean_curvature_flow(const char* what)
{
  expect(what, radius_after<Flow>(3, 1e-4, 1000), std::sqrt(1 - 2 * 0.1), 2e-3);
}

// dR/dt = -2 / R^3 for the flow of the bi-Laplacian, so R^4 = 1 - 8 t.
template <class Flow>
void expect_bi_laplacian_flow(const char* what, int level, double time_step)
{
  expect(what,
         radius_after<Flow>(level, time_step, static_cast<int>(std::lround(0.05 / time_step))),
         std::pow(1 - 8 * 0.05, 0.25), 5e-3);
}

/// the greatest eigenvalue of M^-1 L, by the power method
double greatest_eigenvalue(const CGP::Mesh_view& mesh)
{
  const Eigen::VectorXd inverse = CGP::voronoi_areas(mesh).cwiseInverse();
  const Eigen::VectorXd w = CGP::cotan_weights(mesh);
  CGP::Points x = CGP::Points::Random(3, mesh.size_of_vertices());
  double eigenvalue = 0;
  for (int i = 0; i < 3000; ++i) {
    x = weighted(inverse, laplacian(mesh, w, x));
    eigenvalue = x.norm();
    x /= eigenvalue;
  }
  return eigenvalue;
}

/// by how much 400 explicit steps multiply a small noise of the distance of the sphere's vertices
template <class Flow>
double growth(double time_step)
{
  const CGP::Mesh_view sphere = cgp_test::icosphere(2);
  const CGP::Points& normals = sphere.positions();
  const double size = 1e-6;
  const auto noisy = [&](const Eigen::VectorXd& u) -> CGP::Points {
    return normals + size * weighted(u, normals);
  };
  Flow clean(sphere, time_step), flow(sphere, time_step);
  clean.step();
  Eigen::VectorXd u = Eigen::VectorXd::Random(sphere.size_of_vertices()).normalized();
  double growth = 1;
  for (int i = 0; i < 400; ++i) {
    flow.set_positions(noisy(u));  // back to the sphere: the bound holds for this metric
    flow.step();
    const CGP::Points difference = flow.mesh().positions() - clean.mesh().positions();
    u = difference.cwiseProduct(normals).colwise().sum().transpose() / size;
    u.array() -= u.mean();  // spheres of another radius drift apart in the smooth flow too
    growth *= u.norm();
    u.normalize();
  }
  return growth;
}

template <class Flow>
void expect_bound(const char* what, double bound)
{
  expect(what, growth<Flow>(0.98 * bound) < 1e3 && growth<Flow>(1.1 * bound) > 1e6, 1, 0);
}

void check_modified_mean_curvature()
{
  const CGP::Mesh_view mesh = in_unit_frame(cgp_test::bumpy_sphere(3));
  const auto after_three = [&](const auto& run) {
    Race race(mesh, HUGE_VAL, 3);
    run(mesh, 1e-2, race);
    return in_unit_frame({std::move(race).result().positions, mesh.corners()}).positions();
  };
  // They scale differently between steps: where volumes are kept, time is a little slower.
  Race race(mesh, HUGE_VAL, 1), other(mesh, HUGE_VAL, 1);
  run_steps<Modified_mean_curvature>(mesh, 1e-2, race);
  run_smooth_shape(mesh, 1e-2, other);
  const auto unit = [&](Race& r) {
    return in_unit_frame({std::move(r).result().positions, mesh.corners()}).positions();
  };
  expect("modified mean curvature: distance to smooth_shape() of CGAL, 1 step",
         (unit(race) - unit(other)).cwiseAbs().maxCoeff(), 0, 1e-12);
  expect("the same, 3 steps, of which they scale the surface differently",
         (after_three(run_steps<Modified_mean_curvature>) - after_three(run_smooth_shape))
             .cwiseAbs()
             .maxCoeff(),
         0, 1e-2);
}

void check_volume()
{
  Volume_controlled_mean_curvature still(cgp_test::icosphere(3), 1);
  still.step();
  expect("volume-controlled: radius of the sphere after a step of 1",
         still.mesh().positions().colwise().norm().mean(), 1, 1e-3);
  const CGP::Mesh_view mesh = cgp_test::bumpy_sphere(3);
  Volume_controlled_mean_curvature flow(mesh, 0.1);
  for (int i = 0; i < 10; ++i) flow.step();
  expect("volume-controlled: volume of bumps after ten steps of 0.1, relative",
         CGP::signed_volume(flow.mesh()) / CGP::signed_volume(mesh), 1, 1e-12);
  expect("volume-controlled: they are round then, E / 4 pi",
         CGP::willmore_energy(flow.mesh()) / (4 * cgp_test::pi), 1, 0.02);
}

CGP::Mesh_view inverted(const CGP::Mesh_view& mesh)
{
  return cgp_test::mapped(mesh, [](const Eigen::Vector3d& p) {
    const Eigen::Vector3d d = p - Eigen::Vector3d(3, 1, 2);
    return Eigen::Vector3d(d / d.squaredNorm());
  });
}

/// the largest error of the slope along some vertices, by differences of fourth order
double gradient_error(const CGP::Mesh_view& mesh)
{
  const CGP::Points gradient = circle_angle_gradient(mesh);
  const double h = 1e-4;
  double worst = 0;
  for (int v = 0; v < mesh.size_of_vertices(); v += 37)
    for (int c = 0; c < 3; ++c) {
      const auto energy = [&](double step) {
        CGP::Mesh_view moved = mesh;
        CGP::Points p = mesh.positions();
        p(c, v) += step;
        moved.set_positions(p);
        return circle_angle_energy(moved);
      };
      const double slope =
          (8 * (energy(h) - energy(-h)) - (energy(2 * h) - energy(-2 * h))) / (12 * h);
      worst = std::max(worst, std::abs(slope - gradient(c, v)));
    }
  return worst;
}

void check_circle_angles()
{
  const CGP::Mesh_view bumps = cgp_test::bumpy_sphere(2);
  expect("circle angles: energy of a mesh inscribed in the sphere",
         circle_angle_energy(cgp_test::icosphere(3)), 0, 1e-9);
  expect("circle angles: change by an inversion",
         circle_angle_energy(inverted(bumps)) - circle_angle_energy(bumps), 0, 1e-9);
  expect("circle angles: error of the gradient, by differences", gradient_error(bumps), 0, 1e-6);
  expect("circle angles: slope of the energy under scaling",
         circle_angle_gradient(bumps).cwiseProduct(bumps.positions()).sum(), 0, 1e-9);
  const CGP::Mesh_view finer = cgp_test::bumpy_sphere(3);
  Discrete_willmore<2> flow(finer, 1e-3);
  for (int i = 0; i < 100; ++i) flow.step();
  expect("discrete Willmore: energy of bumps after 100 steps, by that before, below 0.2",
         circle_angle_energy(flow.mesh()) / circle_angle_energy(finer), 0.1, 0.1);
}

void check_bending()
{
  const CGP::Mesh_view mesh = cgp_test::icosphere(4);
  Bending_matrix Q(mesh);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(mesh.size_of_vertices());
  const auto& matrix = Q.assemble(mesh, none, 1);
  double energy = 0, of_constant = 0;
  for (int c = 0; c < 3; ++c) {
    const Eigen::VectorXd f = mesh.positions().row(c).transpose();
    energy += f.dot(matrix * f) / 4;
  }
  of_constant = (matrix * Eigen::VectorXd::Ones(mesh.size_of_vertices()).eval()).norm();
  expect("isometric bending: energy of the sphere by 4 pi", energy / (4 * cgp_test::pi), 1, 0.02);
  expect("isometric bending: constants do not bend", of_constant, 0, 1e-9);
  // For a hinge, f^T Q f is 3 |e|^2 |sum of both conormals|^2 by the area of both.
  const Eigen::VectorXd angles = CGP::bending_angles(mesh), areas = CGP::face_areas(mesh);
  double by_angles = 0;
  for (int k = 0; k < mesh.size_of_edges(); ++k) {
    const int h = mesh.halfedges_begin(k)[0];
    const double s = std::sin(angles[k] / 2);
    by_angles += 3 * mesh.vector(h).squaredNorm() * s * s /
                 (areas[CGP::Mesh_view::face(h)] + areas[CGP::Mesh_view::face(mesh.twin(h))]);
  }
  expect("isometric bending: energy by that from bending angles", energy / by_angles, 1, 1e-10);
}

}  // namespace

bool check_methods()
{
  all_is_well = true;
  expect_mean_curvature_flow<Explicit_mean_curvature>("explicit mean curvature: radius at t = 0.1");
  expect_mean_curvature_flow<Implicit_mean_curvature>("implicit mean curvature: radius at t = 0.1");
  expect_mean_curvature_flow<Modified_mean_curvature>("modified mean curvature: radius at t = 0.1");
  expect_bi_laplacian_flow<Explicit_bi_laplacian>("explicit bi-Laplacian: radius at t = 0.05", 2,
                                                  2e-6);
  expect_bi_laplacian_flow<Implicit_bi_laplacian>("implicit bi-Laplacian: radius at t = 0.05", 3,
                                                  1e-4);
  expect_bi_laplacian_flow<Isometric_bending>("isometric bending: radius at t = 0.05", 3, 1e-4);
  const double greatest = greatest_eigenvalue(cgp_test::icosphere(2));
  expect_bound<Explicit_mean_curvature>(
      "explicit mean curvature: unstable beyond 4 / greatest eigenvalue", 4 / greatest);
  expect_bound<Explicit_bi_laplacian>("explicit bi-Laplacian: unstable beyond 4 / its square",
                                      4 / (greatest * greatest));
  check_modified_mean_curvature();
  check_volume();
  check_circle_angles();
  check_bending();
  return all_is_well;
}

}  // namespace cgp_benchmark
