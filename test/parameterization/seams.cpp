// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests parameterization/cones.h
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/parameterization/cones.h>
#include <Conformal_geometry_processing/parameterization/spectral_parameterization.h>

#include <gtest/gtest.h>

#include "flat_maps.h"
#include "support/decompositions.h"
#include "support/dense.h"
#include "support/mesh_tools.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>
#include <vector>

namespace cgp_test::seams_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::internal::Seam;

/// A flat sector of a disk, whose two straight sides are one line of a cone
struct Sector {
  Mesh_view mesh;
  std::vector<int> origin;
};

Sector sector(double angle, int rings, int parts)
{
  const auto vertex = [&](int ring, int part) {
    return ring == 0 ? 0 : 1 + (ring - 1) * (parts + 1) + part;
  };
  Points points = Points::Zero(3, vertex(rings, parts) + 1);
  Sector made{{}, std::vector<int>(static_cast<std::size_t>(points.cols()), 0)};
  Mesh_view::Corners corners;
  for (int i = 1; i <= rings; ++i)
    for (int k = 0; k <= parts; ++k) {
      const double a = angle * k / parts,
                   r = double(i) / rings * (1 + .1 * std::sin(7. * k + i) * (k % parts != 0));
      points.col(vertex(i, k)) = Eigen::Vector3d(r * std::cos(a), r * std::sin(a), 0);
      made.origin[static_cast<std::size_t>(vertex(i, k))] = vertex(i, k % parts);
      if (k == parts) continue;
      corners.push_back({vertex(i - 1, k), vertex(i, k), vertex(i, k + 1)});
      if (i > 1) corners.push_back({vertex(i - 1, k), vertex(i, k + 1), vertex(i - 1, k + 1)});
    }
  made.mesh = Mesh_view(points, corners);
  return made;
}

double largest_miss(const std::vector<Seam>& seams, const Eigen::VectorXcd& z)
{
  double largest = 0;
  for (const Seam& seam : seams) {
    const auto left = z[seam.left[1]] - z[seam.left[0]],
               right = z[seam.right[1]] - z[seam.right[0]];
    largest = (std::max)(largest, std::abs(right - seam.ratio * left));
  }
  return largest;
}

TEST(Seams, of_a_boundary_are_those_of_a_flat_surface)
{
  for (const Mesh_view& mesh : {jittered_disk(5, .3), annulus(1, 3, 17, 4), grid(7, 3, 2, 5)}) {
    std::vector<int> origin(static_cast<std::size_t>(mesh.size_of_vertices()));
    std::iota(origin.begin(), origin.end(), 0);
    const auto seams =
        CGP::internal::seams_of(mesh, origin, Eigen::VectorXd::Zero(mesh.size_of_vertices()));
    std::size_t edges = 0;
    for (int h = 0; h < mesh.size_of_halfedges(); ++h) edges += mesh.twin(h) < 0;
    EXPECT_EQ(seams.size(), edges);
    EXPECT_LT(largest_miss(seams, plane_points(mesh)), 1e-12);
  }
}

TEST(Seams, of_a_flat_cone_are_turned_by_its_angle)
{
  for (const double angle : {1., 3., 5.5}) {
    const Sector cone = sector(angle, 5, 14);
    const Eigen::VectorXd u = Eigen::VectorXd::Zero(cone.mesh.size_of_vertices());
    const Eigen::VectorXcd z = plane_points(cone.mesh);
    const std::vector<Seam> seams = CGP::internal::seams_of(cone.mesh, cone.origin, u);
    ASSERT_EQ(seams.size(), 5u + 14u);  // of the cut, and of the boundary
    for (std::size_t k = 0; k < 5; ++k) {
      EXPECT_NEAR(std::abs(seams[k].ratio), 1, 1e-14);
      EXPECT_NEAR(std::cos(std::arg(seams[k].ratio)), std::cos(angle), 1e-12);
    }
    EXPECT_LT(largest_miss(seams, z), 1e-12);
  }
}

