// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests spin/Prescribed_boundary.h
#include <Conformal_geometry_processing/operators/calculus.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/spin/Prescribed_boundary.h>

#include <gtest/gtest.h>

#include "spin/boundary_tools.h"
#include "support/dense.h"
#include "support/random.h"

#include <cmath>
#include <cstdint>

namespace cgp_test::prescribed_directions_tests {

namespace CGP = Conformal_geometry_processing;
using Q = Quaternion<double>;
using Directions = CGP::internal::Prescribed_directions;

Points random_directions(int n, std::uint64_t seed)
{
  Random random(seed);
  Points U(3, n);
  for (int k = 0; k < n; ++k) U.col(k) = random.vector().normalized();
  return U;
}

double misfit(const Q& q, const Points& U, const Points& V)
{
  double sum = 0;
  for (Eigen::Index k = 0; k < U.cols(); ++k)
    sum += squared_norm(CGP::imaginary(U.col(k)) * q - q * CGP::imaginary(V.col(k)));
  return sum;
}

TEST(Best_turn, is_the_rotation_if_there_is_one)
{
  Random random(1);
  for (int i = 0; i < 20; ++i) {
    const Points U = random_directions(3 + i, 2);
    const Eigen::Matrix3d R = random.rotation();
    const Q q = CGP::best_turn(U, R * U);
    EXPECT_NEAR(norm(q), 1, 1e-14);
    for (int c = 0; c < 3; ++c)
      EXPECT_LT((CGP::spin(q, Eigen::Vector3d::Unit(c)) - R.col(c)).norm(), 1e-12);
  }
}

TEST(Best_turn, is_a_half_turn_if_need_be)
{
  const Points U = random_directions(9, 3);
  const Eigen::Vector3d half_turn(-1, -1, 1);
  const Q q = CGP::best_turn(U, half_turn.asDiagonal() * U);
  EXPECT_NEAR(std::abs(q.z), 1, 1e-13);
}

TEST(Best_turn, fits_no_worse_than_any_other)
{
  const Points U = random_directions(30, 4);
  const Points V =
      (Random(5).rotation() * U + .3 * random_directions(30, 6)).colwise().normalized();
  const Q q = CGP::best_turn(U, V);
  Random random(7);
  for (int i = 0; i < 100; ++i) {
    Q other = q + .1 * random.quaternion();
    other = other / norm(other);
    EXPECT_GE(misfit(other, U, V), misfit(q, U, V));
  }
}

TEST(Best_turn, is_no_half_turn_where_that_fits_little_better)
{
  // Directions nearly on a line, to be tilted beyond it: after a half turn, by a little less.
  Points U(3, 12), V(3, 12);
  for (int k = 0; k < 12; ++k) {
    const double t = 2 * pi * k / 12;
    const Eigen::Vector3d outward(std::cos(t), std::sin(t), 0), up(0, 0, 1);
    U.col(k) = (.1 * outward - up).normalized();
    V.col(k) = (-.5 * outward - std::sqrt(.75) * up).normalized();
  }
  EXPECT_LT(norm(CGP::best_turn(U, V) - Q{1, 0, 0, 0}), 1e-12);
}

TEST(Best_turn, is_none_where_a_half_turn_fits_exactly_and_none_nearly)
{
  Points U(3, 12);
  for (int k = 0; k < 12; ++k) {
    const double t = 2 * pi * k / 12;
    U.col(k) = Eigen::Vector3d(.05 * std::cos(t), .05 * std::sin(t), 1).normalized();
  }
  const Points V = Eigen::Vector3d(-1, -1, 1).asDiagonal() * U;
  EXPECT_LT(norm(CGP::best_turn(U, V) - Q{1, 0, 0, 0}), 1e-12);
}

TEST(Best_turn, is_the_smallest_of_many_where_all_directions_lie_on_a_line)
{
  const Points U = Eigen::Vector3d(0, 0, 1).replicate(1, 8),
               V = Eigen::Vector3d(1, 0, 0).replicate(1, 8);
  const Q expected{std::sqrt(.5), 0, -std::sqrt(.5), 0};  // a right angle about y
  EXPECT_LT(norm(CGP::best_turn(U, V) - expected), 1e-14);
  EXPECT_LT(norm(CGP::best_turn(U, U) - Q{1, 0, 0, 0}), 1e-14);
  EXPECT_LT(misfit(CGP::best_turn(U, -U), U, -U), 1e-25);
}

/// The directions of a condition, with the objects that they refer to
struct Prescribed {
  Prescribed(const Mesh_view& m, const Boundary_condition& condition)
      : mesh(m),
        system(mesh),
        directions(mesh, condition, system.matrix().shared_pattern(), system.solver())
  {}

