// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Refusal.h>
#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/measure/energies.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <string>

#include "flow_tools.h"
#include "support/random.h"
#include "support/spheres.h"

namespace cgp_test::refusal_tests {

using CGP::internal::Refusal;
using Place = CGP::Flow_step_report::Place;

Place place_of(const Mesh_view& mesh, const Eigen::VectorXd& measure)
{
  return CGP::internal::place_of(mesh, measure);
}

TEST(Refusal, is_where_its_measure_is_largest_or_no_number)
{
  const Mesh_view mesh = perturbed(icosphere(2), .1);
  Eigen::VectorXd measure = Eigen::VectorXd::LinSpaced(mesh.size_of_vertices(), -2, -1);
  measure[17] = 3;
  EXPECT_EQ(place_of(mesh, measure).vertex, 17);
  measure[40] = std::nan("");
  EXPECT_EQ(place_of(mesh, measure).vertex, 40);
  EXPECT_EQ(place_of(mesh, {}).vertex, -1);
  EXPECT_TRUE(to_string(place_of(mesh, {})).empty());
}

/// a sphere in which a vertex has come near an edge across from it
Mesh_view with_sliver(int face, double height)
{
  const Mesh_view sphere = icosphere(2);
  const std::array<int, 3> c = sphere.corners(face);
  Points f = sphere.positions();
  const Eigen::Vector3d middle = (f.col(c[1]) + f.col(c[2])) / 2;
  const Eigen::Vector3d up = (f.col(c[0]) - middle).normalized();
  f.col(c[0]) = middle + height * (f.col(c[1]) - middle).norm() * up;
  return {f, sphere.corners()};
}

TEST(Refusal, names_the_face_of_the_least_angle_there)
{
  const int face = 23;
  for (const double height : {.1, .01}) {
    const Mesh_view mesh = with_sliver(face, height);
    const Place place = place_of(mesh, CGP::internal::thinness(mesh));
    EXPECT_EQ(place.face, face);
    EXPECT_NEAR(place.angle, std::atan(height), 1e-12);
    EXPECT_NE(to_string(place).find("where face 23 has an angle of"), std::string::npos);
  }
}

bool has(const Mesh_view& mesh, int face, int vertex)
{
  for (const int v : mesh.corners(face))
    if (v == vertex) return true;
  return false;
}

TEST(Refusal, finds_the_limit_that_is_exceeded_and_the_vertex)
{
  const Mesh_view mesh = perturbed(icosphere(2), .05);
  const int moved = 30;
  Points f = mesh.positions();
  f.col(moved) += 5 * (f.col(moved).cross(Eigen::Vector3d(1, 2, 3)).normalized());
  const CGP::Conformality map = CGP::conformality(mesh, f, CGP::neighbourhood_normals(mesh, f));
  const auto refusal = [&](double quasi_conformal, double flipped, double collapsed) {
    return CGP::internal::beyond_limits(mesh, f, map, {quasi_conformal, flipped, collapsed});
  };
  EXPECT_FALSE(refusal(HUGE_VAL, 1, 1));
  const Refusal distorted = refusal(1, 1, 1), flipped = refusal(HUGE_VAL, 0, 1),
                collapsed = refusal(HUGE_VAL, 1, -1);
  EXPECT_NE(distorted.reason.find("quasi-conformal error"), std::string::npos);
  EXPECT_NE(flipped.reason.find("flipped faces"), std::string::npos);
  EXPECT_NE(collapsed.reason.find("collapsed"), std::string::npos);
  for (const Refusal& some : {distorted, flipped}) {
    EXPECT_TRUE(some);
    EXPECT_TRUE(has(mesh, place_of(mesh, some.measure).face, moved)) << some.reason;
  }
}

/// whether a face at a vertex has a normal against that of its neighbourhood
bool has_flipped_face(const Mesh_view& mesh, const Points& f, int vertex)
{
  const Points expected = CGP::neighbourhood_normals(mesh, f);
  for (int k = 0; k < mesh.size_of_faces(); ++k) {
    const auto c = mesh.corners(k);
    const Eigen::Vector3d a = f.col(c[1]) - f.col(c[0]), b = f.col(c[2]) - f.col(c[0]);
    if (has(mesh, k, vertex) && a.cross(b).dot(expected.col(k)) < 0) return true;
  }
  return false;
}

TEST(Refusal, finds_flipped_faces)
{
  const Mesh_view mesh = icosphere(2);
  for (const int face : {3, 77}) {
    Points f = mesh.positions();  // a corner across the opposite edge
    const auto c = mesh.corners(face);
    f.col(c[0]) = .8 * (f.col(c[1]) + f.col(c[2])) - .6 * f.col(c[0]);
    const CGP::Conformality map = CGP::conformality(mesh, f, CGP::neighbourhood_normals(mesh, f));
    ASSERT_GT(map.flipped_faces, 0);
    const Refusal found = CGP::internal::beyond_limits(mesh, f, map, {HUGE_VAL, 0, 1});
    EXPECT_TRUE(has_flipped_face(mesh, f, place_of(mesh, found.measure).vertex));
  }
}

TEST(Refusal, has_a_growth_whose_sum_is_that_of_the_energy)
{
  const Mesh_view before = bumpy_sphere(2), after = perturbed(before, .02);
  EXPECT_NEAR(CGP::internal::energy_growth(before, after).sum(),
              CGP::willmore_energy(after) - CGP::willmore_energy(before), 1e-10);
}

TEST(Refusal, finds_no_misfit_of_moebius_transforms_and_that_of_a_vertex)
{
  const Mesh_view mesh = perturbed(bumpy_sphere(2), .05);
  Points f = mesh.positions().colwise() - Eigen::Vector3d(.1, .2, -.1);
  f.array().rowwise() /= f.colwise().squaredNorm().array();
  EXPECT_LT(CGP::internal::misfit_of_class(mesh, f).maxCoeff(), 1e-12);
  f.col(9) *= 1.1;
  const Eigen::VectorXd misfit = CGP::internal::misfit_of_class(mesh, f);
  EXPECT_NEAR(misfit.maxCoeff(), CGP::length_cross_ratio_change(mesh, f).max, 1e-12);
  int away = 0;
  for (int v = 0; v < misfit.size(); ++v) away += misfit[v] < 1e-12;
  EXPECT_GT(away, mesh.size_of_vertices() - 25);
}

TEST(Refusal, has_the_distortion_of_the_worst_face_at_each_vertex)
{
  const Mesh_view mesh = icosphere(1), other = perturbed(mesh, .1);
  const Eigen::VectorXd Q = CGP::quasi_conformal_errors(mesh, other.positions()),
                        at_vertices =
                            CGP::internal::distortion_at_vertices(mesh, other.positions());
  EXPECT_EQ(at_vertices.maxCoeff(), Q.maxCoeff());
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    for (const int v : mesh.corners(f)) EXPECT_GE(at_vertices[v], Q[f]);
}

}  // namespace cgp_test::refusal_tests
