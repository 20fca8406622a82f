// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/moebius_transform.h>

#include <gtest/gtest.h>

#include <type_traits>
#include <vector>

#include "support/cgal_meshes.h"
#include "support/meshes.h"
#include "support/views.h"

/// What moebius_transform() and invert_in_sphere() do to a mesh of any type.
namespace cgp_test {

namespace CGP = Conformal_geometry_processing;

inline Mesh_view sphere_to_invert()
{
  return bumpy_sphere(1);
}

template <class Mesh>
Points points_of(const Mesh& mesh)
{
  return CGP::Graph_view<Mesh>(mesh, CGP::parameters::default_values(), "test").view().positions();
}

/// Each edge vector e is mapped to conjugate(lambda_i) e lambda_j, up to `tolerance`, and the
/// inversion in a sphere satisfies its formula
template <class Mesh>
void expect_moebius_transforms(const Mesh& original, double tolerance)
{
  const Mesh_view before = sphere_to_invert();
  {
    Mesh mesh = original;
    auto spins = get(CGAL::dynamic_vertex_property_t<Quaternion<double>>(), mesh);
    const auto map = CGP::Moebius_map::rotation({1, 2, 0, 1}) *
                     CGP::Moebius_map::sphere_inversion({.2, .1, -.3});
    const CGP::internal::Moebius_report report =
        CGP::moebius_transform(mesh, map, CGP::parameters::vertex_spin_map(spins));
    const Points after = points_of(mesh);
    std::vector<Quaternion<double>> lambda;
    for (const auto v : vertices(mesh)) {
      lambda.push_back(get(spins, v));
      EXPECT_LE(report.min_length_scale, CGP::squared_norm(lambda.back()) + 1e-14);
      EXPECT_GE(report.max_length_scale, CGP::squared_norm(lambda.back()) - 1e-14);
    }
    for (int k = 0; k < before.size_of_edges(); ++k) {
      const auto [i, j] = before.ends(k);
      const Eigen::Vector3d e = before.position(j) - before.position(i);
      const auto image = conjugate(lambda[at(i)]) * CGP::imaginary(e) * lambda[at(j)];
      EXPECT_LT((after.col(j) - after.col(i) - imaginary_part(image)).norm(), tolerance);
    }
  }
  Mesh mesh = original;
  const Eigen::Vector3d c(.5, -2, 1);
  const auto points = get(CGAL::vertex_point, mesh);
  using Point = typename boost::property_traits<std::decay_t<decltype(points)>>::value_type;
  (void)CGP::invert_in_sphere(mesh, Point(c.x(), c.y(), c.z()), 1.5);
  const Mesh_view expected = mapped(before, [&](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(c - 2.25 * (p - c) / (p - c).squaredNorm());
  });
  EXPECT_LT(greatest_distance(points_of(mesh), expected.positions()), tolerance);
}

}  // namespace cgp_test
