// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Dirac_spectrum.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>
#include <Quaternionic_linear_algebra/dense/block_operators.h>

#include <gtest/gtest.h>

#include "spin/branch_tools.h"
#include "support/bounded_meshes.h"
#include "support/spheres.h"

#include <limits>

namespace cgp_test::dirac_spectrum_tests {

namespace CGP = Conformal_geometry_processing;

TEST(With_multiplicities, joins_what_is_nearer_than_the_resolution)
{
  const Eigen::VectorXd values = (Eigen::VectorXd(6) << 2.04, -1, 1.96, 0.5, 2, 0.5).finished();
  const auto groups = CGP::with_multiplicities(values, 0.1);
  ASSERT_EQ(groups.size(), 3u);
  EXPECT_EQ(groups[0].value, -1);
  EXPECT_EQ(groups[0].multiplicity, 1);
  EXPECT_EQ(groups[1].value, 0.5);
  EXPECT_EQ(groups[1].multiplicity, 2);
  EXPECT_NEAR(groups[2].value, 2, 1e-15);
  EXPECT_EQ(groups[2].multiplicity, 3);
}

TEST(Dirac_spectrum, is_complete_if_all_that_was_asked_for_is_in_the_window)
{
  CGP::internal::Dirac_spectrum s;
  s.shift = 2;
  s.wanted = 2;
  s.eigenvalues = Eigen::Vector2d(2.5, 1.25);
  s.complete_radius = 0.8;
  EXPECT_FALSE(s.is_complete());  // not converged
  s.converged = true;
  EXPECT_TRUE(s.is_complete());
  s.complete_radius = 0.7;
  EXPECT_FALSE(s.is_complete());
  s.complete_radius = 0.8;
  s.wanted = 3;
  EXPECT_FALSE(s.is_complete());
}

TEST(With_multiplicities, of_nothing_is_nothing)
{
  EXPECT_TRUE(CGP::with_multiplicities(Eigen::VectorXd(), 1).empty());
}

CGP::internal::Dirac_spectrum spectrum(const Mesh_view& mesh, int count, double shift = 0,
                                       const CGP::Boundary_condition& condition = {})
{
  CGP::internal::Dirac_spectrum_options options;
  options.shift = shift;
  return CGP::internal::Dirac_spectral_problem(mesh, condition)
      .find(CGP::no_potential(mesh), count, options);
}

void expect_eigenvalues(const CGP::internal::Dirac_spectrum& s, double resolution,
                        const std::vector<std::pair<double, int>>& expected, double error)
{
  ASSERT_TRUE(s.converged);
  const auto found = CGP::with_multiplicities(s.pencil_eigenvalues, resolution);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_NEAR(found[k].value, expected[k].first, error);
    EXPECT_EQ(found[k].multiplicity, expected[k].second) << expected[k].first;
  }
}

TEST(Dirac_spectrum_of_the_sphere, holds_all_integers_n_but_minus_one_n_plus_one_times)
{
  // 8 000 faces, as tabled in the specification; the constants are the one with eigenvalue 0.
  expect_eigenvalues(
      spectrum(geodesic_sphere(20), 16), 0.5,
      {{-4.0095, 3}, {-3.0037, 2}, {-2.00123, 1}, {0, 1}, {1.00062, 2}, {2.00402, 3}, {3.0111, 4}},
      5e-5);
}

TEST(Dirac_spectrum_of_the_sphere, has_errors_of_second_order)
{
  std::vector<double> h;
  std::vector<std::vector<double>> errors(6);
  for (int level : {2, 3, 4}) {
    const Mesh_view sphere = icosphere(level);
    const CGP::internal::Dirac_spectrum s = spectrum(sphere, 7);
    h.push_back(mean_edge_length(sphere));
    for (const bool of_pencil : {false, true}) {
      const auto values =
          CGP::with_multiplicities(of_pencil ? s.pencil_eigenvalues : s.eigenvalues, 0.5);
      ASSERT_EQ(values.size(), 4u);
      std::vector<double>* const e = &errors[of_pencil ? 3 : 0];
      e[0].push_back(values[0].value + 2);
      e[1].push_back(values[2].value - 1);
      e[2].push_back(values[3].value - 2);
    }
  }
  for (const auto& e : errors) EXPECT_NEAR(slope(h, e), 2, 0.1);
}

TEST(Dirac_spectrum_of_the_sphere, next_to_a_shift_comes_first)
{
  const CGP::internal::Dirac_spectrum s = spectrum(icosphere(3), 9, 3.4);
  ASSERT_TRUE(s.converged);
  EXPECT_EQ(s.size_of_constants, 0);
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(s.eigenvalues[k], 3, 0.05);
  for (int k = 4; k < 9; ++k) EXPECT_NEAR(s.eigenvalues[k], 4, 0.1);
  const auto others = CGP::with_multiplicities(spectrum(icosphere(3), 6, -1).eigenvalues, 0.5);
  const int expected[][2] = {{-3, 2}, {-2, 1}, {0, 1}, {1, 2}};
  ASSERT_EQ(others.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(others[k].value, expected[k][0], 0.05);
    EXPECT_EQ(others[k].multiplicity, expected[k][1]);
  }
}

