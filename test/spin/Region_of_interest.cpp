// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Conformal_deformation.h
#include <Conformal_geometry_processing/spin/Conformal_deformation.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "support/control_points.h"
#include "support/limbs.h"
#include "support/meshes.h"

namespace cgp_test::region_of_interest_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::internal::control_point;
using CGP::internal::Region_of_interest;
using Deformation = CGP::internal::Conformal_deformation;
using Options = CGP::internal::Conformal_deformation_options;

/// 1 near the north pole of a unit sphere, down to the height `inner`; 0 below `outer`
Eigen::VectorXd cap(const Mesh_view& mesh, double inner, double outer)
{
  const Eigen::ArrayXd z = mesh.positions().row(2).transpose();
  return ((z - outer) / (inner - outer)).max(0).min(1);
}

int north_pole(const Mesh_view& mesh)
{
  int v;
  mesh.positions().row(2).maxCoeff(&v);
  return v;
}

/// what pulls the north pole to the side
std::vector<Control_point> pulled(const Mesh_view& mesh)
{
  const int pole = north_pole(mesh);
  return {control_point(pole, mesh.position(pole) + Eigen::Vector3d(.1, 0, .15))};
}

CGP::Spin_result deformed(const Mesh_view& mesh, const Eigen::VectorXd& weights)
{
  Options options;
  options.region = weights;
  return Deformation(mesh, options).deform(pulled(mesh));
}

/// Q of the faces with a corner of weight below 1, of those with one above 0
Eigen::VectorXd Q_of_collar(const Mesh_view& mesh, const Eigen::VectorXd& weights, const Points& f)
{
  const Eigen::VectorXd Q = CGP::quasi_conformal_errors(mesh, f);
  std::vector<double> there;
  for (int k = 0; k < mesh.size_of_faces(); ++k) {
    const Eigen::Vector3d w =
        weights(std::vector<int>(mesh.corners(k).begin(), mesh.corners(k).end()));
    if (w.maxCoeff() > 0 && w.minCoeff() < 1) there.push_back(Q[k]);
  }
  return Eigen::Map<Eigen::VectorXd>(there.data(), static_cast<Eigen::Index>(there.size()));
}

TEST(Region_of_interest, leaves_the_outside_as_it_is_to_the_bit)
{
  const Mesh_view mesh = perturbed(icosphere(4), .005);
  const Eigen::VectorXd w = cap(mesh, .7, .1);
  const CGP::Spin_result r = deformed(mesh, w);
  ASSERT_TRUE(r.report) << to_string(r.report.fault());
  EXPECT_LT(r.report.position_error.max, 1e-8);
  EXPECT_EQ(r.report.conformality.flipped_faces, 0);
  int moved = 0;
  for (int v = 0; v < mesh.size_of_vertices(); ++v) {
    const bool stays = r.positions.col(v) == mesh.positions().col(v);
    if (w[v] == 0) {
      EXPECT_TRUE(stays) << v;
      EXPECT_EQ(CGP::norm(r.lambda[v] - CGP::Quaternion<double>{1, 0, 0, 0}), 0);
    }
    moved += !stays;
  }
  EXPECT_GE(moved, (w.array() > .01).count());  // by less, what moves may be rounding
}

TEST(Region_of_interest, reports_the_distortion_of_its_collar)
{
  const Mesh_view mesh = perturbed(icosphere(4), .005);
  const Eigen::VectorXd w = cap(mesh, .7, .1);
  const CGP::Spin_result r = deformed(mesh, w);
  ASSERT_TRUE(r.report.collar);
  const Eigen::VectorXd Q = Q_of_collar(mesh, w, r.positions);
  EXPECT_NEAR(r.report.collar->quasi_conformal.max, Q.maxCoeff(), 1e-12);
  EXPECT_LE(r.report.collar->quasi_conformal.mean, Q.maxCoeff());
  EXPECT_GE(r.report.conformality.quasi_conformal.max, Q.maxCoeff() - 1e-12);
}

