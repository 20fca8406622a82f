// Tests include/Conformal_geometry_processing/flow/filtered_on_surface.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/filtered_on_surface.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <gtest/gtest.h>

#include "support/bounded_meshes.h"
#include "support/meshes.h"

namespace cgp_test::filtered_on_surface_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_band;

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
  CGP::internal::Filter_options options;
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
  CGP::internal::Filter_options options;
  options.weight = -1;
  EXPECT_THROW((void)CGP::filtered_on_surface(icosphere(0), v, Curvature_band::low, options),
               CGP::Precondition_error);
}

}  // namespace cgp_test::filtered_on_surface_tests