TEST(Dirac_spectrum_of_the_sphere, is_not_missed_where_the_shift_is_at_an_eigenvalue)
{
  // The pencil alone takes 2 for something else on so coarse a mesh.
  for (const double shift : {1.9, 2.0, 2.1}) {
    const CGP::internal::Dirac_spectrum s = spectrum(icosphere(2), 5, shift);
    ASSERT_TRUE(s.converged);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(s.eigenvalues[k], 2, 0.1) << shift;
    for (int k = 3; k < 5; ++k) EXPECT_GT(std::abs(s.eigenvalues[k] - 2), 0.9) << shift;
  }
}

TEST(Standard_problem, mixes_the_signs_that_the_spectrum_tells_apart)
{
  // X has the eigenvalue n^2 with the multiplicities of n and -n together: 2 n.
  const Mesh_view sphere = geodesic_sphere(20);
  CGP::internal::Dirac_system system(sphere);
  CGP::internal::Dirac_evidence::Seconds seconds;
  system.set_potential(CGP::no_potential(sphere), seconds);
  const CGP::Eigensolver_result r =
      smallest(system, CGP::random_quaternions(sphere.size_of_vertices(), 9, 1), 7, 1e-6, 100);
  ASSERT_TRUE(r.converged);
  std::vector<double> found;
  for (int k = 0; k < 7; ++k) found.push_back(std::sqrt(std::max(r.values[k], 0.)));
  EXPECT_NEAR(found[0], 0, 1e-5);
  for (int k = 1; k < 3; ++k) EXPECT_NEAR(found[at(k)], 1, 1e-4);
  for (int k = 3; k < 7; ++k) EXPECT_NEAR(found[at(k)], 1.9998, 4e-4);
}

TEST(Dirac_spectral_problem, has_orthogonal_vectors_that_nearly_diagonalise_the_signed_form)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const double shift = -0.3;
  const auto rho = CGP::Curvature_potential::on_faces(rho_of_section_3_on_faces(mesh));
  CGP::internal::Dirac_spectrum_options options;
  options.shift = shift;
  const CGP::internal::Dirac_spectrum s =
      CGP::internal::Dirac_spectral_problem(mesh).find(rho, 6, options);
  ASSERT_TRUE(s.is_complete());
  EXPECT_LT(s.residuals.maxCoeff(), options.tolerance);
  const auto shifted = CGP::Curvature_potential::on_faces((rho.values.array() + shift).matrix());
  const auto X = CGP::dirac_energy(mesh, shifted), K = CGP::dirac_form(mesh, shifted);
  const auto areas = CGP::vertex_areas(mesh);
  const auto gram = [&](const auto& A) {
    return CGP::gram_matrix(s.vectors, CGP::block_operator(A)(s.vectors));
  };
  const auto masses = gram(areas), forms = gram(K), energies = gram(X);
  for (int k = 0; k < 6; ++k) {
    for (int j = 0; j < k; ++j) {
      EXPECT_LT(norm(masses(j, k)), 1e-9);
      EXPECT_LT(norm(forms(j, k)), 0.03 * areas.sum());
    }
    EXPECT_NEAR(masses(k, k).w, areas.sum(), 1e-10);
    EXPECT_NEAR(s.pencil_eigenvalues[k], shift + energies(k, k).w / forms(k, k).w, 1e-10);
    EXPECT_NEAR(s.eigenvalues[k], shift + CGP::dirac_quotient(mesh, shifted, s.vectors.col(k)),
                1e-12);
    const double before = k > 0 ? std::abs(s.eigenvalues[k - 1] - shift) : 0;
    EXPECT_GE(std::abs(s.eigenvalues[k] - shift), before);
  }
}

TEST(Dirac_spectral_problem, leaves_the_constants_out_of_the_others)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const CGP::internal::Dirac_spectrum s = spectrum(mesh, 5);
  EXPECT_EQ(s.size_of_constants, 1);
  EXPECT_EQ(s.eigenvalues[0], 0);
  const Eigen::VectorXd areas = CGP::vertex_areas(mesh);
  for (Eigen::Index k = 1; k < 5; ++k) {
    CGP::Quaternion<double> mean;
    for (Eigen::Index i = 0; i < areas.size(); ++i) mean += areas[i] * s.vectors(i, k);
    EXPECT_LT(norm(mean), 1e-9);
  }
  const CGP::internal::Dirac_spectrum only = spectrum(mesh, 1);
  EXPECT_TRUE(only.converged);
  for (Eigen::Index i = 0; i < areas.size(); ++i)
    EXPECT_LT(norm(only.vectors(i, 0) - CGP::Quaternion<double>{1, 0, 0, 0}), 1e-14);
}

