// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/follow_branch.h>
#include <Quaternionic_linear_algebra/dense/block_operators.h>

#include <gtest/gtest.h>

#include "spin/dense_branch.h"
#include "support/dense.h"
#include "support/meshes.h"

#include <cmath>

namespace cgp_test::follow_branch_tests {

using Conformal_geometry_processing::internal::Shift_secant;
namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;
using CGP::internal::Branch_point;
using CGP::internal::Dirac_gram;
using CGP::internal::follow_branch;
using CGP::internal::follow_settled_branch;

const double zero = 0.3;

double change_at(double shift, double slope)
{
  return slope * (shift - zero);
}

/// the shift after some steps from 0
double after(int steps, double slope)
{
  Shift_secant secant;
  double shift = 0;
  for (int k = 0; k < steps; ++k) shift += secant.step(shift, change_at(shift, slope), 1e-12);
  return shift;
}

TEST(Shift_secant, takes_the_change_itself_as_its_first_step)
{
  EXPECT_NEAR(after(1, -1), zero, 1e-15);
  EXPECT_NEAR(after(1, -.2), .2 * zero, 1e-15);
}

TEST(Shift_secant, finds_the_zero_of_a_line_in_two_steps)
{
  for (const double slope : {-1.8, -1., -.5, -.06}) EXPECT_NEAR(after(2, slope), zero, 1e-12);
}

TEST(Shift_secant, never_takes_a_step_of_more_than_twenty_changes)
{
  for (const double slope : {-.01, .5}) {
    Shift_secant secant;
    double shift = 0;
    for (int k = 0; k < 3; ++k) {
      const double change = change_at(shift, slope), step = secant.step(shift, change, 0);
      EXPECT_LE(std::abs(step), 20.001 * std::abs(change)) << slope << ' ' << k;
      EXPECT_GE(step * change, 0) << "towards the quotient";
      shift += step;
    }
  }
}

TEST(Shift_secant, learns_nothing_from_changes_that_differ_by_less_than_their_error)
{
  Shift_secant secant;
  const double first = secant.step(0, .1, 1e-3);
  EXPECT_EQ(secant.step(first, .0995, 1e-3), .0995);
  EXPECT_NE(secant.step(2 * first, .05, 1e-3), .05);
}

TEST(Shift_secant, tells_whether_changes_become_smaller)
{
  Shift_secant secant;
  EXPECT_TRUE(secant.is_nearer(100));
  secant.step(0, .1, 0);
  EXPECT_TRUE(secant.is_nearer(-.09));
  EXPECT_FALSE(secant.is_nearer(-.11));
}

TEST(Shift_secant, keeps_its_derivative_when_it_begins_again)
{
  const double slope = -.2, root = 3;
  Shift_secant secant;
  double shift = 0;
  for (int k = 0; k < 2; ++k) shift += secant.step(shift, slope * (shift - root), 1e-9);
  secant.restart();
  EXPECT_TRUE(secant.is_nearer(1e6));
  EXPECT_NEAR(secant.step(1, slope * (1 - root), 1e-9), root - 1, 1e-12);
}

/// the columns divided by their lengths in the norm of the vertex areas
Quaternion_matrix unit_columns(const Eigen::VectorXd& areas, Quaternion_matrix V)
{
  for (Eigen::Index c = 0; c < V.cols(); ++c) {
    const Quaternion_vector<double> v = V.col(c);
    const double length = std::sqrt(CGP::inner_product(v, areas, v).w);
    for (Eigen::Index i = 0; i < V.rows(); ++i) V(i, c) = V(i, c) / length;
  }
  return V;
}

/// an orthonormal basis of all spins
Quaternion_matrix full_basis(const Eigen::VectorXd& areas)
{
  const int n = static_cast<int>(areas.size());
  Quaternion_matrix V = zero_matrix(n, n);
  for (int i = 0; i < n; ++i) V(i, i).w = 1 / std::sqrt(areas[i]);
  return V;
}

/// lambda = 1 at t = 0 in the full basis
Branch_point identity(const Eigen::VectorXd& areas)
{
  Branch_point p;
  p.c = Quaternion_vector<double>::Constant(areas.size(), {});
  for (Eigen::Index i = 0; i < areas.size(); ++i) p.c[i].w = std::sqrt(areas[i] / areas.sum());
  return p;
}

/// one of two
Quaternion_vector<double> unit_vector(int i)
{
  Quaternion_vector<double> c = Quaternion_vector<double>::Constant(2, {});
  c[i].w = 1;
  return c;
}

double overlap(const Quaternion_vector<double>& a, const Quaternion_vector<double>& b)
{
  return norm(CGP::inner_product(a, b));
}

Curvature_potential harmonics(const Mesh_view& mesh, double amplitude)
{
  return Curvature_potential::on_vertices(amplitude * rho_of_section_3_on_vertices(mesh));
}

/// \brief two unit spheres: lambda = 1 on the first, without rho there, and the normal on the
/// second with rho = -4, which has the eigenvalue 4 t - 2, nearly.
///
/// Nothing couples them: at t = 1/2 their branches cross.
class Two_branches_that_cross : public testing::Test {
 protected:
  const Mesh_view sphere = icosphere(2),
                  both = disjoint_union(sphere, sphere, Eigen::Vector3d(5, 0, 0));
  const int n = sphere.size_of_vertices();