TEST(Region_of_interest, distorts_a_wider_collar_less)
{
  const Mesh_view mesh = icosphere(4);
  double last = std::numeric_limits<double>::infinity();
  for (const double outer : {.6, .2, -.6}) {
    const CGP::Spin_result r = deformed(mesh, cap(mesh, .8, outer));
    ASSERT_TRUE(r.report) << outer;
    EXPECT_LT(r.report.collar->quasi_conformal.mean, last) << outer;
    last = r.report.collar->quasi_conformal.mean;
  }
  EXPECT_LT(last, 1.01);
}

TEST(Region_of_interest, of_the_whole_surface_is_none)
{
  const Mesh_view mesh = dumbbell(2);
  const auto points = one_moved(mesh, 8, .3);
  Options options;
  options.region = Eigen::VectorXd::Ones(mesh.size_of_vertices());
  const CGP::Spin_result all = Deformation(mesh, options).deform(points);
  const CGP::Spin_result none = Deformation(mesh).deform(points);
  EXPECT_EQ(all.positions, none.positions);
  EXPECT_FALSE(all.report.collar);
}

TEST(Region_of_interest, knows_nothing_of_what_is_outside)
{
  const Mesh_view mesh = icosphere(4);
  const Eigen::VectorXd w = cap(mesh, .7, .2);
  Points p = mesh.positions();
  for (int v = 0; v < mesh.size_of_vertices(); ++v)
    if (p(2, v) < -.2) p.col(v) *= 3;
  const Points one = deformed(mesh, w).positions;
  const Points other = deformed({p, mesh.corners()}, w).positions;
  for (int v = 0; v < mesh.size_of_vertices(); ++v)
    EXPECT_TRUE(w[v] == 0 || one.col(v) == other.col(v)) << v;
}

// 42 to 642 vertices: as many numbers as targets and what holds the collar, or hardly more.
TEST(Region_of_interest, reaches_targets_on_coarse_limbs)
{
  for (const int level : {1, 2, 3}) {
    const Mesh_view mesh = dumbbell(level);
    int top;
    mesh.positions().row(1).maxCoeff(&top);
    const Eigen::Vector3d target = mesh.position(top) + Eigen::Vector3d(1, .1, -.5);
    Options options;
    options.region = mesh.positions().row(1).transpose().cwiseMax(0.).cwiseMin(1.);
    const CGP::Spin_result r = Deformation(mesh, options).deform({control_point(top, target)});
    EXPECT_TRUE(r.report) << level << " " << to_string(r.report.fault());
    EXPECT_EQ(r.report.reached, 1) << level;
    EXPECT_LT((r.positions.col(top) - target).norm(), 1e-8) << level;
  }
}

TEST(Region_of_interest, holds_the_collar_near_to_where_it_is)
{
  const Mesh_view mesh = perturbed(icosphere(4), .005);
  const Eigen::VectorXd w = cap(mesh, .7, -.3);
  const CGP::Spin_result r = deformed(mesh, w);
  ASSERT_TRUE(r.report);
  for (int v = 0; v < mesh.size_of_vertices(); ++v) {
    const double moved = (r.positions.col(v) - mesh.position(v)).norm();
    EXPECT_TRUE(w[v] >= .5 || moved < .01) << v << " " << moved;  // the pole moves by .18
  }
}

TEST(Region_of_interest, goes_a_share_of_the_way_where_all_is_too_far)
{
  const Mesh_view mesh = perturbed(icosphere(3), .01);
  Options options;
  options.region = cap(mesh, .9, .8);
  const int pole = north_pole(mesh);
  const Eigen::Vector3d way(3, 0, -1);
  const CGP::Spin_result r =
      Deformation(mesh, options).deform({control_point(pole, mesh.position(pole) + way)});
  EXPECT_LT(r.report.reached, 1);
  EXPECT_EQ(r.report.conformality.flipped_faces, 0);
  EXPECT_LT((r.positions.col(pole) - mesh.position(pole) - r.report.reached * way).norm(), 1e-8);
}

