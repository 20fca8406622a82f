// Tests include/Conformal_geometry_processing/spin/curvature_difference.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/spin/curvature_difference.h>

#include <gtest/gtest.h>

#include "support/moebius.h"
#include "support/spheres.h"

namespace cgp_test::curvature_difference_tests {

namespace CGP = Conformal_geometry_processing;

/// a surface conformally equivalent to the mesh, of the same area
Mesh_view other(const Mesh_view& mesh)
{
  return scaled_to_area(inverted(mesh, Eigen::Vector3d(0.5, 0.4, 4)), area(mesh));
}

TEST(Curvature_difference, leads_to_the_other_surface_up_to_second_order)
{
  std::vector<double> h, errors;
  for (int level : {2, 3, 4}) {
    const Mesh_view mesh = bumpy_sphere(level), target = other(mesh);
    const auto rho = CGP::curvature_difference(mesh, target.positions());
    const CGP::Spin_result result = CGP::Spin_transformation(mesh).transform(rho);
    ASSERT_TRUE(result.report);
    h.push_back(std::pow(2., -level));
    errors.push_back(CGP::align(result.positions, target.positions()).rms);
  }
  EXPECT_GE(errors[0] / errors[1], 3.5);
  EXPECT_GE(errors[1] / errors[2], 3.5);
}

TEST(Curvature_difference, leads_to_conformal_surfaces_on_the_way_and_beyond)
{
  const Mesh_view mesh = bumpy_sphere(4), target = other(mesh);
  const auto rho = CGP::curvature_difference(mesh, target.positions());
  CGP::Spin_transformation transformation(mesh);
  for (double t : {0.25, 0.5, 0.75, 1., 1.25}) {
    const CGP::Spin_result result =
        transformation.transform(CGP::Curvature_potential::on_vertices(t * rho.values));
    ASSERT_TRUE(result.report);
    EXPECT_LT(result.report.conformality.quasi_conformal.mean, t <= 1 ? 1.02 : 1.03) << t;
  }
}

TEST(Curvature_difference, is_transferred_as_a_half_density)
{
  const Mesh_view mesh = bumpy_sphere(2), target = other(mesh);
  const auto check = [&](const CGP::Curvature_potential& rho, auto areas) {
    const CGP::Curvature_potential there = CGP::transferred(rho, mesh, target);
    const Eigen::VectorXd before = rho.values.cwiseProduct(areas(mesh).cwiseSqrt()),
                          after = there.values.cwiseProduct(areas(target).cwiseSqrt());
    EXPECT_EQ(there.on, rho.on);
    EXPECT_LT((after - before).norm(), 1e-12 * before.norm());
  };
  check(CGP::curvature_difference(mesh, target.positions()),
        [](const Mesh_view& m) { return CGP::voronoi_areas(m); });
  check(CGP::Curvature_potential::on_faces(Eigen::VectorXd::Random(mesh.size_of_faces())),
        [](const Mesh_view& m) { return CGP::face_areas(m); });
}

TEST(Curvature_difference, of_a_surface_to_itself_is_zero_and_changes_sign_on_the_way_back)
{
  const Mesh_view mesh = bumpy_sphere(2), target = other(mesh);
  EXPECT_TRUE(CGP::curvature_difference(mesh, mesh.positions()).values.isZero(0));
  const auto there = CGP::curvature_difference(mesh, target.positions());
  const auto back = CGP::curvature_difference(target, mesh.positions());
  // As half-densities, rho times the root of the area.
  const Eigen::VectorXd sum = there.values.cwiseProduct(CGP::voronoi_areas(mesh).cwiseSqrt()) +
                              back.values.cwiseProduct(CGP::voronoi_areas(target).cwiseSqrt());
  EXPECT_LT(sum.cwiseAbs().maxCoeff(), 1e-13);
}

TEST(Curvature_difference, is_the_same_on_other_surfaces_as_a_half_density)
{
  const Mesh_view mesh = bumpy_sphere(2), target = other(mesh);
  const auto there = CGP::curvature_difference(mesh, target.positions());
  const auto back = CGP::curvature_difference(target, mesh.positions());
  EXPECT_LT((CGP::transferred(there, mesh, target).values + back.values).cwiseAbs().maxCoeff(),
            1e-12);
  EXPECT_LT((CGP::transferred(there, mesh, mesh).values - there.values).norm(), 1e-14);
  EXPECT_LT((CGP::transferred(there, mesh, scaled(mesh, 4)).values - there.values / 4).norm(),
            1e-13);
}

TEST(Curvature_difference, is_in_the_units_of_the_mesh)
{
  const Mesh_view mesh = bumpy_sphere(2), target = other(mesh);
  const auto rho = CGP::curvature_difference(mesh, target.positions());
  const auto of_half =
      CGP::curvature_difference(scaled(mesh, 0.5), scaled(target, 0.5).positions());
  EXPECT_LT((of_half.values - 2 * rho.values).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Curvature_difference, is_so_for_very_large_and_very_small_units)
{
  const Mesh_view mesh = bumpy_sphere(2), target = other(mesh);
  const auto rho = CGP::curvature_difference(mesh, target.positions());
  for (const double unit : {1e-150, 1e-80, 1e80, 1e150}) {
    const Mesh_view there = scaled(mesh, unit);
    const auto found = CGP::curvature_difference(there, scaled(target, unit).positions());
    EXPECT_LT((unit * found.values - rho.values).cwiseAbs().maxCoeff(), 1e-11) << unit;
    const Eigen::VectorXd transferred = CGP::transferred(rho, mesh, there).values;
    EXPECT_LT((unit * transferred - rho.values).cwiseAbs().maxCoeff(), 1e-11) << unit;
  }
}

TEST(Curvature_difference, refuses_other_numbers_of_positions)
{
  EXPECT_THROW((void)CGP::curvature_difference(icosphere(1), Points(3, 2)),
               CGP::Precondition_error);
}

}  // namespace cgp_test::curvature_difference_tests
