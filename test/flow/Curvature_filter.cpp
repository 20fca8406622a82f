// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Curvature_filter.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Quaternionic_linear_algebra/adapters/Eigen_hermitian_solver_traits.h>

#include <gtest/gtest.h>
#include <Eigen/Core>

#include "support/bounded_meshes.h"
#include "support/decompositions.h"
#include "support/dense.h"
#include "support/meshes.h"

#include <limits>

namespace cgp_test::curvature_filter_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_band;
using CGP::internal::Curvature_filter;

/// the Legendre polynomial of z, an eigenfunction of the sphere with eigenvalue n (n + 1)
Eigen::VectorXd zonal_harmonic(const Mesh_view& sphere, int n)
{
  const Eigen::VectorXd z = sphere.positions().row(2).transpose();
  Eigen::VectorXd before = Eigen::VectorXd::Ones(z.size()), now = z;
  for (int m = 1; m < n; ++m) {
    const Eigen::VectorXd after = ((2 * m + 1) * z.cwiseProduct(now) - m * before) / (m + 1);
    before = now;
    now = after;
  }
  return now;
}

double gain(const Mesh_view& mesh, const Eigen::VectorXd& v, const Eigen::VectorXd& filtered)
{
  const Eigen::VectorXd areas = CGP::vertex_areas(mesh);
  return areas.cwiseProduct(v).dot(filtered) / areas.cwiseProduct(v).dot(v);
}

/// v - (id + sigma Delta^k)^-1 v, by all eigenfunctions; sigma in the units of the mesh
Eigen::VectorXd expected(const Mesh_view& mesh, double sigma, int k, const Eigen::VectorXd& v)
{
  const Eigen::MatrixXd M = CGP::vertex_areas(mesh).asDiagonal();
  const Eigenpairs laplacian = symmetric_eigenpairs(dense(CGP::cotan_laplacian(mesh)), M);
  const Eigen::VectorXd coefficients = laplacian.vectors.transpose() * M * v;
  const Eigen::ArrayXd power = sigma * laplacian.values.array().max(0).pow(k);
  return laplacian.vectors * (power / (1 + power) * coefficients.array()).matrix();
}

template <class Call>
std::string message(Call call)
{
  try {
    call();
  } catch (const CGP::Error& e) {
    return e.what();
  }
  return "";
}

TEST(Curvature_filter, multiplies_spherical_harmonics_by_sigma_l_to_the_k_over_one_more)
{
  const Mesh_view mesh = scaled_to_area(icosphere(4), 4 * pi);
  const Mesh_view sphere = projected_to_sphere(mesh);
  for (int k = 0; k <= 3; ++k) {
    const double sigma = std::pow(30., -k);
    const Curvature_filter filter(mesh, sigma, k);
    for (int degree : {2, 10}) {
      const Eigen::VectorXd v = zonal_harmonic(sphere, degree);
      const double power = sigma * std::pow(degree * (degree + 1.), k);
      EXPECT_NEAR(gain(mesh, v, filter(v)), power / (1 + power), .02 * power / (1 + power));
    }
  }
}

TEST(Curvature_filter, is_what_its_matrix_says)
{
  for (const Mesh_view& mesh : {bumpy_sphere(1), torus(2, 1, 12, 6)}) {
    const Eigen::VectorXd v = random_numbers(mesh.size_of_vertices(), 1);
    const double unit = std::sqrt(area(mesh) / (4 * pi));
    for (int k = 0; k <= 5; ++k)
      for (double sigma : {1e-4, 1., 1e4}) {
        const Eigen::VectorXd w = Curvature_filter(mesh, sigma, k)(v);
        EXPECT_LT((w - expected(mesh, sigma * std::pow(unit, 2 * k), k, v)).norm(), 1e-9);
      }
  }
}

TEST(Curvature_filter, takes_constants_away)
{
  const Mesh_view mesh = bumpy_sphere(3);
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(mesh.size_of_vertices());
  for (int k : {1, 2, 3})
    EXPECT_LT(Curvature_filter(mesh, .01, k)(ones).cwiseAbs().maxCoeff(), 2e-10);
}

TEST(Curvature_filter, does_not_depend_on_the_units_of_length)
{
  const Mesh_view mesh = bumpy_sphere(2), large = scaled(mesh, 1024);
  const Eigen::VectorXd v = random_numbers(mesh.size_of_vertices(), 1);
  for (int k : {1, 2, 3})
    EXPECT_LT((Curvature_filter(mesh, .01, k)(v) - Curvature_filter(large, .01, k)(v)).norm(),
              1e-12);
}

TEST(Curvature_filter, is_symmetric_and_shrinks_also_on_a_mesh_with_tiny_faces)
{
  // Around vertex 0 everything is 1e5 times smaller: its entries of Delta^3 are 1e30 times larger.
  Mesh_view mesh = bumpy_sphere(3);
  Points p = mesh.positions();
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    if (mesh.ends(k)[0] == 0)
      p.col(mesh.ends(k)[1]) = p.col(0) + 1e-5 * (p.col(mesh.ends(k)[1]) - p.col(0));
  mesh.set_positions(p);
  const Eigen::VectorXd areas = CGP::vertex_areas(mesh);
  const Eigen::VectorXd v = random_numbers(mesh.size_of_vertices(), 1);
  const Eigen::VectorXd w = random_numbers(mesh.size_of_vertices(), 2);
  for (int k : {1, 2, 3}) {
    const Curvature_filter filter(mesh, .01, k);
    const Eigen::VectorXd Fv = filter(v), Fw = filter(w);
    EXPECT_NEAR(areas.cwiseProduct(v).dot(Fw), areas.cwiseProduct(w).dot(Fv), 1e-9);
    EXPECT_GT(gain(mesh, v, Fv), 0);
    EXPECT_LT(gain(mesh, v, Fv), 1);
  }
}

