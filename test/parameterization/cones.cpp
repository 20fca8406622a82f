// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>
#include <Conformal_geometry_processing/parameterization/cones.h>

#include <gtest/gtest.h>

#include "support/bounded_meshes.h"
#include "support/dense.h"
#include "support/limbs.h"
#include "support/mesh_tools.h"
#include "support/polyhedra.h"
#include "support/random.h"
#include "support/spheres.h"
#include "support/tori.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace cgp_test::cones_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::internal::Cone;

Eigen::VectorXd defects_of(const std::vector<Cone>& cones, const Mesh_view& mesh)
{
  Eigen::VectorXd defects = Eigen::VectorXd::Zero(mesh.size_of_vertices());
  for (const Cone& cone : cones) defects[cone.vertex] += cone.defect.value();
  return defects;
}

double variance(const Eigen::VectorXd& u, const Mesh_view& mesh)
{
  const Eigen::VectorXd areas = CGP::vertex_areas(mesh) / area(mesh);
  return areas.dot((u.array() - areas.dot(u)).square().matrix());
}

/// the solution of L u = defects - K, by dense algebra
Eigen::VectorXd log_scale(const Eigen::VectorXd& defects, const Mesh_view& mesh)
{
  Eigen::MatrixXd L = dense(CGP::cotan_laplacian(mesh));
  L.array() += 1;  // without constants
  return L.ldlt().solve(defects - CGP::internal::angle_defects(mesh));
}

Mesh_view ellipsoid(int level)
{
  return mapped(perturbed(icosphere(level), .3, 5), [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(2 * p.x(), p.y(), .7 * p.z());
  });
}

TEST(Cones, obey_gauss_and_bonnet)
{
  for (const auto& [mesh, characteristic] : {std::pair(ellipsoid(2), 2),
                                             {dumbbell(2), 2},
                                             {irregular_torus(3, 1, 20, 12), 0},
                                             {double_torus(), -2}}) {
    EXPECT_NEAR(CGP::internal::angle_defects(mesh).sum(), 2 * pi * characteristic, 1e-9);
    for (const int count : {3, 8}) {
      const auto cones = CGP::internal::place_cones(mesh, count).cones;
      ASSERT_EQ(static_cast<int>(cones.size()), count);
      const Eigen::VectorXd defects = defects_of(cones, mesh);
      EXPECT_NEAR(defects.sum(), 2 * pi * characteristic, 1e-9);
      EXPECT_LE(defects.cwiseAbs().maxCoeff(), (count == 3 ? 4. / 3 : 1) * pi + 1e-9);
      EXPECT_EQ((defects.array() != 0).count(), count);  // all are different
    }
  }
}

TEST(Cones, reduce_the_distortion_of_areas_with_their_number)
{
  for (const Mesh_view& mesh : {ellipsoid(3), bumpy_sphere(3), irregular_torus(3, 1, 40, 24)}) {
    double last = HUGE_VAL, first = 0;
    for (const int count : {4, 6, 8, 12, 16, 32}) {
      const double now = variance(CGP::internal::place_cones(mesh, count).log_scale, mesh);
      EXPECT_LT(now, last) << count << " cones";
      last = now;
      if (count == 4) first = now;
    }
    EXPECT_LT(last, first / 2);
  }
}

TEST(Cones, come_with_their_metric)
{
  const Mesh_view mesh = ellipsoid(2);
  const auto [cones, u] = CGP::internal::place_cones(mesh, 8);
  const Eigen::VectorXd expected = log_scale(defects_of(cones, mesh), mesh);
  EXPECT_LT(((u - expected).array() - (u - expected).mean()).abs().maxCoeff(), 1e-10);
  EXPECT_NEAR(CGP::vertex_areas(mesh).dot(u), 0, 1e-12);
}

TEST(Cones, have_the_best_defects_for_where_they_are)
{
  const Mesh_view mesh = ellipsoid(2);
  const auto cones = CGP::internal::place_cones(mesh, 8).cones;
  const Eigen::VectorXd defects = defects_of(cones, mesh);
  const double least = variance(log_scale(defects, mesh), mesh);
  for (std::size_t i = 0; i < cones.size(); ++i)
    for (std::size_t j = 0; j < cones.size(); ++j) {
      Eigen::VectorXd other = defects;
      other[cones[i].vertex] += .05;
      other[cones[j].vertex] -= .05;
      if (i != j && other.cwiseAbs().maxCoeff() < pi) {
        EXPECT_GT(variance(log_scale(other, mesh), mesh), least);
      }
    }
}

TEST(Cones, stay_where_they_are_given_with_the_angles_that_are_given)
{
  const Mesh_view mesh = ellipsoid(2);
  const auto cones = CGP::internal::place_cones(mesh, 7, {{7, pi}, {20}, {41, -.5}}).cones;
  EXPECT_EQ(cones[0].vertex, 7);
  EXPECT_EQ(cones[0].defect, pi);
  EXPECT_EQ(cones[1].vertex, 20);
  EXPECT_EQ(cones[2].defect, -.5);
  EXPECT_NEAR(defects_of(cones, mesh).sum(), 4 * pi, 1e-9);
}

