// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests spin/Dirac_spectrum.h
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Dirac_spectrum.h>
#include <Quaternionic_linear_algebra/dense/block_operators.h>
#include <Quaternionic_linear_algebra/dense/hermitian_eigen_decomposition.h>

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "support/decompositions.h"
#include "support/dense.h"
#include "support/fibonacci_sphere.h"
#include "support/spheres.h"
#include "support/torus_spectrum.h"

namespace cgp_test::dirac_spectrum_at_shifts_tests {

// The eigenvalues next to shifts, of which many are eigenvalues, counted by independent means.

namespace CGP = Conformal_geometry_processing;
using CGP::internal::Dirac_spectrum;

Dirac_spectrum spectrum(const Mesh_view& mesh, int count, double shift)
{
  CGP::internal::Dirac_spectrum_options options;
  options.shift = shift;
  return CGP::internal::Dirac_spectral_problem(mesh).find(CGP::no_potential(mesh), count, options);
}

/// On the unit sphere: the integers n but -1, |n + 1| times each, as far as the window reaches.
void expect_integers(const Mesh_view& sphere, int count, double shift)
{
  const double resolution = 0.3;  // of clusters, which the meshes displace by less
  const Dirac_spectrum s = spectrum(sphere, count, shift);
  ASSERT_TRUE(s.is_complete()) << shift;
  ASSERT_EQ(s.size(), count);
  std::vector<double> found;
  for (const auto& [value, multiplicity] : CGP::with_multiplicities(s.eigenvalues, resolution)) {
    const double n = std::round(value);
    EXPECT_LT(std::abs(value - n), resolution) << shift;
    found.push_back(n);
    const bool is_cut = std::abs(n - shift) > s.complete_radius - resolution;
    EXPECT_LE(multiplicity, std::abs(n + 1)) << n << " next to " << shift;
    EXPECT_TRUE(is_cut || multiplicity == std::abs(n + 1)) << n << " next to " << shift;
  }
  for (double n = -40; n < 40; ++n) {
    if (n == -1 || std::abs(n - shift) > s.complete_radius - resolution) continue;
    EXPECT_EQ(std::count(found.begin(), found.end(), n), 1) << n << " next to " << shift;
  }
}

TEST(Dirac_spectrum_at_shifts, holds_the_integers_of_a_sphere_of_1000_points)
{
  const Mesh_view sphere = fibonacci_sphere(1000);
  for (int shift = -5; shift <= 6; ++shift) expect_integers(sphere, 12, shift);
}

TEST(Dirac_spectrum_at_shifts, holds_the_integers_of_a_sphere_of_3000_points)
{
  const Mesh_view sphere = fibonacci_sphere(3000);
  for (const double shift : {-4., 1., 2., 2.003}) expect_integers(sphere, 12, shift);
}

TEST(Dirac_spectrum_at_shifts, holds_the_integers_of_a_sphere_of_10000_points)
{
  expect_integers(fibonacci_sphere(10000), 12, -3);
}

TEST(Dirac_spectrum_at_shifts, holds_the_integers_of_scattered_points)
{
  Points p = scattered_points(2000, 5);
  Corners corners = convex_hull(p);
  const Mesh_view sphere(std::move(p), std::move(corners));
  for (const double shift : {-4., 2.}) expect_integers(sphere, 12, shift);
}

TEST(Dirac_spectrum_at_shifts, tells_apart_what_is_nearer_than_the_discretisation_error)
{
  // That of the eigenvalue 9 is about one.
  expect_integers(fibonacci_sphere(3000), 12, 9);
}

/// the greatest distance of sorted values to as many consecutive ones of a longer list
double distance_to_consecutive(const Eigen::VectorXd& values, const std::vector<double>& all)
{
  Eigen::VectorXd sorted = values;
  std::sort(sorted.begin(), sorted.end());
  const Eigen::Map<const Eigen::VectorXd> list(all.data(), static_cast<Eigen::Index>(all.size()));
  double best = std::numeric_limits<double>::infinity();
  for (Eigen::Index first = 0; first + sorted.size() <= list.size(); ++first)
    best = std::min(best, (list.segment(first, sorted.size()) - sorted).cwiseAbs().maxCoeff());
  return best;
}

TEST(Dirac_spectrum_at_shifts, is_that_of_the_ordinary_differential_equations_of_the_torus)
{
  const std::vector<double> exact = torus_spectrum(2, 1, 4);
  const Mesh_view regular = torus(2, 1, 64, 32), jittered = jittered_torus(2, 1, 64, 32, 0.2);
  for (const double shift : {-1., 0., 1., 1.5})
    for (const Mesh_view& mesh : {regular, jittered}) {
      const Dirac_spectrum s = spectrum(mesh, 12, shift);
      ASSERT_TRUE(s.is_complete()) << shift;
      EXPECT_LT(distance_to_consecutive(s.eigenvalues, exact), 0.04) << shift;
    }
}

/// the eigenvalues mu of X lambda = mu M_V lambda, each of the four times that it has over the
/// reals
Eigen::VectorXd dense_squares(const Mesh_view& mesh, double shift)
{
  CGP::Curvature_potential rho = CGP::no_potential(mesh);
  rho.values.array() += shift;
  const Eigen::VectorXd roots =
      CGP::vertex_areas(mesh).replicate(1, 4).transpose().reshaped().cwiseSqrt();
  const Eigen::MatrixXd X = real_form(dense(CGP::dirac_energy(mesh, rho)));
  const auto scale = roots.cwiseInverse().asDiagonal();
  return symmetric_eigenvalues(scale * X * scale);
}

/// those in the span of the eigenvectors found, which are M_V-orthogonal
Eigen::VectorXd squares_in_span(const Mesh_view& mesh, double shift, const Dirac_spectrum& s)
{
  CGP::Curvature_potential rho = CGP::no_potential(mesh);
  rho.values.array() += shift;
  const auto X = CGP::dirac_energy(mesh, rho);
  const auto forms = CGP::gram_matrix(s.vectors, CGP::block_operator(X)(s.vectors));
  return CGP::hermitian_eigen_decomposition(forms).values / area(mesh);
}

TEST(Dirac_spectrum_at_shifts, contains_the_lowest_eigenvectors_of_the_dense_square)
{
  for (const Mesh_view& mesh : {scan(250), radially_perturbed(icosphere(2), 0.1)})
    for (const double shift : {-2., 0.5, 2.}) {
      const Dirac_spectrum s = spectrum(mesh, 14, shift);
      const Eigen::VectorXd found = squares_in_span(mesh, shift, s);
      const Eigen::VectorXd all = dense_squares(mesh, shift);
      const double bound = std::pow(0.7 * s.complete_radius, 2);
      EXPECT_GE((all.array() < bound).count(), 4 * 4) << shift;
      for (Eigen::Index k = 0; all[4 * k] < bound; ++k)
        EXPECT_NEAR(found[k], all[4 * k], 0.06 * all[4 * k]) << shift;
    }
}

TEST(Dirac_spectrum_at_shifts, does_not_depend_on_how_near_the_shift_is_to_an_eigenvalue)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const Eigen::VectorXd expected = spectrum(mesh, 6, 0).eigenvalues;
  for (const double shift : {1e-12, 1e-9, 1e-6, 1e-3}) {
    const Dirac_spectrum s = spectrum(mesh, 6, shift);
    ASSERT_TRUE(s.is_complete()) << shift;
    EXPECT_LT((s.eigenvalues - expected).cwiseAbs().maxCoeff(), 2 * shift + 1e-9) << shift;
  }
}

