// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Relaxed_positions.h
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Conformal_geometry_processing/spin/Relaxed_positions.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <gtest/gtest.h>

#include <cmath>

#include "support/control_points.h"
#include "support/meshes.h"

namespace cgp_test::position_residual_tests {

namespace CGP = Conformal_geometry_processing;
using Residual = CGP::internal::Position_residual;
using Spins = Quaternion_vector<double>;

const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.1, Eigen::Vector3d(2, -1, 2).normalized()).toRotationMatrix();

Points some_points(int count)
{
  Points p(3, count);
  for (int k = 0; k < 3; ++k) p.row(k) = random_numbers(count, k + 1);
  return p;
}

Spins nearly_one(int count, double size)
{
  Spins lambda = random_quaternions(count, 5);
  for (auto& q : lambda) q = CGP::Quaternion<double>{1, 0, 0, 0} + size * q;
  return lambda;
}

/// of the sphere of the same area, in the frame
double radius_of_area(const CGP::Spin_transformation& t)
{
  return std::sqrt(area(t.domain().mesh()) / (4 * pi));
}

/// a surface with five control points, and targets near to them
struct Controlled {
  explicit Controlled(const Mesh_view& surface)
      : mesh(surface),
        transformation(mesh),
        points(one_moved(mesh, 5, .2)),
        residual(transformation.system().surface(), transformation.reconstruction(), points)
  {
    residual.set_targets(
        transformation.domain().frame().to_frame(CGP::internal::targets_of(points)));
  }

  Eigen::VectorXd values_at(const Spins& lambda)
  {
    residual.set_spins(lambda);
    return residual.values();
  }

  Mesh_view mesh;
  CGP::Spin_transformation transformation;
  std::vector<Control_point> points;
  Residual residual;
};

TEST(Placement, finds_the_similarity)
{
  const Points from = some_points(5);
  const Points to = ((1.7 * turn) * from).colwise() + Eigen::Vector3d(1, 2, 3);
  const auto a = CGP::internal::placement(from, to);
  EXPECT_LT((a.apply(from) - to).norm(), 1e-11);
  EXPECT_NEAR(a.scale, 1.7, 1e-11);
}

// One point is only translated; points on a line turn as little as possible.
TEST(Placement, does_not_do_what_points_leave_open)
{
  const auto one = CGP::internal::placement(Eigen::Vector3d(.1, .2, .3), Eigen::Vector3d(.4, 0, 0));
  EXPECT_LT((one.rotation - Eigen::Matrix3d::Identity()).norm(), 1e-8);
  EXPECT_NEAR(one.scale, 1, 1e-8);
  Points from(3, 2), to(3, 2);
  from << -1, 1, 0, 0, 0, 0;
  to << 0, 0, -2, 2, 0, 0;
  const auto two = CGP::internal::placement(from, to);
  EXPECT_LT((two.apply(from) - to).norm(), 1e-9);
  EXPECT_LT((two.rotation * Eigen::Vector3d::UnitZ() - Eigen::Vector3d::UnitZ()).norm(), 1e-3);
}

TEST(Shape_motions, are_what_similarities_are_not)
{
  for (const int count : {3, 4, 7}) {
    const Points p = some_points(count);
    const Eigen::VectorXd masses = Eigen::VectorXd::LinSpaced(count, .5, 2);
    const auto by_roots = [&](const Points& motion) -> Eigen::VectorXd {
      return Points(motion * masses.cwiseSqrt().asDiagonal()).reshaped();
    };
    const CGP::internal::Shape_motions Z(p, masses);
    EXPECT_EQ(Z.size(), 3 * count - 7);
    const Eigen::VectorXd y = random_numbers(static_cast<int>(Z.size()), 9);
    EXPECT_LT((Z.coordinates(Z.motion(y), Z.size()) - y).norm(), 1e-13);
    const Points shifted = p.colwise() + Eigen::Vector3d(1, -2, 1);
    Points turning(3, count);
    for (int k = 0; k < count; ++k) turning.col(k) = Eigen::Vector3d(1, 2, 3).cross(p.col(k));
    for (const Points& motion : {p, Points(shifted - p), turning})
      EXPECT_LT(Z.coordinates(by_roots(motion), Z.size()).norm(), 1e-12);
  }
  const auto size = [](const Points& p) {
    return CGP::internal::Shape_motions(p, Eigen::VectorXd::Ones(p.cols())).size();
  };
  EXPECT_EQ(size(some_points(1)), 0);
  EXPECT_EQ(size(some_points(2)), 0);
  Points line = some_points(1).replicate(1, 4);
  line.row(0) << 0, 1, 2, 5;
  EXPECT_EQ(size(line), 12 - 6);
}

