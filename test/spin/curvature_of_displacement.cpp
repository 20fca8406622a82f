// Tests include/Conformal_geometry_processing/spin/curvature_difference.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/operators/calculus.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/spin/curvature_difference.h>

#include "spin/boundary_tools.h"
#include "support/scans.h"
#include "support/spheres.h"

namespace cgp_test::curvature_of_displacement_tests {

/// The tabled numbers come from an implementation of the same formulas that shares no code with
/// this one.

/// a Gauss function of standard deviation s around (x, y)
Eigen::VectorXd bump(const Mesh_view& mesh, double height, double x, double y, double s)
{
  Eigen::VectorXd h(mesh.size_of_vertices());
  for (int v = 0; v < h.size(); ++v)
    h[v] = height *
           std::exp(-(mesh.position(v) - Eigen::Vector3d(x, y, 0)).squaredNorm() / (2 * s * s));
  return h;
}

/// the z coordinates over the mean of those at the boundary
Eigen::VectorXd heights(const Mesh_view& mesh, const Points& positions)
{
  const CGP::internal::Boundary_frames boundary = CGP::boundary_frames(mesh);
  double level = 0;
  for (const int v : boundary.vertices)
    level += positions(2, v) / static_cast<double>(boundary.vertices.size());
  return positions.row(2).transpose().array() - level;
}

/// the mean distance of the boundary from its centre: the area stays, and so the rim of a bump
/// shrinks
double rim(const Mesh_view& mesh, const Points& positions)
{
  const CGP::internal::Boundary_frames boundary = CGP::boundary_frames(mesh);
  const auto count = static_cast<double>(boundary.vertices.size());
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const int v : boundary.vertices) centre += positions.col(v) / count;
  double radius = 0;
  for (const int v : boundary.vertices) radius += (positions.col(v) - centre).norm() / count;
  return radius;
}

struct Recovery {
  double height, peak;
};

/// how much of a low bump on the disk a spin transformation brings up
Recovery recovered(int n, const Boundary_condition& condition, double height = 0.01)
{
  const Mesh_view mesh = disk(n);
  const Eigen::VectorXd h = bump(mesh, height, 0.2, 0.1, 0.15);
  const CGP::Spin_result r = transformed(mesh, condition, CGP::curvature_of_displacement(mesh, h));
  EXPECT_TRUE(r.report);
  const Eigen::VectorXd z = heights(mesh, r.positions);
  return {h.dot(z) / h.squaredNorm(), z.maxCoeff() / h.maxCoeff()};
}

// Between fixed directions the error falls with the fourth power of the edges; what the formula
// takes for a linear height at a free boundary leaves one of second order.
TEST(Curvature_of_displacement, brings_the_displacement_up_on_coarse_disks)
{
  for (const Boundary_condition& condition :
       {Boundary_condition::tangents(), Boundary_condition::binormals()}) {
    const Recovery coarse = recovered(16, condition), fine = recovered(32, condition);
    EXPECT_NEAR(coarse.height, 1, .01);
    EXPECT_NEAR(fine.height, 1, .001);
    EXPECT_NEAR(coarse.peak, 1, .02);
    EXPECT_NEAR(fine.peak, 1, .002);
  }
  std::vector<double> errors;
  for (const int n : {16, 32, 64})
    errors.push_back(1 - recovered(n, Boundary_condition::free()).height);
  expect_order(2, errors);
  EXPECT_LT(errors.front(), .04);
}

TEST(Curvature_of_displacement, brings_higher_bumps_up_a_little_more)
{
  EXPECT_NEAR(recovered(64, Boundary_condition::free(), 0.1).height, 1.045, 3e-3);
}

TEST(Curvature_of_displacement, keeps_the_angles_that_a_displacement_spoils_as_tabled)
{
  struct High_bump {
    double height, Q, Q_max, result, offset_Q, offset_max;
  };
  const Mesh_view mesh = disk(64);
  for (const High_bump& bumped : {High_bump{0.1, 1.00025, 1.003, 0.1023, 1.0049, 1.046},
                                  {0.2, 1.00106, 1.012, 0.2221, 1.0189, 1.173},
                                  {0.3, 1.00262, 1.028, 0.3863, 1.0401, 1.358}}) {
    const Eigen::VectorXd h = bump(mesh, bumped.height, 0, 0, 0.2);
    const CGP::Spin_result r =
        transformed(mesh, Boundary_condition::tangents(), CGP::curvature_of_displacement(mesh, h));
    ASSERT_TRUE(r.report);
    expect_Q(r, bumped.Q);
    EXPECT_NEAR(r.report.conformality.quasi_conformal.max - 1, bumped.Q_max - 1,
                0.05 * bumped.Q_max - 0.05);
    EXPECT_NEAR(heights(mesh, r.positions).maxCoeff() / rim(mesh, r.positions), bumped.result,
                .006 * bumped.result);
    Points offset = mesh.positions();
    offset.row(2) += h.transpose();
    const CGP::internal::Distribution Q = CGP::quasi_conformal_error(mesh, offset);
    EXPECT_NEAR(Q.mean - 1, bumped.offset_Q - 1, 0.02 * (bumped.offset_Q - 1));
    EXPECT_NEAR(Q.max - 1, bumped.offset_max - 1, 0.02 * (bumped.offset_max - 1));
  }
}

/// the normals at the vertices
Points normals(const Mesh_view& mesh)
{
  Points sum = Points::Zero(3, mesh.size_of_vertices());
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    for (const int v : mesh.corners(f)) sum.col(v) += mesh.double_area_vector(f);
  return sum.colwise().normalized();
}

