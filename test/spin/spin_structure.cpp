// Tests spin/Poisson_reconstruction.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Delaunay_view.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Conformal_geometry_processing/spin/spin_structure.h>

#include <gtest/gtest.h>

#include "support/bends.h"
#include "support/bounded_meshes.h"
#include "support/figure_eight_torus.h"
#include "support/handlebodies.h"
#include "support/moebius.h"
#include "support/random.h"
#include "support/skewed_tori.h"
#include "support/spheres.h"
#include "support/thin_faces.h"
#include "support/tori.h"

#include <algorithm>
#include <cstdint>
#include <string>

namespace cgp_test::spin_structure_tests {

namespace CGP = Conformal_geometry_processing;
using Q = CGP::Quaternion<double>;

int arf(const Mesh_view& mesh)
{
  return CGP::spin_structure(mesh).arf_invariant();
}

/// the loop around the tube of `torus(R, r, m, n)` through its first n quadrangles: across the
/// diagonal of each, and on into the next
CGP::internal::Face_loop around_the_tube(int n)
{
  CGP::internal::Face_loop loop;
  for (int j = 0; j < n; ++j) loop.insert(loop.end(), {6 * j + 1, 6 * j + 3});
  return loop;
}

/// the loop of the faces around the first corner of face 0
CGP::internal::Face_loop around_a_point(const Mesh_view& mesh)
{
  CGP::internal::Face_loop loop;
  int f = 0, corner = 0;
  do {
    loop.push_back(3 * f + (corner + 1) % 3);  // it ends there
    const int h = mesh.twin(loop.back());      // and this one begins there
    f = Mesh_view::face(h);
    corner = (h + 1) % 3;
  } while (f != 0);
  return loop;
}

TEST(Spin_structure, of_embedded_surfaces_is_even)
{
  EXPECT_EQ(arf(icosphere(1)), 0);
  EXPECT_EQ(arf(torus(2, 1, 24, 12)), 0);
  EXPECT_EQ(arf(twisted_torus(12)), 0);
  EXPECT_EQ(arf(hopf_torus(16)), 0);
  for (const int genus : {1, 2, 3}) EXPECT_EQ(arf(holed_block(genus)), 0) << genus;
}

TEST(Spin_structure, of_a_figure_eight_that_turns_around_the_axis_is_odd)
{
  EXPECT_EQ(arf(turned_torus(48, 24, true, 0)), 0);
  EXPECT_EQ(arf(turned_torus(48, 24, true, 1)), 1);
  EXPECT_EQ(arf(turned_torus(60, 24, true, 2)), 0);
  EXPECT_EQ(arf(turned_torus(72, 24, true, 3)), 1);
  EXPECT_EQ(arf(turned_torus(48, 24, false, 1)), 0);
}

TEST(Spin_structure, tells_circles_and_points_from_figures_eight)
{
  const int n = 16;
  for (const bool is_eight : {false, true}) {
    const Mesh_view mesh = turned_torus(32, n, is_eight, 0);
    EXPECT_EQ(CGP::turns_evenly(mesh, around_the_tube(n)), is_eight);
    EXPECT_FALSE(CGP::turns_evenly(mesh, around_a_point(mesh)));
  }
  const Mesh_view sphere = icosphere(2);
  EXPECT_FALSE(CGP::turns_evenly(sphere, around_a_point(sphere)));
}

TEST(Spin_structure, has_an_invariant_that_does_not_depend_on_the_loops)
{
  const Mesh_view odd = turned_torus(48, 24, true, 1);
  for (const std::uint64_t seed : {1, 2, 3})
    EXPECT_EQ(arf(renumbered(odd, random_permutation(odd.size_of_vertices(), seed))), 1);
  Corners corners = odd.corners();
  std::reverse(corners.begin(), corners.end());
  EXPECT_EQ(arf({odd.positions(), corners}), 1);
}

TEST(Spin_structure, stays_under_motions_and_small_deformations)
{
  for (const int turns : {0, 1}) {
    Mesh_view mesh = turned_torus(48, 24, true, turns);
    const CGP::internal::Spin_structure before = CGP::spin_structure(mesh);
    Random random(5);
    Points p = mesh.positions();
    for (Eigen::Index i = 0; i < p.cols(); ++i) p.col(i) += .02 * random.vector();
    mesh.set_positions(7 * random.rotation() * p);
    EXPECT_EQ(CGP::spin_structure(mesh), before);
  }
}

TEST(Spin_structure, stays_under_Moebius_transformations)
{
  for (const int turns : {0, 1}) {
    const Mesh_view mesh = turned_torus(48, 24, turns != 0, turns);
    const CGP::internal::Spin_structure before = CGP::spin_structure(mesh);
    EXPECT_EQ(before.arf_invariant(), turns);
    // outside, in the hole, and in the tube: the last turns the surface inside out
    for (const Eigen::Vector3d& center :
         {Eigen::Vector3d(1, 2, 7), Eigen::Vector3d(.1, .2, .3), Eigen::Vector3d(3 + .5, 0, 0)})
      EXPECT_EQ(CGP::spin_structure(inverted(mesh, center)), before) << turns;
  }
}

TEST(Spin_structure, differs_between_surfaces_of_one_connectivity)
{
  const Mesh_view circle = turned_torus(48, 24, false, 0), eight = turned_torus(48, 24, true, 0);
  EXPECT_NE(CGP::spin_structure(circle), CGP::spin_structure(eight));
  EXPECT_NO_THROW(CGP::require_same_spin_structure(circle, 2 * circle.positions(), "f"));
  try {
    CGP::require_same_spin_structure(circle, eight.positions(), "f");
    FAIL();
  } catch (const CGP::Precondition_error& e) {
    EXPECT_NE(std::string(e.what()).find("spin structure"), std::string::npos);
  }
}

/// the angle of the rotation and the scaling of lengths that the linear map A of the plane is
/// nearest to, by its singular values
TEST(Face_spins, are_the_rotation_and_the_mean_scaling_of_each_face)
{
  const Eigen::Matrix3d R = Eigen::AngleAxisd(1.2, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
  Eigen::Matrix3d A = Eigen::Matrix3d::Identity();
  A.topLeftCorner<2, 2>() << 2, 0.3, 0.3, 0.5;  // symmetric: no rotation in it
  const Mesh_view flat = disk(2);
  const Points target = R * A * flat.positions();
  const CGP::Quaternion_vector<double> q = CGP::face_spins(flat, target);
  const double scale = std::sqrt(2 * 0.5 - 0.3 * 0.3);
  for (int f = 0; f < flat.size_of_faces(); ++f) {
    EXPECT_NEAR(squared_norm(q[f]), scale, 1e-14);
    const Eigen::Vector3d v(0.3, -0.7, 0.2);
    EXPECT_LT((CGP::spin(q[f], v) - scale * R * v).norm(), 1e-13);
  }
}

TEST(Face_spins, of_a_bend_by_324_degrees_have_consistent_signs_that_single_faces_have_not)
{
  const Mesh_view beam = cgp_test::beam(3), bent = bent_beam(beam, 324 * pi / 180);
  CGP::Quaternion_vector<double> q = CGP::face_spins(beam, bent.positions());
  const auto disagreeing = [&] {
    int count = 0;
    for (int h = 0; h < beam.size_of_halfedges(); ++h)
      count += dot(q[Mesh_view::face(h)], q[Mesh_view::face(beam.twin(h))]) < 0;
    return count / 2;
  };
  // A face turned by more than half a turn has the other sign if its real part is positive.
  EXPECT_GT(disagreeing(), 0);
  EXPECT_EQ(CGP::make_consistent(beam, q), 0);
  EXPECT_EQ(disagreeing(), 0);
}

TEST(Face_spins, disagree_along_a_seam_where_they_turn_by_a_full_turn_around_a_torus)
{
  const int around_the_tube = 12;
  const Mesh_view mesh = torus(2, 1, 24, around_the_tube);
  CGP::Quaternion_vector<double> q(mesh.size_of_faces());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const Eigen::Vector3d p = mesh.position(mesh.corners(f)[0]);
    const double half = std::atan2(p.y(), p.x()) / 2;
    q[f] = {std::cos(half), 0, 0, std::sin(half)};
  }
  EXPECT_GE(CGP::make_consistent(mesh, q), around_the_tube);
}

TEST(Replace_thin_faces, gives_all_the_spin_of_a_similarity_of_either_sign)
{
  const Mesh_view mesh = spoilt(icosphere(2));
  const Eigen::Matrix3d R = Eigen::AngleAxisd(1.2, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
  const Points target = 2 * R * mesh.positions();
  CGP::Quaternion_vector<double> q = CGP::face_spins(mesh, target);
  CGP::replace_thin_faces(mesh, target, q);
  EXPECT_EQ(CGP::make_consistent(mesh, q), 0);
  for (Eigen::Index f = 1; f < q.size(); ++f) EXPECT_LT(norm(q[f] - q[0]), 1e-10) << f;
  const Eigen::Vector3d v(0.3, -0.7, 0.2);
  EXPECT_LT((CGP::spin(q[0], v) - 2 * R * v).norm(), 1e-10);
}

TEST(Replace_thin_faces, leaves_the_others_as_they_are)
{
  const Mesh_view mesh = with_thin_faces(icosphere(2), 1e-9);
  const Points target = bent_beam(mesh, 1).positions();
  const CGP::Quaternion_vector<double> before = CGP::face_spins(mesh, target);
  CGP::Quaternion_vector<double> after = before;
  CGP::replace_thin_faces(mesh, target, after);
  int thin = 0;
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const double edge = std::max(
        {mesh.vector(3 * f).norm(), mesh.vector(3 * f + 1).norm(), mesh.vector(3 * f + 2).norm()});
    const bool is_thin = mesh.double_area_vector(f).norm() < 1e-3 * edge * edge;
    thin += is_thin;
    if (!is_thin) {
      EXPECT_EQ(after[f], before[f]);
    }
  }
  EXPECT_EQ(thin, mesh.size_of_vertices() - icosphere(2).size_of_vertices());
}

TEST(Replace_thin_faces, takes_the_mean_of_the_neighbours_where_faces_become_thin)
{
  const Mesh_view mesh = with_thin_faces(icosphere(2), .3);
  const Points target = with_thin_faces(icosphere(2), 0).positions();
  CGP::Quaternion_vector<double> q = CGP::face_spins(mesh, target);
  CGP::replace_thin_faces(mesh, target, q);
  const Mesh_view moved(target, mesh.corners());
  int thin = 0;
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    if (moved.double_area_vector(f).norm() > 1e-9) continue;
    ++thin;
    Q sum;  // no neighbour is thin
    for (int h = 3 * f; h < 3 * f + 3; ++h) {
      const Q next = q[Mesh_view::face(mesh.twin(h))];
      sum += dot(sum, next) < 0 ? -next : next;
    }
    EXPECT_LT(norm(q[f] - sum / 3.), 1e-14);
  }
  EXPECT_GT(thin, 0);
}