Mesh_view bent_disk(int n)
{
  return mapped(jittered_disk(n, .3), [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p.x(), 1.4 * p.y(), std::sin(3 * p.x()) * std::cos(2 * p.y()));
  });
}

/// a torus with a hole
Mesh_view holed_torus()
{
  return without_face(irregular_torus(3, 1, 20, 12), 7);
}

std::vector<int> boundary_of(const Mesh_view& mesh)
{
  std::vector<int> found;
  for (int h = 0; h < mesh.size_of_halfedges(); ++h)
    if (mesh.twin(h) < 0) found.push_back(mesh.from(h));
  return found;
}

TEST(Cones, of_surfaces_with_a_boundary_leave_the_rest_of_the_curvature_to_it)
{
  for (const auto& [mesh, characteristic] :
       {std::pair(bent_disk(6), 1), {cylinder(1, 3, 14, 6), 0}, {holed_torus(), -1}}) {
    EXPECT_NEAR(CGP::internal::angle_defects(mesh).sum(), 2 * pi * characteristic, 1e-9);
    const std::vector<int> boundary = boundary_of(mesh);
    for (const int count : {0, 1, 5}) {
      const auto [cones, u] = CGP::internal::place_cones(mesh, count);
      ASSERT_EQ(static_cast<int>(cones.size()), count);
      Eigen::VectorXd rest = dense(CGP::cotan_laplacian(mesh)) * u +
                             CGP::internal::angle_defects(mesh) - defects_of(cones, mesh);
      EXPECT_NEAR(rest.sum(), 2 * pi * characteristic - defects_of(cones, mesh).sum(), 1e-9);
      for (const int v : boundary) {
        rest[v] = 0;
        EXPECT_NEAR(u[v], u[boundary[0]], 1e-10);
      }
      EXPECT_LT(rest.lpNorm<Eigen::Infinity>(), 1e-10);  // flat inside
      for (const Cone& cone : cones)
        EXPECT_EQ(std::count(boundary.begin(), boundary.end(), cone.vertex), 0);
    }
  }
}

TEST(Cones, reduce_the_distortion_of_areas_of_surfaces_with_a_boundary)
{
  for (const Mesh_view& mesh : {bent_disk(12), cap_from_disk(jittered_disk(10, .3), 2.6)}) {
    double last = variance(CGP::internal::place_cones(mesh, 0).log_scale, mesh), first = last;
    for (const int count : {1, 2, 4, 8, 16}) {
      const auto [cones, u] = CGP::internal::place_cones(mesh, count);
      EXPECT_LT(variance(u, mesh), last) << count << " cones";
      last = variance(u, mesh);
      EXPECT_LE(defects_of(cones, mesh).cwiseAbs().maxCoeff(), pi + 1e-9);
    }
    EXPECT_LT(last, first / 4);
  }
}

TEST(Cones, are_not_wanted_by_cylinders_and_one_is_by_a_cone)
{
  EXPECT_LT(CGP::internal::place_cones(cylinder(1, 3, 14, 6), 0).log_scale.norm(), 1e-10);
  const Mesh_view cone = mapped(
      disk(8), [](const Eigen::Vector3d& p) { return Eigen::Vector3d(p.x(), p.y(), p.norm()); });
  const auto [cones, u] = CGP::internal::place_cones(cone, 1);
  EXPECT_EQ(cones[0].vertex, 0);  // the apex
  EXPECT_NEAR(*cones[0].defect, 2 * pi * (1 - std::sqrt(.5)), 1e-2);
}

// A cap is mapped by the stereographic projection: exp u = (1 + cos alpha) / (1 + cos theta) with
// the length of the boundary kept.
TEST(Cones, without_one_map_a_cap_as_the_stereographic_projection)
{
  const double alpha = 1.9;
  double last = HUGE_VAL;
  for (const int n : {6, 12, 24}) {
    const Mesh_view cap = cap_from_disk(jittered_disk(n, .2), alpha);
    const Eigen::VectorXd u = CGP::internal::place_cones(cap, 0).log_scale;
    Eigen::VectorXd expected(u.size());
    for (int v = 0; v < cap.size_of_vertices(); ++v)
      expected[v] = -std::log(1 + cap.position(v).z() / cap.position(v).norm());
    const int w = boundary_of(cap)[0];
    const double error = ((u.array() - u[w]) - (expected.array() - expected[w])).abs().maxCoeff();
    EXPECT_LT(error, .5 * last);
    last = error;
  }
  EXPECT_LT(last, .02);
}

}  // namespace cgp_test::cones_tests
