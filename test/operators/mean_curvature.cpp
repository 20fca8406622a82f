// Tests include/Conformal_geometry_processing/operators/mean_curvature.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>

#include <gtest/gtest.h>

#include "support/bounded_meshes.h"
#include "support/meshes.h"
#include "support/torus_spectrum.h"

#include <vector>

namespace cgp_test::mean_curvature_tests {

namespace CGP = Conformal_geometry_processing;

/// (1/r + cos v / (R + r cos v)) / 2 at the points of the torus of revolution
Eigen::VectorXd curvature_of_torus(const Mesh_view& mesh, double R, double r)
{
  Eigen::VectorXd H(mesh.size_of_vertices());
  for (int i = 0; i < H.size(); ++i) {
    const double distance = mesh.position(i).head<2>().norm();
    H[i] = (1 / r + (distance - R) / r / distance) / 2;
  }
  return H;
}

double root_of_mean_square(const Eigen::VectorXd& x)
{
  return x.norm() / std::sqrt(static_cast<double>(x.size()));
}

TEST(Mean_curvature, is_one_on_the_unit_sphere)
{
  for (int level : {0, 1, 2, 3, 4}) {
    const Eigen::VectorXd H = CGP::mean_curvature(icosphere(level));
    EXPECT_GT(H.minCoeff(), 1 - 1e-12) << level;
    EXPECT_LT(H.maxCoeff(), level < 2 ? 1 + 2e-3 : 1 + 1.3e-4) << level;
  }
}

TEST(Mean_curvature, is_exactly_one_on_the_icosahedron_of_the_unit_sphere)
{
  EXPECT_LT((CGP::mean_curvature(icosphere(0)).array() - 1).abs().maxCoeff(), 1e-14);
}

TEST(Mean_curvature, is_minus_one_with_inward_normals)
{
  const Eigen::VectorXd H = CGP::mean_curvature(with_reversed_faces(icosphere(2)));
  EXPECT_LT((H.array() + 1).abs().maxCoeff(), 1.3e-4);
}

TEST(Mean_curvature, has_the_unit_of_one_over_length)
{
  const Mesh_view mesh = bumpy_sphere(2);
  EXPECT_LT((CGP::mean_curvature(scaled(mesh, 5)) * 5 - CGP::mean_curvature(mesh)).norm(), 1e-12);
}

TEST(Mean_curvature, does_not_change_under_motions)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const Eigen::Matrix3d R = Random(4).rotation();
  const Mesh_view moved = mapped(mesh, [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return R * p + Eigen::Vector3d(3, 4, 5);
  });
  EXPECT_LT((CGP::mean_curvature(moved) - CGP::mean_curvature(mesh)).norm(), 1e-10);
}

TEST(Mean_curvature, tends_to_that_of_the_torus_with_second_order)
{
  std::vector<double> h, error;
  for (int n : {16, 32, 64}) {
    const Mesh_view mesh = torus(2, 1, 2 * n, n);
    h.push_back(1. / n);
    error.push_back(
        root_of_mean_square(CGP::mean_curvature(mesh) - curvature_of_torus(mesh, 2, 1)));
  }
  EXPECT_NEAR(slope(h, error), 2, .2);
  EXPECT_LT(error.back(), 2e-3);
}

TEST(Mean_curvature, converges_on_the_average_only_where_the_mesh_is_irregular)
{
  std::vector<double> h, of_points, of_integral;
  for (int n : {16, 32, 64}) {
    const Mesh_view mesh = jittered_torus(2, 1, 2 * n, n, .1);
    const Eigen::VectorXd areas = CGP::voronoi_areas(mesh);
    const Eigen::VectorXd error = CGP::mean_curvature(mesh) - curvature_of_torus(mesh, 2, 1);
    Eigen::VectorXd smooth(error.size());
    for (int v = 0; v < smooth.size(); ++v)
      smooth[v] = std::cos(mesh.position(v).x() + mesh.position(v).z());
    h.push_back(1. / n);
    of_points.push_back(root_of_mean_square(error));
    of_integral.push_back(std::abs(error.cwiseProduct(areas).dot(smooth)));
  }
  EXPECT_LT(slope(h, of_points), .4);
  EXPECT_GT(of_points.back(), .01);
  EXPECT_GT(slope(h, of_integral), 1.8);
}

TEST(Mean_curvature, is_zero_on_flat_surfaces_up_to_their_boundary)
{
  for (const Mesh_view& mesh : {single_triangle(), unit_square(), disk(4), grid(3, 3)})
    EXPECT_LT(CGP::mean_curvature(mesh).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Mean_curvature, does_not_count_the_curvature_of_the_boundary)
{
  const Eigen::VectorXd cap = CGP::mean_curvature(cap_from_disk(disk(12), 1));
  EXPECT_LT((cap.array() - 1).abs().maxCoeff(), 1e-2);
  const Eigen::VectorXd tube = CGP::mean_curvature(cylinder(2, 3, 60, 12));
  EXPECT_LT((tube.array() - .25).abs().maxCoeff(), 2e-3);
}

TEST(Mean_curvature, reaches_corners_that_have_no_inner_neighbour)
{
  // A bent rectangle: two of its corners are cut off by a diagonal.
  const Mesh_view sheet = mapped(grid(13, 13), [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(2 * std::sin(p.x()), p.y(), 2 * std::cos(p.x()));
  });
  EXPECT_LT((CGP::mean_curvature(sheet).array() - .25).abs().maxCoeff(), 2e-3);
}

TEST(Mean_curvature, integrates_to_half_the_derivative_of_area_along_the_normals)
{
  // d area / d t = sum_i <(L f)_i, N_i> = 2 sum_i V_i H_i for f + t N.
  const Mesh_view mesh = bumpy_sphere(2);
  const Points normals = CGP::vertex_normals(mesh, CGP::internal::Normal_weight::angle);
  const double t = 1e-5;
  const double derivative = (area({mesh.positions() + t * normals, mesh.corners()}) -
                             area({mesh.positions() - t * normals, mesh.corners()})) /
                            (2 * t);
  EXPECT_NEAR(2 * CGP::voronoi_areas(mesh).dot(CGP::mean_curvature(mesh)), derivative, 1e-7);
}

TEST(Mean_curvature_half_density, is_H_times_the_length_that_squares_to_the_area)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const Eigen::VectorXd h = CGP::mean_curvature_half_density(mesh);
  EXPECT_NEAR(h.squaredNorm(), CGP::mean_curvature(mesh).cwiseAbs2().dot(CGP::voronoi_areas(mesh)),
              1e-12);
  EXPECT_EQ((h.array() > 0).count(), (CGP::mean_curvature(mesh).array() > 0).count());
}

TEST(Mean_curvature_half_density, has_no_unit)
{
  const Mesh_view mesh = bumpy_sphere(2);
  EXPECT_LT(
      (CGP::mean_curvature_half_density(scaled(mesh, 4)) - CGP::mean_curvature_half_density(mesh))
          .norm(),
      1e-13);
}

TEST(Angle_defects, of_a_square_are_right_angles_at_its_corners)
{
  const Mesh_view mesh = grid(2, 2);
  const std::vector<int> loop = CGP::boundary_loops(mesh)[0];
  const Eigen::VectorXd turn = CGP::internal::angle_defects(mesh)(loop);
  for (Eigen::Index k = 0; k < turn.size(); ++k)
    EXPECT_NEAR(turn[k], k % 2 == 0 ? pi / 2 : 0, 1e-14);
}

}  // namespace cgp_test::mean_curvature_tests