TEST(Face_spins, at_vertices_are_the_means_of_the_faces_around)
{
  const Mesh_view mesh = icosphere(2);
  const Q c{0.3, -0.2, 0.5, 0.7};
  const CGP::Quaternion_vector<double> mu =
      CGP::vertex_spins(mesh, CGP::Quaternion_vector<double>::Constant(mesh.size_of_faces(), c));
  for (const Q& q : mu) EXPECT_LT(norm(q - c), 1e-15);
}

TEST(Curvature_of_spins, is_zero_for_similarities)
{
  const Mesh_view mesh = icosphere(2);
  const auto mu = CGP::Quaternion_vector<double>::Constant(mesh.size_of_vertices(), {1, 2, 3, 4});
  EXPECT_LT(CGP::curvature_of_spins(mesh, mu).values.cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Curvature_of_spins, of_a_bend_is_that_of_its_circle)
{
  // conjugate(l) df l with l = cos(a/2) - sin(a/2) i and a = pi z / 6 on a beam along z: bends by
  // curvature pi/6, so the mean curvature changes by half of that, with the sign of the normal.
  const Mesh_view beam = cgp_test::beam(4);
  CGP::Quaternion_vector<double> mu(beam.size_of_vertices());
  for (int v = 0; v < beam.size_of_vertices(); ++v) {
    const double a = pi * beam.position(v).z() / 6;
    mu[v] = {std::cos(a / 2), -std::sin(a / 2), 0, 0};
  }
  const Eigen::VectorXd rho = CGP::curvature_of_spins(beam, mu).values;
  for (int f = 0; f < beam.size_of_faces(); ++f) {
    const Eigen::Vector3d N = beam.double_area_vector(f).normalized();
    EXPECT_NEAR(std::abs(rho[f]), std::abs(N.y()) * pi / 12, 1e-3) << f;
  }
}

TEST(Curvature_of_spins, is_the_same_on_both_views_of_a_Delaunay_mesh)
{
  const Mesh_view mesh = icosphere(2);
  const CGP::Quaternion_vector<double> mu = random_quaternions(mesh.size_of_vertices(), 1);
  const Eigen::VectorXd a = CGP::curvature_of_spins(mesh, mu).values;
  const Eigen::VectorXd b = CGP::curvature_of_spins(CGP::Delaunay_view(mesh), mu).values;
  ASSERT_EQ(a.size(), b.size());
  EXPECT_LT((a - b).norm(), 1e-11 * a.norm());
}

TEST(Curvature_of_spins, of_vanishing_spins_is_zero)
{
  const Mesh_view mesh = icosphere(1);
  const auto mu = CGP::Quaternion_vector<double>::Constant(mesh.size_of_vertices(), {});
  EXPECT_TRUE(CGP::curvature_of_spins(mesh, mu).values.isZero(0));
}

}  // namespace cgp_test::spin_structure_tests
