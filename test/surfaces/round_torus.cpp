// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests surfaces/tori.h
#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/surfaces/tori.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "support/mesh_tools.h"

namespace cgp_test::round_torus_tests {

namespace CGP = Conformal_geometry_processing;
using Quaternion = CGP::Quaternion<double>;

double energy_of_class(double b)
{
  return pi * pi * (b + 1 / b);
}

/// the unit quaternion whose projection is p
Quaternion inverse_stereographic_projection(const Eigen::Vector3d& p)
{
  const double s = p.squaredNorm();
  Quaternion q = CGP::imaginary(2 * p);
  q.w = s - 1;
  return q / (s + 1);
}

/// the image of the same surface in the 3-sphere, seen from another point p
Mesh_view seen_from(const Quaternion& p, const Mesh_view& mesh)
{
  return mapped(mesh, [&](const Eigen::Vector3d& x) -> Eigen::Vector3d {
    return CGP::stereographic_projection(CGP::conjugate(p) * inverse_stereographic_projection(x));
  });
}

TEST(Torus_grid, is_a_closed_oriented_torus_whatever_its_shift)
{
  for (int shift : {0, 3, -4, 7, 61}) {
    const Mesh_view mesh = CGP::torus_grid(6, 7, shift, [](int i, int j) {
      const double u = pi / 3 * i, v = 2 * pi / 7 * j;  // with creases, unless the shift is zero
      const double d = 3 + std::cos(v);
      return Eigen::Vector3d(d * std::cos(u), d * std::sin(u), std::sin(v));
    });
    EXPECT_NO_THROW(CGP::require_surface(mesh, "test")) << shift;
    EXPECT_NO_THROW(CGP::require_closed(mesh, "test")) << shift;
    EXPECT_EQ(mesh.size_of_vertices() - mesh.size_of_edges() + mesh.size_of_faces(), 0) << shift;
    EXPECT_EQ(mesh.size_of_faces(), 84);
  }
}

TEST(Torus_grid, refuses_less_than_three_rows_or_columns)
{
  const auto origin = [](int, int) { return Eigen::Vector3d(0, 0, 0); };
  EXPECT_THROW((void)CGP::torus_grid(2, 5, 0, origin), CGP::Precondition_error);
  EXPECT_THROW((void)CGP::torus_grid(5, 2, 0, origin), CGP::Precondition_error);
}

TEST(Stereographic_projection, scales_distances_by_one_factor_from_each_end)
{
  const auto q = CGP::random_quaternions(20, 1, 1);
  for (int k = 0; k + 1 < 20; ++k) {
    const Quaternion a = q(k, 0) / CGP::norm(q(k, 0)), b = q(k + 1, 0) / CGP::norm(q(k + 1, 0));
    const Eigen::Vector3d x = CGP::stereographic_projection(a),
                          y = CGP::stereographic_projection(b);
    EXPECT_NEAR((x - y).norm(), CGP::norm(a - b) / std::sqrt((1 - a.w) * (1 - b.w)),
                1e-12 * (x.norm() + y.norm() + 1));
    EXPECT_LT(CGP::norm(inverse_stereographic_projection(x) - a), 1e-13);
  }
}

TEST(Round_torus, is_at_distance_r_from_a_circle_of_radius_R_with_normals_outward)
{
  const double R = 3, r = 1.7;
  const Mesh_view mesh = CGP::round_torus(R, r, 20, 12);
  for (int v = 0; v < mesh.size_of_vertices(); ++v) {
    const Eigen::Vector3d p = mesh.position(v);
    EXPECT_NEAR(std::hypot(std::hypot(p.x(), p.y()) - R, p.z()), r, 1e-14);
  }
  EXPECT_NEAR(CGP::signed_volume(CGP::round_torus(R, r, 200, 120)), 2 * pi * pi * R * r * r,
              2e-3 * 2 * pi * pi * R * r * r);
}

TEST(Homogeneous_torus, is_made_of_near_squares)
{
  for (const double b : {.6, 1., 1.5}) {
    const int n = 60;
    const Mesh_view mesh = CGP::homogeneous_torus(b, n);
    for (int v = 0; v < n; ++v) {
      const Eigen::Vector3d p = mesh.position(v);
      const double along = (mesh.position(v + n) - p).norm(),
                   around = (mesh.position((v + 1) % n) - p).norm();
      EXPECT_NEAR(along / around, 1, .1) << b;
    }
  }
}

/// Extrapolates errors of order h^2 from h and h / 2
double limit(double coarse, double fine)
{
  return (4 * fine - coarse) / 3;
}

TEST(Homogeneous_torus, has_the_energy_pi_squared_b_plus_one_over_b_and_the_modulus_b)
{
  for (const double b : {.6, 1., 1.5}) {
    std::vector<double> h, energies, moduli;
    for (const int n : {20, 40, 80}) {
      const Mesh_view mesh = CGP::homogeneous_torus(b, n);
      h.push_back(1. / n);
      energies.push_back(CGP::willmore_energy(mesh) / energy_of_class(b) - 1);
      const std::complex<double> modulus(0, std::max(b, 1 / b));
      moduli.push_back(std::abs(CGP::conformal_modulus(mesh) - modulus));
    }
    EXPECT_NEAR(slope(h, energies), 2, .2) << b;
    EXPECT_NEAR(limit(energies[1], energies[2]), 0, 1e-3) << b;
    EXPECT_LT(moduli[2], moduli[0] / 14 + 1e-6) << b;
    EXPECT_LT(moduli[2], 2e-3) << b;
  }
}

TEST(Homogeneous_torus, seen_from_elsewhere_in_the_three_sphere_has_the_same_energy_and_modulus)
{
  const Quaternion p = Quaternion{3, 2, 1, 2} / std::sqrt(18.);
  std::vector<double> h, energies, moduli;
  for (const int n : {30, 60, 120}) {
    const Mesh_view mesh = CGP::homogeneous_torus(1.4, n), image = seen_from(p, mesh);
    h.push_back(1. / n);
    energies.push_back(CGP::willmore_energy(image) / energy_of_class(1.4) - 1);
    moduli.push_back(std::abs(CGP::conformal_modulus(image) - std::complex<double>(0, 1.4)));
  }
  EXPECT_NEAR(slope(h, energies), 2, .3);
  EXPECT_NEAR(limit(energies[1], energies[2]), 0, 2e-3);
  EXPECT_GT(slope(h, moduli), 1.8);
  EXPECT_LT(moduli.back(), 5e-3);
}

TEST(Round_torus, refuses_radii_that_make_no_torus)
{
  EXPECT_THROW((void)CGP::round_torus(1, 1, 8, 8), CGP::Precondition_error);
  EXPECT_THROW((void)CGP::round_torus(1, 0, 8, 8), CGP::Precondition_error);
  EXPECT_THROW((void)CGP::round_torus(NAN, 1, 8, 8), CGP::Precondition_error);
  EXPECT_THROW((void)CGP::homogeneous_torus(0, 8), CGP::Precondition_error);
  EXPECT_THROW((void)CGP::homogeneous_torus(NAN, 8), CGP::Precondition_error);
  EXPECT_THROW((void)CGP::homogeneous_torus(.1, 8), CGP::Precondition_error);
}

}  // namespace cgp_test::round_torus_tests
