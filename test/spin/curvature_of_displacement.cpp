// Tests include/Conformal_geometry_processing/spin/curvature_of_displacement.h
// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/spin/curvature_of_displacement.h>

#include "spin/boundary_tools.h"
#include "support/spheres.h"

/// The tabled numbers come from an implementation of the same formulas that shares no code with
/// this one.
namespace {

using namespace cgp_test;

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

struct Row {
  int n;
  double height, peak, free_height;
};
const Row table[] = {
    {16, 0.9621, 0.9273, 0.9358}, {32, 0.9905, 0.9809, 0.9836}, {64, 0.9979, 0.9955, 0.9961}};

/// The error agrees with the table, to 6 % and to its digits
void expect_recovered(double found, double tabled)
{
  EXPECT_NEAR(found, tabled, 0.06 * (1 - tabled) + 1e-4);
}

}  // namespace

TEST(Curvature_of_displacement, brings_the_displacement_up_between_fixed_tangents_as_tabled)
{
  for (const Row& row : table) {
    const Recovery found = recovered(row.n, Boundary_condition::tangents());
    expect_recovered(found.height, row.height);
    expect_recovered(found.peak, row.peak);
  }
}

TEST(Curvature_of_displacement, brings_it_up_between_fixed_binormals_just_as_well)
{
  for (const Row& row : table)
    expect_recovered(recovered(row.n, Boundary_condition::binormals()).height, row.height);
}

TEST(Curvature_of_displacement, brings_it_up_with_a_free_boundary_as_tabled)
{
  for (const Row& row : table)
    expect_recovered(recovered(row.n, Boundary_condition::free()).height, row.free_height);
}

TEST(Curvature_of_displacement, brings_higher_bumps_up_a_little_more_as_tabled)
{
  EXPECT_NEAR(recovered(64, Boundary_condition::free(), 0.1).height, 1.045, 2e-3);
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
                2e-4);
    Points offset = mesh.positions();
    offset.row(2) += h.transpose();
    const CGP::internal::Distribution Q = CGP::quasi_conformal_error(mesh, offset);
    EXPECT_NEAR(Q.mean - 1, bumped.offset_Q - 1, 0.02 * (bumped.offset_Q - 1));
    EXPECT_NEAR(Q.max - 1, bumped.offset_max - 1, 0.02 * (bumped.offset_max - 1));
  }
}

/// \brief how much of a bump on the side of a spheroid about x a spin transformation brings up.
/// \param length of half its axis; its radius is 1
/// \param s standard deviation of the bump, which is .1 s high
double recovered_on_a_limb(int level, double length, double s)
{
  const Mesh_view mesh = mapped(icosphere(level), [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return {length * p.x(), p.y(), p.z()};
  });
  Eigen::VectorXd h(mesh.size_of_vertices()), ring = CGP::vertex_areas(mesh);
  for (int v = 0; v < h.size(); ++v) {
    const double d = (mesh.position(v) - Eigen::Vector3d(0, 0, 1)).norm();
    h[v] = mesh.position(v).z() > 0 ? .1 * s * std::exp(-d * d / (2 * s * s)) : 0;
    if (!(2.5 * s < d && d < 4 * s)) ring[v] = 0;
  }
  const CGP::Spin_result r =
      CGP::Spin_transformation<>(mesh).transform(CGP::curvature_of_displacement(mesh, h));
  EXPECT_TRUE(r.report);
  const Points moved =
      CGP::align(r.positions, mesh.positions(), ring).apply(r.positions) - mesh.positions();
  double found = 0, given = 0;
  for (int v = 0; v < h.size(); ++v) {
    const Eigen::Vector3d p = mesh.position(v);
    const Eigen::Vector3d normal =
        Eigen::Vector3d(p.x() / (length * length), p.y(), p.z()).normalized();
    found += h[v] * moved.col(v).dot(normal);
    given += h[v] * h[v];
  }
  return found / given;
}

/// the gradient of a function in a face
Eigen::Vector3d gradient(const Mesh_view& mesh, int f, const Eigen::VectorXd& h)
{
  const Eigen::Vector3d normal = mesh.double_area_vector(f);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int c = 0; c < 3; ++c)
    sum += h[mesh.corners(f)[at(c)]] * normal.cross(mesh.vector(3 * f + c));
  return sum / normal.squaredNorm();
}

// The error is that of the mesh, as on the disk, and on limbs also what is omitted.
TEST(Curvature_of_displacement, brings_low_bumps_up_on_spheres_and_on_limbs)
{
  for (const double s : {.25, .35})
    for (const double length : {1., 2., 3.}) {
      const double coarse = recovered_on_a_limb(4, length, s),
                   fine = recovered_on_a_limb(5, length, s);
      EXPECT_NEAR(fine, 1, .05) << s << " " << length;
      EXPECT_LT(std::abs(fine - 1), .6 * std::abs(coarse - 1)) << s << " " << length;
    }
}

TEST(Curvature_of_displacement, is_worth_half_the_energy_against_every_linear_function)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const Eigen::VectorXd h = random_numbers(mesh.size_of_vertices(), 1);
  const Eigen::VectorXd g = random_numbers(mesh.size_of_vertices(), 2);
  double energy = 0;
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    energy +=
        mesh.double_area_vector(f).norm() / 2 * gradient(mesh, f, h).dot(gradient(mesh, f, g));
  const auto rho = CGP::curvature_of_displacement(mesh, h);
  EXPECT_EQ(rho.on, Curvature_potential::On::vertices);
  EXPECT_NEAR(CGP::vertex_areas(mesh).cwiseProduct(rho.values).dot(g), energy / 2,
              1e-12 * h.norm() * g.norm());
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
