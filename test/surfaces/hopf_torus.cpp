// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests surfaces/tori.h
#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/surfaces/tori.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "support/mesh_tools.h"

namespace cgp_test::hopf_torus_tests {

namespace CGP = Conformal_geometry_processing;
using Complex = std::complex<double>;

/// a curve around the axis z whose latitude goes up and down three times
Eigen::Vector3d wave(double t)
{
  const double latitude = .2 + .15 * std::cos(3 * t);
  return {std::cos(latitude) * std::cos(t), std::cos(latitude) * std::sin(t), std::sin(latitude)};
}

Points sampled(int m)
{
  Points curve(3, m);
  for (int i = 0; i < m; ++i) curve.col(i) = wave(2 * pi * i / m);
  return curve;
}

/// m equidistant points along a closed polygon, including its first vertex; `lengths` are those of
/// its edges from point i to the next
Points evenly_spaced(const Points& polygon, const Eigen::VectorXd& lengths, int m)
{
  const Eigen::Index k = polygon.cols();
  Points points(3, m);
  const double step = lengths.sum() / m;
  Eigen::Index edge = 0;
  double start = 0;  // of the edge
  for (int i = 0; i < m; ++i) {
    while (edge < k - 1 && start + lengths[edge] <= i * step) start += lengths[edge++];
    const double t = (i * step - start) / lengths[edge];
    points.col(i) = (1 - t) * polygon.col(edge) + t * polygon.col((edge + 1) % k);
  }
  return points;
}

/// m points on the wave, evenly, and as many columns as make squares
Mesh_view torus_over_the_wave(int m)
{
  const Points fine = sampled(64 * m);
  Eigen::VectorXd lengths(fine.cols());
  for (Eigen::Index i = 0; i < fine.cols(); ++i)
    lengths[i] = (fine.col((i + 1) % fine.cols()) - fine.col(i)).norm();
  const CGP::Hopf_torus torus(evenly_spaced(fine, lengths, m));
  return torus.mesh(static_cast<int>(std::round(4 * pi * m / torus.length())));
}

/// the length of the wave, the area above it, and the integral of 1 + curvature^2 along it
Eigen::Vector3d integrals_of_the_wave()
{
  const int n = 4000;
  const double h = 1e-4, dt = 2 * pi / n;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < n; ++i) {
    const double t = i * dt;
    const Eigen::Vector3d p = wave(t), d = (wave(t + h) - wave(t - h)) / (2 * h),
                          dd = (wave(t + h) - 2 * p + wave(t - h)) / (h * h);
    const double curvature = p.dot(d.cross(dd)) / std::pow(d.norm(), 3);
    sum += dt * Eigen::Vector3d(d.norm(), 1 - p.z(), (1 + curvature * curvature) * d.norm());
  }
  return sum;
}

TEST(Hopf_torus, over_a_circle_is_a_round_torus)
{
  for (const double colatitude : {.8, 1.6, 2.5}) {
    Points circle(3, 20);
    for (int i = 0; i < 20; ++i)
      circle.col(i) << std::sin(colatitude) * std::cos(pi / 10 * i),
          std::sin(colatitude) * std::sin(pi / 10 * i), std::cos(colatitude);
    const Mesh_view mesh = CGP::Hopf_torus(3 * circle).mesh(17);
    const double R = 1 / std::sin(colatitude / 2), r = 1 / std::tan(colatitude / 2);
    for (int v = 0; v < mesh.size_of_vertices(); ++v) {
      const Eigen::Vector3d p = mesh.position(v);
      EXPECT_NEAR(std::hypot(std::hypot(p.x(), p.y()) - R, p.z()), r, 1e-12);
    }
  }
}

TEST(Hopf_torus, over_the_boundary_of_an_octant_has_its_length_and_area)
{
  Points octant = Points::Identity(3, 3);
  const CGP::Hopf_torus torus(octant);
  EXPECT_NEAR(torus.length(), 3 * pi / 2, 1e-14);
  EXPECT_NEAR(torus.area(), pi / 2, 1e-14);
  EXPECT_LT(std::abs(torus.modulus() - Complex(1. / 8, 3. / 8)), 1e-14);
  const Points reversed = octant.rowwise().reverse();
  EXPECT_NEAR(CGP::Hopf_torus(reversed).area(), 4 * pi - pi / 2, 1e-14);
}

TEST(Hopf_torus, has_the_length_and_the_area_of_its_curve)
{
  const Eigen::Vector3d expected = integrals_of_the_wave();
  std::vector<double> h, lengths, areas;
  for (const int m : {40, 80, 160}) {
    const CGP::Hopf_torus torus(sampled(m));
    h.push_back(1. / m);
    lengths.push_back(torus.length() - expected[0]);
    areas.push_back(torus.area() - expected[1]);
  }
  EXPECT_NEAR(slope(h, lengths), 2, .1);
  EXPECT_NEAR(slope(h, areas), 2, .1);
}

TEST(Hopf_torus, has_the_modulus_of_its_lattice_and_the_energy_of_its_curve)
{
  const Eigen::Vector3d expected = integrals_of_the_wave();
  const Complex tau(expected[1] / (4 * pi), expected[0] / (4 * pi));
  std::vector<double> h, moduli, energies;
  for (const int m : {40, 80, 160}) {
    const Mesh_view mesh = torus_over_the_wave(m);
    EXPECT_GT(CGP::signed_volume(mesh), 0);
    h.push_back(1. / m);
    moduli.push_back(
        std::abs(CGP::conformal_modulus(mesh) - CGP::reduced_modulus(-std::conj(tau))));
    energies.push_back(CGP::willmore_energy(mesh) / (pi * expected[2]) - 1);
  }
  EXPECT_NEAR(slope(h, moduli), 2, .3);
  EXPECT_LT(moduli.back(), 2e-3);
  EXPECT_NEAR(slope(h, energies), 2, .3);
  EXPECT_LT(std::abs(energies.back()), 5e-3);
}

TEST(Hopf_torus, over_a_curve_with_infinity_on_its_right_is_inside_out_and_of_the_other_area)
{
  const Points reversed = sampled(80).rowwise().reverse();
  const CGP::Hopf_torus torus(reversed);
  const Mesh_view mesh = torus.mesh(160);
  EXPECT_LT(CGP::signed_volume(mesh), 0);
  EXPECT_LT(
      std::abs(CGP::conformal_modulus(mesh) - CGP::reduced_modulus(-std::conj(torus.modulus()))),
      .02);
}

TEST(Hopf_torus, refuses_curves_that_are_none_or_go_through_infinity)
{
  const auto torus = [](Points curve) { return CGP::Hopf_torus(curve).mesh(8); };
  EXPECT_THROW((void)torus(Points::Identity(3, 2)), CGP::Precondition_error);
  EXPECT_THROW((void)torus(Points::Identity(3, 3)), CGP::Precondition_error);  // has (0, 0, 1)
  Points curve = sampled(8);
  EXPECT_NO_THROW((void)torus(curve));
  EXPECT_THROW((void)CGP::Hopf_torus(curve).mesh(2), CGP::Precondition_error);
  for (const Eigen::Vector3d& bad :
       {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(NAN, 1, 0), Eigen::Vector3d(2 * curve.col(2)),
        Eigen::Vector3d(-curve.col(4))}) {
    Points other = curve;
    other.col(3) = bad;
    EXPECT_THROW((void)torus(other), CGP::Precondition_error);
  }
}

}  // namespace cgp_test::hopf_torus_tests