/// \brief the greatest difference between eigenvalues next to a shift, and those of a list next to
/// zero that has them too
double difference_from(const Eigen::VectorXd& list, const Dirac_spectrum& s, double radius)
{
  const auto within = [&](const Eigen::VectorXd& values) {
    std::vector<double> v;
    std::copy_if(values.begin(), values.end(), std::back_inserter(v),
                 [&](double g) { return std::abs(g - s.shift) < radius; });
    std::sort(v.begin(), v.end());
    return v;
  };
  const std::vector<double> a = within(list), b = within(s.eigenvalues);
  EXPECT_EQ(a.size(), b.size());
  double difference = 0;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
    difference = std::max(difference, std::abs(a[k] - b[k]));
  return difference;
}

// At the shift -2, X mixes -2.11 and -1.72, of which the mesh resolves one worse than the other, so
// that their squares differ by a factor of more than two.
TEST(Dirac_spectrum_at_shifts, separates_signs_where_errors_tell_the_squares_apart)
{
  const Mesh_view mesh = torus(2, 1, 48, 24);
  const Eigen::VectorXd around_zero = spectrum(mesh, 60, 0).eigenvalues;
  EXPECT_LT(difference_from(around_zero, spectrum(mesh, 12, -2), 0.45), 0.01);
}