  Quaternion_matrix vectors() const
  {
    Quaternion_matrix V = zero_matrix(2 * n, 2);
    for (int v = 0; v < n; ++v) {
      V(v, 0).w = 1;
      const Eigen::Vector3d normal = sphere.position(v);
      V(n + v, 1) = {0, normal.x(), normal.y(), normal.z()};
    }
    return unit_columns(CGP::vertex_areas(both), V);
  }

  Curvature_potential rho() const
  {
    Eigen::VectorXd values = Eigen::VectorXd::Zero(2 * n);
    values.tail(n).setConstant(-4);
    return Curvature_potential::on_vertices(values);
  }
};

TEST(Follow_branch, with_the_full_basis_finds_what_small_steps_with_dense_matrices_find)
{
  const Mesh_view mesh = radially_perturbed(bumpy_sphere(1), .1);
  const Eigen::VectorXd areas = CGP::vertex_areas(mesh);
  const Quaternion_matrix basis = full_basis(areas);
  for (const double amplitude : {.3, 1., 2.}) {
    const Curvature_potential rho = harmonics(mesh, amplitude);
    const Dense_branch expected = dense_branch_of_identity(mesh, rho, 30);
    ASSERT_GT(expected.least_overlap, .98);
    const Branch_point p = follow_branch(Dirac_gram(mesh, rho, basis), identity(areas), 1, 0);
    EXPECT_EQ(p.t, 1);
    EXPECT_NEAR(CGP::components(p.c).norm(), 1, 1e-12);
    EXPECT_NEAR(p.gamma, expected.gamma, 1e-4) << amplitude;
    const Quaternion_matrix lambda = CGP::combination(basis, Quaternion_matrix(p.c));
    EXPECT_GT(expected.overlap(lambda.col(0)), 1 - 1e-6) << amplitude;
    EXPECT_NEAR(p.gap, expected.gap, 1e-3 * expected.gap) << amplitude;
    EXPECT_LE(p.least_gap, p.gap);
  }
}

TEST(Follow_branch, for_constant_rho_stays_at_the_identity)
{
  const Mesh_view mesh = bumpy_sphere(1);
  const Eigen::VectorXd areas = CGP::vertex_areas(mesh);
  const Branch_point one = identity(areas);
  for (const double c : {.5, -3., 20.}) {
    const auto rho =
        Curvature_potential::on_faces(Eigen::VectorXd::Constant(mesh.size_of_faces(), c));
    const Branch_point p = follow_branch(Dirac_gram(mesh, rho, full_basis(areas)), one, 1, .999);
    EXPECT_EQ(p.t, 1);
    EXPECT_NEAR(p.gamma, -c, 1e-11);
    EXPECT_NEAR(overlap(p.c, one.c), 1, 1e-12);
  }
}

TEST(Follow_branch, in_the_span_of_one_vector_has_its_quotient)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const Curvature_potential rho = harmonics(mesh, 2);
  const Quaternion_matrix one =
      unit_columns(CGP::vertex_areas(mesh),
                   Quaternion_matrix::Constant(mesh.size_of_vertices(), 1, {1, 0, 0, 0}));
  Branch_point first;
  first.c = Quaternion_vector<double>::Constant(1, {1, 0, 0, 0});
  const Branch_point p = follow_branch(Dirac_gram(mesh, rho, one), first, 1, .99);
  EXPECT_EQ(p.t, 1);
  EXPECT_NEAR(p.gamma, CGP::dirac_quotient(mesh, rho, one.col(0)), 1e-13);
  EXPECT_TRUE(std::isinf(p.gap));  // no other vector is known
}