TEST(Region_of_interest, is_where_the_targets_are)
{
  const Mesh_view mesh = icosphere(3);
  const Eigen::VectorXd north = cap(mesh, .6, .3), both = north + cap(mesh, -.6, -.3);
  EXPECT_EQ(CGP::internal::weights_at(pulled(mesh), mesh, both, "test"), north);
  EXPECT_EQ(CGP::internal::weights_at(pulled(mesh), mesh, {}, "test").size(), 0);
  EXPECT_THROW((void)CGP::internal::weights_at({}, mesh, both, "test"), CGP::Precondition_error);
  Options options;
  options.region = both;
  Deformation deformation(mesh, options);
  const CGP::Spin_result of_both = deformation.deform(pulled(mesh));
  EXPECT_EQ(deformation.region(), north);
  options.region = north;
  EXPECT_EQ(of_both.positions, Deformation(mesh, options).deform(pulled(mesh)).positions);
  int south = 0;
  mesh.positions().row(2).minCoeff(&south);
  const Eigen::Vector3d to = mesh.position(south) + Eigen::Vector3d(.1, .05, .05);
  const CGP::Spin_result of_other = deformation.deform({control_point(south, to)});
  EXPECT_TRUE(of_other.report) << to_string(of_other.report.fault());
  EXPECT_EQ(deformation.region(), both - north);
}

TEST(Region_of_interest, follows_a_drag)
{
  const Mesh_view mesh = icosphere(3);
  Options options;
  options.region = cap(mesh, .6, -.2);
  Deformation deformation(mesh, options);
  auto points = pulled(mesh);
  const int first = deformation.deform(points).report.solves;
  points[0].target.x() += .01;
  const CGP::Spin_result r = deformation.deform(points);
  EXPECT_TRUE(r.report);
  EXPECT_LT(r.report.solves, first);
  EXPECT_LT(r.report.position_error.max, 1e-8);
}

TEST(Region_of_interest, fades_smoothly)
{
  const Mesh_view mesh = icosphere(3);
  const Region_of_interest region(mesh, cap(mesh, .5, -.5), "test");
  Points f = region.mesh().positions();
  f.row(0).array() += 1;
  CGP::Quaternion_vector<double> lambda =
      CGP::Quaternion_vector<double>::Constant(f.cols(), {-1, 0, 0, 0});
  region.fade(f, lambda);
  for (Eigen::Index v = 0; v < f.cols(); ++v) {
    const auto p = region.mesh().positions().col(v);
    const double w = (std::min)(1., (std::max)(0., p.z() + .5));
    EXPECT_NEAR(f(0, v) - p.x(), w * w * (3 - 2 * w), 1e-15);
    EXPECT_NEAR(CGP::norm(lambda[v] - CGP::Quaternion<double>{1, 0, 0, 0}), 0, 1e-15);
  }
}

TEST(Region_of_interest, refuses_what_makes_no_sense)
{
  const Mesh_view mesh = icosphere(2);
  const Eigen::VectorXd w = cap(mesh, .5, 0);
  EXPECT_THROW(Region_of_interest(mesh, -w, "test"), CGP::Precondition_error);
  EXPECT_THROW(Region_of_interest(mesh, .5 * w, "test"), CGP::Precondition_error);
  EXPECT_THROW(Region_of_interest(mesh, w + cap(mesh, -.9, -.5), "test"), CGP::Precondition_error);
  const Region_of_interest region(mesh, w, "test");
  const int pole = north_pole(mesh);
  EXPECT_EQ(region.vertices()[static_cast<std::size_t>(
                region.in_part(pulled(mesh), "test")[0].vertices[0])],
            pole);
  int low;
  mesh.positions().row(2).minCoeff(&low);
  EXPECT_THROW((void)region.in_part({control_point(low, mesh.position(low))}, "test"),
               CGP::Precondition_error);
}

}  // namespace cgp_test::region_of_interest_tests