// The norm of the values is the distance from the targets after the best similarity, by the radius
// of the sphere of the same area.
TEST(Position_residual, measures_distances_from_targets)
{
  Controlled s(perturbed(icosphere(2), .02));
  const Spins lambda = nearly_one(s.mesh.size_of_vertices(), .05);
  const Eigen::VectorXd values = s.values_at(lambda);
  const auto edges = CGP::transformed_edges(s.transformation.system().surface(), lambda);
  const Points h =
      CGP::internal::positions_of(s.points, s.transformation.reconstruction().positions(edges));
  const Points targets =
      s.transformation.domain().frame().to_frame(CGP::internal::targets_of(s.points));
  const Points distances = CGP::align(h, targets).apply(h) - targets;
  EXPECT_GT(values.norm(), .01);
  EXPECT_NEAR(values.norm(), distances.norm() / radius_of_area(s.transformation), 1e-9);
  s.residual.set_weight(9);
  EXPECT_NEAR(s.residual.values().norm(), 3 * values.norm(), 1e-12);
}

// The masses weigh the squares of distances, and what the similarity fits.
TEST(Position_residual, weighs_points_by_their_masses)
{
  const Mesh_view mesh = perturbed(icosphere(2), .02);
  CGP::Spin_transformation t(mesh);
  const auto points = one_moved(mesh, 5, .2);
  const Eigen::VectorXd masses = Eigen::VectorXd::LinSpaced(5, .1, .3);
  Residual residual(t.system().surface(), t.reconstruction(), points, masses);
  const Points targets = t.domain().frame().to_frame(CGP::internal::targets_of(points));
  residual.set_targets(targets);
  const Spins lambda = nearly_one(mesh.size_of_vertices(), .05);
  residual.set_spins(lambda);
  const Points h = CGP::internal::positions_of(
      points, t.reconstruction().positions(CGP::transformed_edges(t.system().surface(), lambda)));
  const Points distances = CGP::align(h, targets, masses).apply(h) - targets;
  EXPECT_NEAR(residual.values().squaredNorm() * std::pow(radius_of_area(t), 2),
              distances.colwise().squaredNorm().dot(masses), 1e-9);
  EXPECT_LT((distances * masses).norm(), 1e-12);
}

TEST(Position_residual, does_not_depend_on_the_gauge)
{
  Controlled s(btorus(12));
  Spins lambda = nearly_one(s.mesh.size_of_vertices(), .05);
  const double before = s.values_at(lambda).norm();
  for (auto& q : lambda) q = q * CGP::Quaternion<double>{.5, 1, -2, .3};
  EXPECT_NEAR(s.values_at(lambda).norm(), before, 1e-9 * before);
}

// Where the targets are met, the change is the derivative of the values: by finite differences.
TEST(Position_residual, has_its_derivative_at_the_targets)
{
  Controlled s(perturbed(icosphere(2), .02));
  const Spins lambda = nearly_one(s.mesh.size_of_vertices(), .05);
  const auto edges = CGP::transformed_edges(s.transformation.system().surface(), lambda);
  s.residual.set_targets(
      CGP::internal::positions_of(s.points, s.transformation.reconstruction().positions(edges)));
  const Spins d = random_quaternions(s.mesh.size_of_vertices(), 6);
  EXPECT_LT(s.values_at(lambda).norm(), 1e-9);
  const Eigen::VectorXd change = s.residual.change(d);
  const double h = 1e-4;
  Spins more = lambda, less = lambda;
  CGP::components(more) += h * CGP::components(d);
  CGP::components(less) -= h * CGP::components(d);
  // The basis turns with the points: compare lengths, which are those of the distances.
  const double slope = (s.values_at(more).norm() + s.values_at(less).norm()) / (2 * h);
  EXPECT_NEAR(slope, change.norm(), 1e-5 * change.norm());
}

TEST(Position_residual, has_its_transpose)
{
  for (const Mesh_view& mesh : {perturbed(icosphere(2), .02), btorus(12), disk(5)}) {
    Controlled s(mesh);
    s.residual.set_weight(2);
    const int n = mesh.size_of_vertices();
    s.residual.set_spins(nearly_one(n, .1));
    const Spins d = random_quaternions(n, 7);
    const Eigen::VectorXd change = s.residual.change(d);
    const Eigen::VectorXd y = random_numbers(static_cast<int>(change.size()), 8);
    EXPECT_NEAR(y.dot(change), inner_product(s.residual.gradient(y), d).w,
                1e-11 * y.norm() * change.norm());
  }
}

TEST(Position_residual, has_one_column_for_each_point)
{
  for (const Mesh_view& mesh : {perturbed(icosphere(2), .02), disk(5)}) {
    Controlled s(mesh);
    s.residual.set_weight(2);
    s.residual.set_spins(nearly_one(mesh.size_of_vertices(), .1));
    const CGP::internal::Spin_columns c = s.residual.columns();
    EXPECT_EQ(c.columns.cols(), static_cast<Eigen::Index>(s.points.size()));
    const auto gradients = CGP::combination(c.columns, c.factors);
    ASSERT_EQ(gradients.cols(), s.residual.values().size());
    for (Eigen::Index k = 0; k < gradients.cols(); ++k) {
      const Spins g = s.residual.gradient(Eigen::VectorXd::Unit(gradients.cols(), k));
      const Spins difference = gradients.col(k) - g;
      EXPECT_LT(CGP::components(difference).norm(), 1e-12 * CGP::components(g).norm()) << k;
    }
  }
}

}  // namespace cgp_test::position_residual_tests