TEST(Follow_branch, stops_where_the_overlap_with_the_first_vector_would_be_too_small)
{
  const double shortest = 1. / 24;
  const Mesh_view mesh = bumpy_sphere(1);
  const Eigen::VectorXd areas = CGP::vertex_areas(mesh);
  const Dirac_gram gram(mesh, harmonics(mesh, 3), full_basis(areas));
  const Branch_point one = identity(areas);
  double last = 0;
  for (const double least : {.99, .95, .9}) {
    const Branch_point p = follow_branch(gram, one, 1, least);
    EXPECT_GT(p.t, last) << "a smaller bound reaches farther";
    ASSERT_LT(p.t + shortest, 1);
    EXPECT_GE(overlap(p.c, one.c), least);
    EXPECT_LT(overlap(follow_branch(gram, one, p.t + shortest, 0).c, one.c), least);
    last = p.t;
  }
}

TEST(Follow_branch, goes_on_from_where_it_stopped)
{
  const Mesh_view mesh = bumpy_sphere(1);
  const Eigen::VectorXd areas = CGP::vertex_areas(mesh);
  const Dirac_gram gram(mesh, harmonics(mesh, 2), full_basis(areas));
  const Branch_point whole = follow_branch(gram, identity(areas), 1, 0),
                     half = follow_branch(gram, identity(areas), .55, 0),
                     p = follow_branch(gram, half, 1, 0);
  EXPECT_EQ(half.t, .55);
  EXPECT_EQ(p.t, 1);
  EXPECT_NEAR(p.gamma, whole.gamma, 1e-4);
  EXPECT_GT(overlap(p.c, whole.c), 1 - 1e-6);
  EXPECT_LE(p.least_gap, half.least_gap);
}

TEST_F(Two_branches_that_cross, are_followed_straight_on_from_either)
{
  const Dirac_gram gram(both, rho(), vectors());
  for (const double end : {.49, .5, .51, 1.}) {
    Branch_point at_one, at_normal;
    at_one.c = unit_vector(0);
    at_normal.c = unit_vector(1);
    at_normal.gamma = gram.quotient(0, at_normal.c);
    const Branch_point a = follow_branch(gram, at_one, end, .9),
                       b = follow_branch(gram, at_normal, end, .9);
    EXPECT_EQ(a.t, end);
    EXPECT_EQ(b.t, end);
    EXPECT_NEAR(a.gamma, 0, 1e-12);
    EXPECT_NEAR(b.gamma, 4 * end - 2, .1);
    EXPECT_NEAR(overlap(a.c, at_one.c), 1, 1e-12);
    EXPECT_NEAR(overlap(b.c, at_normal.c), 1, 1e-12);
  }
}

