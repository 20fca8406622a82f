// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/flow/Flow_options.h>

#include "support/meshes.h"

/// Common functions of the tests of flows.
namespace cgp_test {

namespace CGP = Conformal_geometry_processing;

/// steps of one size that are taken whatever the energy does, without correction, and no other
/// reason to stop
inline CGP::Flow_options plain_steps(double time_step, int steps)
{
  CGP::Flow_options options;
  options.time_step = time_step;
  options.max_steps = steps;
  options.surface.exact_conformal_class = options.backtracking = false;
  options.energy_tolerance = options.direction_tolerance = 0;
  return options;
}

/// a gear as a prism: teeth around, `layers` of faces along its axis, fans at its ends
inline Mesh_view gear(int teeth, double depth, int layers, double height)
{
  const int around = 4 * teeth, rings = layers + 1, all = around * rings;
  Points p(3, all + 2);
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < around; ++j) {
      const double angle = 2 * pi * j / around, r = j % 4 < 2 ? 1 : 1 - depth;
      p.col(i * around + j) << r * std::cos(angle), r * std::sin(angle), height * i / layers;
    }
  p.col(all) << 0, 0, 0;
  p.col(all + 1) << 0, 0, height;
  Mesh_view::Corners faces;
  for (int j = 0; j < around; ++j) {
    const int k = (j + 1) % around, top = (rings - 1) * around;
    for (int i = 0; i + 1 < rings; ++i) {
      const int a = i * around + j, b = i * around + k;
      faces.push_back({a, b, b + around});
      faces.push_back({a, b + around, a + around});
    }
    faces.push_back({all, k, j});
    faces.push_back({all + 1, top + j, top + k});
  }
  return {std::move(p), std::move(faces)};
}

/// along the x-axis
inline Mesh_view stretched(const Mesh_view& mesh, double factor)
{
  return mapped(mesh, [&](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(factor * p.x(), p.y(), p.z());
  });
}

inline Eigen::Vector3d centroid(const Mesh_view& mesh)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double total = 0;
  for (const auto& v : mesh.corners()) {
    const Eigen::Vector3d a = mesh.position(v[0]), b = mesh.position(v[1]), c = mesh.position(v[2]);
    const double twice = (b - a).cross(c - a).norm();
    sum += twice * (a + b + c) / 3;
    total += twice;
  }
  return sum / total;
}

/// of the distances from the centroid, the standard deviation by the mean
inline double radius_deviation(const Mesh_view& mesh)
{
  const Eigen::Vector3d center = centroid(mesh);
  const Eigen::ArrayXd r = (mesh.positions().colwise() - center).colwise().norm();
  return std::sqrt((r - r.mean()).square().mean()) / r.mean();
}

/// the Legendre polynomial of degree k
inline double legendre(int k, double z)
{
  double last = 0, now = 1;
  for (int i = 1; i <= k; ++i) {
    const double next = ((2 * i - 1) * z * now - (i - 1) * last) / i;
    last = now;
    now = next;
  }
  return now;
}

}  // namespace cgp_test