/// \brief a motion of the vertices along the normals, without that of a rigid body which moves the
/// vertices of these weights like h.
Eigen::VectorXd heights_over(const Eigen::VectorXd& surroundings, const Mesh_view& mesh,
                             const Points& motion, const Eigen::VectorXd& h)
{
  const Points n = normals(mesh);
  Eigen::MatrixXd rigid(mesh.size_of_vertices(), 6);
  for (int v = 0; v < rigid.rows(); ++v)
    rigid.row(v) << n.col(v).transpose(),
        mesh.position(v).cross(Eigen::Vector3d(n.col(v))).transpose();
  const Eigen::VectorXd z = n.cwiseProduct(motion).colwise().sum().transpose();
  const Eigen::MatrixXd weighted = rigid.transpose() * surroundings.asDiagonal();
  return z - rigid * (weighted * rigid).ldlt().solve(weighted * (z - h));
}

/// \brief how much of a bump comes up over what is around it.
/// \param s standard deviation of the bump, which is .1 s high
double recovered_at(const Mesh_view& mesh, const Eigen::Vector3d& top, double s)
{
  Eigen::VectorXd h(mesh.size_of_vertices()), ring = CGP::vertex_areas(mesh);
  for (int v = 0; v < h.size(); ++v) {
    const double d = (mesh.position(v) - top).norm();
    h[v] = .1 * s * std::exp(-d * d / (2 * s * s));
    if (!(2.5 * s < d && d < 4 * s)) ring[v] = 0;
  }
  const CGP::Spin_result r =
      CGP::Spin_transformation(mesh).transform(CGP::curvature_of_displacement(mesh, h));
  EXPECT_TRUE(r.report);
  const Points moved =
      CGP::align(r.positions, mesh.positions(), ring).apply(r.positions) - mesh.positions();
  return h.dot(heights_over(ring, mesh, moved, h)) / h.squaredNorm();
}

// Edges are up to half of the deviation, and limbs four times as thick as it.
TEST(Curvature_of_displacement, brings_low_bumps_up_on_spheres_and_on_limbs)
{
  for (const double length : {1., 2., 4.})
    for (const int level : {4, 5}) {
      const double s = level == 4 ? .25 : .125;
      const Mesh_view mesh =
          mapped(icosphere(level), [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
            return {length * p.x(), p.y(), p.z()};
          });
      EXPECT_NEAR(recovered_at(mesh, {0, 0, 1}, s), 1, .05) << length << " " << level;
    }
}

TEST(Curvature_of_displacement, brings_low_bumps_up_all_over_a_scan)
{
  const Mesh_view mesh = scan(8000, 0);
  for (int v = 0; v < mesh.size_of_vertices(); v += 800)
    EXPECT_NEAR(recovered_at(mesh, mesh.position(v), .1), 1, .05) << v;
}

/// rho as the equation sees it: the means on faces, averaged around vertices
Eigen::VectorXd seen(const Mesh_view& mesh, const Eigen::VectorXd& rho)
{
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(rho.size());
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    for (const int v : mesh.corners(f))
      for (const int u : mesh.corners(f))
        sums[v] += mesh.double_area_vector(f).norm() / 18 * rho[u];
  return sums.cwiseQuotient(CGP::vertex_areas(mesh));
}

// On functions of few edges per wave, the plain Laplacian is seen too low by 2 to 20 %.
TEST(Curvature_of_displacement,
     is_seen_as_half_the_laplacian_to_the_square_of_what_is_averaged_away)
{
  const Mesh_view mesh = bumpy_sphere(3);
  const Eigen::VectorXd areas = CGP::vertex_areas(mesh);
  for (const double wave : {2., 4., 6.}) {
    const Eigen::VectorXd h = (wave * mesh.positions().row(0)).array().sin().matrix().transpose();
    const Eigen::VectorXd half =
        (CGP::codifferential(mesh, CGP::cotan_weights(mesh), CGP::exterior_derivative_0(mesh) * h))
            .cwiseQuotient(2 * areas);
    const Eigen::VectorXd lost = half - seen(mesh, half);
    const Eigen::VectorXd rho = CGP::curvature_of_displacement(mesh, h).values;
    EXPECT_LT((seen(mesh, rho) - half + lost - seen(mesh, lost)).norm(), 1e-12 * half.norm());
    EXPECT_LT((seen(mesh, rho) - half).norm(), .5 * lost.norm()) << wave;
  }
}

TEST(Curvature_of_displacement, is_half_the_positive_laplacian)
{
  // z is an eigenfunction of the sphere of radius 2 with eigenvalue 2 / 4.
  const Mesh_view mesh = scaled(icosphere(4), 2);
  const Eigen::VectorXd z = mesh.positions().row(2).transpose();
  const auto rho = CGP::curvature_of_displacement(mesh, z);
  EXPECT_LT((rho.values - z / 4).norm(), 0.02 * z.norm() / 4);
}

TEST(Curvature_of_displacement, of_a_linear_height_of_the_plane_is_zero_also_at_the_boundary)
{
  const Mesh_view mesh = jittered_disk(6, 0.3);
  const Eigen::VectorXd slope = mesh.positions().row(0).transpose();
  EXPECT_LT(CGP::curvature_of_displacement(mesh, slope).values.cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Curvature_of_displacement, refuses_other_numbers_of_heights)
{
  EXPECT_EQ(refusal_of([] {
              (void)CGP::curvature_of_displacement(icosphere(0), Eigen::VectorXd::Zero(11));
            }),
            "11 heights, one per vertex is needed: 12");
}

}  // namespace cgp_test::curvature_of_displacement_tests