TEST_F(Two_branches_that_cross, have_the_least_gap_where_they_cross)
{
  const Dirac_gram gram(both, rho(), vectors());
  Branch_point first;
  first.c = unit_vector(0);
  const Branch_point before = follow_branch(gram, first, .25, .9),
                     after = follow_branch(gram, first, 1, .9);
  EXPECT_NEAR(before.least_gap, 1, .1);
  EXPECT_LT(after.least_gap, .4);  // the error of the normal, which is not an eigenvector exactly
  EXPECT_NEAR(after.gap, 2, .1);
}

TEST_F(Two_branches_that_cross, are_settled_without_a_vector_that_they_do_not_need)
{
  const Dirac_gram gram(both, rho(), vectors());
  Branch_point at_one, at_normal;
  at_one.c = unit_vector(0);
  at_normal.c = unit_vector(1);
  at_normal.gamma = gram.quotient(0, at_normal.c);
  const Branch_point a = follow_settled_branch(gram, at_one, 1),
                     b = follow_settled_branch(gram, at_normal, 1);
  EXPECT_EQ(a.t, 1);
  EXPECT_TRUE(a.is_settled);
  EXPECT_NEAR(a.gamma, 0, 1e-12);
  EXPECT_NEAR(a.misfit, 0, 1e-12);
  EXPECT_EQ(b.t, 0) << "its vector is the last";
}

// Otherwise whatever is predicted after a settled stage would be trusted like one that is settled.
TEST_F(Two_branches_that_cross, are_not_settled_beyond_a_settled_point_where_they_are_not_found_so)
{
  const Dirac_gram gram(both, rho(), vectors());
  Branch_point first;
  first.c = unit_vector(0);
  const Branch_point settled = follow_settled_branch(gram, first, .25);
  ASSERT_TRUE(settled.is_settled);
  EXPECT_FALSE(follow_branch(gram, settled, 1, .9).is_settled);
  EXPECT_FALSE(follow_branch(gram, settled, .25, .9).is_settled);
}

TEST_F(Two_branches_that_cross, are_described_without_the_last_vector)
{
  const Dirac_gram gram(both, rho(), vectors()), one(both, rho(), vectors().leftCols(1));
  EXPECT_EQ(gram.without_last().size_of_vectors(), 1);
  for (const double t : {0., .7}) {
    const auto expected = one.energy(t, .3)(0, 0), found = gram.without_last().energy(t, .3)(0, 0);
    EXPECT_NEAR(norm(found - expected), 0, 1e-14);
  }
}

// In the span of 1 and the normals, 1 has the misfit of rho, which grows with t.
TEST(Follow_settled_branch, stops_where_the_misfit_is_more_than_half_of_the_gap)
{
  const double step = 1. / 8;
  const Mesh_view mesh = bumpy_sphere(2);
  Quaternion_matrix V(mesh.size_of_vertices(), 2);
  for (int v = 0; v < mesh.size_of_vertices(); ++v) {
    const Eigen::Vector3d p = mesh.position(v);
    V(v, 0) = {1, 0, 0, 0};
    V(v, 1) = {0, p.x(), p.y(), p.z()};
  }
  Branch_point one;
  one.c = unit_vector(0);
  double last = 2;
  for (const double amplitude : {1., 4., 8.}) {
    const Dirac_gram gram(mesh, harmonics(mesh, amplitude),
                          unit_columns(CGP::vertex_areas(mesh), V));
    const Branch_point p = follow_settled_branch(gram, one, 1);
    EXPECT_LE(p.misfit, p.gap / 2) << amplitude;
    EXPECT_LT(p.t, last) << "stronger rho is followed less far";
    last = p.t;
    if (p.t == 1) continue;
    const Branch_point beyond = follow_branch(gram, p, p.t + step, .97);
    EXPECT_TRUE(beyond.t < p.t + step || beyond.misfit > beyond.gap / 2 ||
                overlap(beyond.c, one.c) < .98)
        << amplitude;
  }
}

}  // namespace cgp_test::follow_branch_tests