  Mesh_view mesh;
  CGP::internal::Dirac_system system;
  Directions directions;
};

Points tangents_turned_by(const Mesh_view& mesh, double angle, const Eigen::Vector3d& axis)
{
  return at_boundary(mesh, [&](const auto&, const auto& frame) {
    return Eigen::Vector3d(Eigen::AngleAxisd(angle, axis) * frame.col(0));
  });
}

/// \brief Re <psi q, (D - rho) phi> for all psi and phi of a basis, with averages B psi.
/// \param q a quaternion, one for the form itself
Eigen::MatrixXd dirac_form(const Prescribed& p, const Curvature_potential& rho, const Q& q)
{
  const auto& basis = p.directions.basis();
  const auto D = CGP::dirac(p.mesh), B = CGP::averaging(p.mesh),
             R = CGP::potential_matrix(p.mesh, rho);
  const int n = basis.rows().dimension();
  const CGP::Block<double> one = CGP::Block<double>::Identity(n, n);
  Eigen::MatrixXd averages(4 * p.mesh.size_of_faces(), n), images = averages;
  for (int j = 0; j < n; ++j) {
    const Quaternion_vector<double> phi = basis.embed(one.col(j)).col(0);
    const Quaternion_vector<double> a = B * phi, Dphi = D * phi, Rphi = R * phi;
    for (int f = 0; f < p.mesh.size_of_faces(); ++f) {
      const Q left = a[f] * q, right = Dphi[f] - Rphi[f];
      const double A = p.mesh.double_area_vector(f).norm() / 2;
      averages.col(j).segment<4>(4 * f) << left.w, left.x, left.y, left.z;
      images.col(j).segment<4>(4 * f) << A * right.w, A * right.x, A * right.y, A * right.z;
    }
  }
  return averages.transpose() * images;
}

/// |G - G^T| / |G|
double asymmetry(const Eigen::MatrixXd& G)
{
  return (G - G.transpose()).norm() / G.norm();
}

/// |G + G^T| / |G|
double symmetric_part(const Eigen::MatrixXd& G)
{
  return (G + G.transpose()).norm() / G.norm();
}

TEST(Prescribed_directions, have_spins_that_turn_the_direction_into_its_target)
{
  const Mesh_view mesh = perturbed(cap_from_disk(jittered_disk(4, .3), 1), .04);
  const Eigen::Vector3d tnb(1, -.5, 2);
  Random random(1);
  const Points targets =
      at_boundary(mesh, [&](const auto&, const auto&) { return random.vector(); });
  const Prescribed p(mesh, Boundary_condition::directions(tnb, targets));
  const CGP::Block<double> c = random_numbers(p.directions.basis().rows().dimension(), 2);
  const CGP::Block<Q> l = p.directions.basis().embed(c);
  const CGP::internal::Boundary_frames b = CGP::boundary_frames(mesh);
  for (std::size_t k = 0; k < b.vertices.size(); ++k) {
    const Q spin = l(b.vertices[k], 0);
    const Eigen::Vector3d U = (b.frames[k] * tnb).normalized();
    const Eigen::Vector3d V = targets.col(int(k)).normalized();
    EXPECT_LT((CGP::spin(spin, U) - squared_norm(spin) * V).norm(), 1e-13);
  }
}

TEST(Prescribed_directions, are_those_of_the_surface_unless_others_are_given)
{
  const Prescribed p(perturbed(cap_from_disk(disk(4), 1), .04), Boundary_condition::binormals());
  EXPECT_LT(p.directions.errors(p.mesh, p.directions.targets()).maxCoeff(), 1e-15);
  for (int v = 0; v < p.mesh.size_of_vertices(); ++v)
    EXPECT_LT(norm(p.directions.guide()[v] - Q{1, 0, 0, 0}), 1e-13);
}

TEST(Prescribed_directions, measure_the_angle_that_is_missing)
{
  const Mesh_view mesh = disk(5);
  const Prescribed p(mesh, Boundary_condition::tangents(tangents_turned_by(mesh, .3, {0, 0, 1})));
  EXPECT_LT((p.directions.errors(mesh, p.directions.targets()).array() - .3).abs().maxCoeff(),
            1e-14);
  const auto turned = mapped(mesh, [](const Eigen::Vector3d& x) -> Eigen::Vector3d {
    return Eigen::AngleAxisd(.3, Eigen::Vector3d(0, 0, 1)) * x;
  });
  EXPECT_LT(p.directions.errors(turned, p.directions.targets()).maxCoeff(), 1e-14);
}

TEST(Prescribed_directions, are_guided_by_the_turn_itself_where_all_turn_alike)
{
  const Mesh_view mesh = disk(5);
  for (const double angle : {.3, 2., 3.1, pi}) {
    const Prescribed p(mesh,
                       Boundary_condition::tangents(tangents_turned_by(mesh, angle, {0, 0, 1})));
    const Q turn{std::cos(angle / 2), 0, 0, -std::sin(angle / 2)};
    const double sign = dot(turn, p.directions.guide()[0]) < 0 ? -1 : 1;
    for (int v = 0; v < mesh.size_of_vertices(); ++v)
      EXPECT_LT(norm(p.directions.guide()[v] - sign * turn), 1e-7) << angle;
  }
}

TEST(Prescribed_directions, have_a_guide_that_is_harmonic_inside)
{
  const Mesh_view mesh = jittered_disk(5, .3);
  const Points targets = enneper_directions(mesh, {1, 0, 0});
  const Prescribed p(mesh, Boundary_condition::tangents(targets));
  const auto L = CGP::cotan_laplacian(mesh, p.system.matrix().shared_pattern());
  const std::vector<char> is_boundary = CGP::boundary_vertices(mesh);
  const auto& guide = p.directions.guide();
  for (int v = 0; v < mesh.size_of_vertices(); ++v) {
    if (is_boundary[at(v)]) continue;
    Q sum;
    for (int w = 0; w < mesh.size_of_vertices(); ++w) sum += L.coefficient(v, w) * guide[w];
    EXPECT_LT(norm(sum), 1e-12);
  }
  EXPECT_LT(greatest_difference(p.directions.basis().project(CGP::Block<Q>(guide)).col(0), guide),
            1e-14);
}

TEST(Prescribed_directions, follow_the_mesh_with_the_same_targets)
{
  const Mesh_view before = cap_from_disk(disk(4), 1), after = cap_from_disk(disk(4), 1.2);
  const Points targets = at_boundary(
      before, [](const auto&, const auto& frame) -> Eigen::Vector3d { return frame.col(2); });
  Prescribed p(before, Boundary_condition::binormals(targets));
  const Prescribed expected(after, Boundary_condition::binormals(targets));
  p.mesh.set_positions(after.positions());
  p.directions.update_geometry();
  EXPECT_LT(greatest_difference(p.directions.guide(), expected.directions.guide()), 1e-13);
  EXPECT_GT(p.directions.errors(after, p.directions.targets()).minCoeff(), .1);
}

TEST(Prescribed_directions, that_are_kept_are_those_that_the_mesh_has_each_time)
{
  const Mesh_view after = cap_from_disk(disk(4), 1.2);
  Prescribed p(cap_from_disk(disk(4), 1), Boundary_condition::binormals());
  p.mesh.set_positions(after.positions());
  p.directions.update_geometry();
  EXPECT_LT(p.directions.errors(after, p.directions.targets()).maxCoeff(), 1e-15);
}

TEST(Prescribed_directions, make_the_dirac_operator_symmetric_if_orthogonal_to_the_tangent)
{
  const Q one{1, 0, 0, 0};
  std::vector<double> defects;
  for (const int n : {4, 8}) {
    const Prescribed p(disk(n), Boundary_condition::binormals());
    defects.push_back(asymmetry(dirac_form(p, constant_potential(p.mesh, 0), one)));
  }
  EXPECT_LT(defects[1], .01);
  EXPECT_GT(defects[0] / defects[1], 2);  // first order, on a boundary that is ever less of it all
  const Prescribed tangents(disk(4), Boundary_condition::tangents());
  EXPECT_GT(asymmetry(dirac_form(tangents, constant_potential(tangents.mesh, 0), one)), .4);
}

TEST(Prescribed_directions, that_are_plane_tangents_make_it_skew_whatever_the_surface)
{
  // The reason why tangents of a plane curve can be prescribed with any rho: the kernel of a skew
  // form on a space of odd dimension, more or less, is never empty.
  const Q e_z{0, 0, 0, 1};
  std::vector<double> plane, tilted;
  for (const int n : {4, 8}) {
    const Mesh_view mesh = mapped(disk(n), [](const Eigen::Vector3d& p) {
      return Eigen::Vector3d(p.x(), p.y(), .4 * p.x() * p.y() + .3 * p.x() * p.x());
    });
    const auto rho =
        potential_on_faces(mesh, [](const auto& p) { return std::cos(2 * p.x() + 1); });
    const Points circle = at_boundary(
        disk(n), [](const auto&, const auto& frame) -> Eigen::Vector3d { return frame.col(0); });
    const Prescribed target(mesh, Boundary_condition::tangents(circle));
    plane.push_back(symmetric_part(dirac_form(target, rho, e_z)));
    const Prescribed kept(mesh, Boundary_condition::tangents());
    tilted.push_back(symmetric_part(dirac_form(kept, rho, e_z)));
  }
  EXPECT_LT(plane[1], .05);
  EXPECT_GT(plane[0] / plane[1], 1.7);
  EXPECT_GT(tilted[1], 5 * plane[1]);
  const Prescribed flat(disk(8), Boundary_condition::tangents());
  const auto random = Curvature_potential::on_faces(random_numbers(384, 1));
  EXPECT_LT(symmetric_part(dirac_form(flat, random, e_z)), .01);
}

}  // namespace cgp_test::prescribed_directions_tests