TEST(Dirac_spectral_problem, moves_with_constant_rho_and_scales_as_one_over_length)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const Eigen::VectorXd values = spectrum(mesh, 6).eigenvalues;
  CGP::internal::Dirac_spectrum_options options;
  options.shift = -0.75;
  const auto rho = CGP::Curvature_potential::on_vertices(
      Eigen::VectorXd::Constant(mesh.size_of_vertices(), 0.75));
  const Eigen::VectorXd moved =
      CGP::internal::Dirac_spectral_problem(mesh).find(rho, 6, options).eigenvalues;
  EXPECT_LT((moved.array() + 0.75 - values.array()).abs().maxCoeff(), 1e-9);
  const Mesh_view large =
      mapped(mesh, [](const Eigen::Vector3d& p) { return Eigen::Vector3d(1e3 * p.array() + 5e4); });
  const CGP::internal::Dirac_spectrum of_large = spectrum(large, 6);
  EXPECT_LT((1e3 * of_large.eigenvalues - values).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_LT((1e3 * of_large.pencil_eigenvalues - spectrum(mesh, 6).pencil_eigenvalues)
                .cwiseAbs()
                .maxCoeff(),
            1e-6);
}

TEST(Dirac_spectrum_of_the_disk, holds_the_zeros_of_bessel_functions_of_either_sign)
{
  // j'_11, j_01, j'_21
  const double zeros[] = {1.8411837813, 2.4048255577, 3.0542369283};
  const int multiplicities[] = {2, 1, 2};
  std::vector<double> h;
  std::vector<std::vector<double>> errors(3);
  for (int n : {8, 12, 16}) {
    const CGP::internal::Dirac_spectrum s =
        spectrum(disk(n), 11, 0, CGP::Boundary_condition::binormals());
    ASSERT_TRUE(s.converged);
    EXPECT_EQ(s.size_of_constants, 1);
    const auto values = CGP::with_multiplicities(s.eigenvalues, 0.2);
    ASSERT_EQ(values.size(), 7u);
    EXPECT_EQ(values[3].value, 0);
    EXPECT_EQ(values[3].multiplicity, 1);
    h.push_back(1. / n);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(values[2 - k].multiplicity, multiplicities[k]);
      EXPECT_EQ(values[4 + k].multiplicity, multiplicities[k]);
      EXPECT_NEAR(values[2 - k].value, -values[4 + k].value, 1e-6);
      errors[k].push_back(values[4 + k].value - zeros[k]);
    }
  }
  for (const auto& e : errors) EXPECT_NEAR(slope(h, e), 2, 0.25);
}

TEST(Dirac_spectrum_of_the_disk, next_to_a_shift_is_that_of_the_specification)
{
  const CGP::internal::Dirac_spectrum s =
      spectrum(disk(16), 3, 2.1, CGP::Boundary_condition::binormals());
  expect_eigenvalues(s, 0.2, {{1.84008, 2}, {2.41176, 1}}, 1e-5);
}

TEST(Dirac_spectral_problem, stops_when_told)
{
  const Mesh_view mesh = icosphere(1);
  const CGP::internal::Dirac_spectrum s = CGP::internal::Dirac_spectral_problem(mesh).find(
      CGP::no_potential(mesh), 4, {}, [](const CGP::internal::Krylov_progress&) { return false; });
  EXPECT_TRUE(s.cancelled);
  EXPECT_FALSE(s.converged);
}

TEST(Dirac_spectral_problem, refuses_to_be_asked_for_by_its_own_visitor)
{
  const Mesh_view mesh = icosphere(1);
  const auto none = CGP::no_potential(mesh);
  CGP::internal::Dirac_spectral_problem problem(mesh);
  int refused = 0;
  const CGP::internal::Dirac_spectrum s =
      problem.find(none, 4, {}, [&](const CGP::internal::Krylov_progress&) {
        EXPECT_THROW((void)problem.find(none, 4), CGP::Precondition_error);
        return ++refused > 0;
      });
  EXPECT_GT(refused, 0);
  EXPECT_TRUE(s.converged);
}

TEST(Dirac_spectral_problem, refuses_what_has_none)
{
  const Mesh_view mesh = icosphere(1), plane = disk(3);
  const auto none = CGP::no_potential(mesh);
  CGP::internal::Dirac_spectral_problem problem(mesh);
  EXPECT_THROW((void)problem.find(none, 0), CGP::Precondition_error);
  EXPECT_THROW((void)problem.find(none, mesh.size_of_vertices() + 1), CGP::Precondition_error);
  EXPECT_THROW((void)problem.find(CGP::no_potential(plane), 1), CGP::Precondition_error);
  auto infinite = none;
  infinite.values[3] = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)problem.find(infinite, 1), CGP::Precondition_error);
  using Problem = CGP::internal::Dirac_spectral_problem;
  EXPECT_THROW(Problem{plane}, CGP::Precondition_error);
  EXPECT_THROW((Problem{plane, CGP::Boundary_condition::tangents()}), CGP::Precondition_error);
  EXPECT_THROW((Problem{mesh, CGP::Boundary_condition::binormals()}), CGP::Precondition_error);
}

}  // namespace cgp_test::dirac_spectrum_tests