TEST(Curvature_filter, gives_the_same_with_another_solver_and_with_the_analysis_of_one)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const Eigen::VectorXd v = random_numbers(mesh.size_of_vertices(), 1);
  const Eigen::VectorXd filtered = Curvature_filter(mesh, .01, 2)(v);
  const Curvature_filter other(mesh, .01, 2, CGP::Eigen_hermitian_solver_traits());
  EXPECT_LT((other(v) - filtered).norm(), 1e-12);
  const auto pattern = CGP::vertex_graph(mesh);
  const CGP::Poisson_reconstruction poisson(mesh, pattern);
  const Curvature_filter sharing(mesh, .01, 2, pattern, poisson.solver().solver());
  EXPECT_LT((sharing(v) - filtered).norm(), 1e-12);
}

TEST(Curvature_filter, follows_the_mesh)
{
  Mesh_view mesh = icosphere(2);
  const Eigen::VectorXd v = random_numbers(mesh.size_of_vertices(), 1);
  Curvature_filter filter(mesh, .01, 3);
  const Eigen::VectorXd before = filter(v);
  mesh.set_positions(bumpy_sphere(2).positions());
  filter.update_geometry();
  EXPECT_LT((filter(v) - Curvature_filter(bumpy_sphere(2), .01, 3)(v)).norm(), 1e-13);
  EXPECT_GT((filter(v) - before).norm(), 1e-2);
}

TEST(Curvature_filter, refuses_weights_and_orders_out_of_range)
{
  const Mesh_view mesh = icosphere(0);
  for (double weight :
       {0., -1., std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(Curvature_filter(mesh, weight, 1), CGP::Precondition_error);
  EXPECT_EQ(message([&] { Curvature_filter(mesh, 1, -1); }),
            "Curvature_filter: an order of -1; 0, 1, 2, ... are possible");
}

TEST(Curvature_filter, says_so_when_the_matrix_cannot_be_factored)
{
  Mesh_view mesh = icosphere(0);
  Points p = mesh.positions();
  p(0, 0) = std::numeric_limits<double>::quiet_NaN();
  mesh.set_positions(p);
  EXPECT_EQ(
      message([&] { Curvature_filter(mesh, 1, 2); }),
      "Curvature_filter: factorization of the smoothing matrix failed: a value is not finite");
}

/// <v, w> / <v, v> over the surface
double share(const Mesh_view& mesh, const Eigen::VectorXd& v, const Eigen::VectorXd& w)
{
  const Eigen::VectorXd areas = CGP::vertex_areas(mesh);
  return areas.cwiseProduct(v).dot(w) / areas.cwiseProduct(v).dot(v);
}

TEST(Filtered_on_surface, leaves_of_each_frequency_what_the_band_says)
{
  // z is an eigenfunction of the unit sphere with eigenvalue 2, x y one with 6.
  const Mesh_view mesh = icosphere(4);
  const Points& p = mesh.positions();
  const Eigen::VectorXd z = p.row(2).transpose();
  const Eigen::VectorXd xy = p.row(0).cwiseProduct(p.row(1)).transpose();
  CGP::Filter_options options;
  options.amount = 3;
  for (const int order : {1, 2}) {
    options.order = order;
    options.weight = std::pow(4., -order);
    const auto part = [&](const Eigen::VectorXd& v, Curvature_band band) {
      return share(mesh, v, CGP::filtered_on_surface(mesh, v, band, options));
    };
    for (const auto& [v, l] : {std::pair(z, 2.), std::pair(xy, 6.)}) {
      const double high = 1 - 1 / (1 + std::pow(l / 4, order));
      EXPECT_NEAR(part(v, Curvature_band::low), 1 - high, 0.005);
      EXPECT_NEAR(part(v, Curvature_band::high), high, 0.005);
      EXPECT_NEAR(part(v, Curvature_band::unsharp), 1 + 3 * high, 0.015);
    }
  }
}

TEST(Filtered_on_surface, does_not_depend_on_the_units_of_length_however_large)
{
  const Mesh_view mesh = cap_from_disk(disk(8), 1);
  const Eigen::VectorXd v = random_numbers(mesh.size_of_vertices(), 3);
  const Eigen::VectorXd filtered = CGP::filtered_on_surface(mesh, v, Curvature_band::low);
  for (const int power : {-600, 600}) {
    const Mesh_view other = scaled(mesh, std::ldexp(1., power));
    EXPECT_LT((CGP::filtered_on_surface(other, v, Curvature_band::low) - filtered).norm(), 1e-12);
  }
}

TEST(Filtered_on_surface, refuses_what_its_filter_refuses)
{
  const Eigen::VectorXd v = Eigen::VectorXd::Zero(12);
  CGP::Filter_options options;
  options.weight = -1;
  EXPECT_THROW((void)CGP::filtered_on_surface(icosphere(0), v, Curvature_band::low, options),
               CGP::Precondition_error);
}

}  // namespace cgp_test::curvature_filter_tests