TEST(Dirac_spectrum_at_shifts, holds_the_constants_that_are_far_from_the_shift)
{
  const Dirac_spectrum s = spectrum(fibonacci_sphere(1000), 14, -3);
  ASSERT_GT(s.complete_radius, 3.1);
  EXPECT_EQ((s.eigenvalues.array().abs() < 1e-6).count(), 1);
}

/// the faces all of whose corners are above a height
Mesh_view above(const Mesh_view& mesh, double height)
{
  Points points(3, 0);
  Corners corners;
  std::map<int, int> number;
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    std::array<int, 3> c = mesh.corners(f);
    if (std::any_of(c.begin(), c.end(), [&](int v) { return mesh.position(v).z() <= height; }))
      continue;
    for (int& v : c) {
      const auto [place, is_new] = number.emplace(v, static_cast<int>(number.size()));
      if (is_new) points.conservativeResize(Eigen::NoChange, points.cols() + 1);
      if (is_new) points.rightCols(1) = mesh.position(v);
      v = place->second;
    }
    corners.push_back(c);
  }
  return {std::move(points), std::move(corners)};
}

// Where the boundary is jagged, the binormals are, and vectors next to the eigenvalue 0 err by more
// than half of their images.
TEST(Dirac_spectrum_at_shifts, is_complete_next_to_a_jagged_boundary)
{
  const Mesh_view mesh = above(icosphere(3), -0.2);
  const Dirac_spectrum s =
      CGP::internal::Dirac_spectral_problem(mesh, CGP::Boundary_condition::binormals())
          .find(CGP::no_potential(mesh), 10, {});
  EXPECT_TRUE(s.is_complete());
  EXPECT_GT(s.complete_radius, 1.5);
}

TEST(Dirac_spectrum_at_shifts, says_how_far_it_is_complete_where_more_is_asked)
{
  const Mesh_view mesh = icosphere(1);
  const Dirac_spectrum s = spectrum(mesh, 42, 0);
  EXPECT_EQ(s.wanted, 42);
  EXPECT_FALSE(s.is_complete());
  EXPECT_GT(s.complete_radius, 2.3);  // -2, 0, 1, 1, 2, 2, 2 of so coarse a sphere
  EXPECT_LT(s.complete_radius, 6);
}

TEST(Dirac_spectrum_at_shifts, is_in_the_unit_of_the_mesh)
{
  const Mesh_view mesh = icosphere(2);
  const Dirac_spectrum here = spectrum(mesh, 4, 1), there = spectrum(scaled(mesh, 5), 4, .2);
  EXPECT_GT(here.complete_radius, 0);
  EXPECT_NEAR(5 * there.complete_radius, here.complete_radius, 1e-6);
  EXPECT_LT((5 * there.eigenvalues - here.eigenvalues).norm(), 1e-6);
}

}  // namespace cgp_test::dirac_spectrum_at_shifts_tests