// Where u takes the curvature off, L u = -K, a seam goes on without a turn.
TEST(Seams, are_turned_alike_where_the_metric_is_flat)
{
  const int rings = 6, parts = 20;
  const Sector cone = sector(4, rings, parts);
  const Mesh_view bent = mapped(cone.mesh, [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p.x(), p.y(), .4 * p.norm() * p.norm());
  });
  const int n = bent.size_of_vertices(), last = n - (parts + 1);
  const Eigen::MatrixXd of_disk = dense(CGP::cotan_laplacian(bent));
  Eigen::MatrixXd L = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) L(cone.origin[at(i)], cone.origin[at(j)]) += of_disk(i, j);
  Eigen::VectorXd K = Eigen::VectorXd::Constant(n, 2 * std::acos(-1.));
  for (int f = 0; f < bent.size_of_faces(); ++f)
    for (int c = 0; c < 3; ++c)
      K[cone.origin[at(bent.corners(f)[at(c)])]] -= CGP::corner_angle(bent.sheet(f), c);
  std::vector<int> inside;
  for (int v = 1; v < last; ++v)
    if (cone.origin[at(v)] == v) inside.push_back(v);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(n);
  u(inside) = definite_solution(L(inside, inside), -K(inside));
  for (int v = 0; v < n; ++v) u[v] = u[cone.origin[at(v)]];
  const std::vector<Seam> seams = CGP::internal::seams_of(bent, cone.origin, u);
  ASSERT_GE(seams.size(), 6u);
  EXPECT_GT(K(inside).lpNorm<Eigen::Infinity>(), .01);
  for (std::size_t k = 0; k < 6; ++k)
    EXPECT_LT(std::abs(seams[k].ratio - seams.front().ratio), 1e-12);
}

// The energy of springs is zero for maps that obey them, and counts the squares of what others
// miss.
TEST(Seams, add_the_squares_of_what_they_miss)
{
  const Sector cone = sector(2, 4, 9);
  const Eigen::VectorXd u = Eigen::VectorXd::Random(cone.mesh.size_of_vertices());
  const std::vector<Seam> seams = CGP::internal::seams_of(cone.mesh, cone.origin, u);
  auto energy = CGP::conformal_energy(cone.mesh, CGP::internal::graph_with_seams(cone.mesh, seams));
  const Eigen::VectorXcd z = Eigen::VectorXcd::Random(u.size());
  const double before = std::real(z.dot(energy * z));
  EXPECT_NEAR(before, std::real(z.dot(CGP::conformal_energy(cone.mesh) * z)), 1e-12 * before);
  CGP::internal::add_seams(seams, 3, energy);
  double missed = 0;
  for (const Seam& seam : seams)
    missed += std::norm(z[seam.right[1]] - z[seam.right[0]] -
                        seam.ratio * (z[seam.left[1]] - z[seam.left[0]]));
  EXPECT_NEAR(std::real(z.dot(energy * z)), before + 3 * missed, 1e-11 * before);
}

TEST(Seams, are_kept_by_the_spectral_parameterization)
{
  const Sector cone = sector(4, 8, 30);
  const Mesh_view bent = mapped(cone.mesh, [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p.x(), p.y(), .4 * p.norm() * p.norm());
  });
  CGP::Parameterization_options options;
  options.seams = CGP::internal::seams_of(cone.mesh, cone.origin,
                                          Eigen::VectorXd::Zero(bent.size_of_vertices()));
  const auto [z, report] = CGP::spectral_parameterization(bent, options);
  ASSERT_TRUE(report);
  EXPECT_EQ(report.conformality.flipped_faces, 0);
  for (const Seam& seam : options.seams) {
    const std::complex<double> left = z[seam.left[1]] - z[seam.left[0]];
    EXPECT_LT(std::abs(z[seam.right[1]] - z[seam.right[0]] - seam.ratio * left),
              1e-3 * std::abs(left));
  }
}

}  // namespace cgp_test::seams_tests
