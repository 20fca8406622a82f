// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>
#include <Conformal_geometry_processing/spin/Boundary_condition.h>

#include <cmath>
#include <vector>

#include "flow_tools.h"
#include "support/bounded_meshes.h"

/// Surfaces with boundary that flows start from.
namespace cgp_test {

using CGP::Boundary_condition;

/// the cap of polar angle pi/3 of the specification with bumps of 6 %; V = 1 + 3n(n+1)
inline Mesh_view bumpy_cap(int n)
{
  return mapped(cap_from_disk(disk(n), pi / 3), [](const Eigen::Vector3d& p) {
    const double bump =
        std::sin(5 * p.x()) * std::cos(4 * p.y()) + .5 * std::cos(6 * p.z() + p.x());
    return Eigen::Vector3d((1 + .06 * bump) * p);
  });
}

/// an annulus with waves of height .25 and no symmetry; 12 n x n squares
inline Mesh_view bumpy_annulus(int n)
{
  return mapped(annulus(.4, 1, 12 * n, n), [](const Eigen::Vector3d& p) {
    const double x = p.x(), y = p.y();
    const double z = .15 * std::sin(3 * x + 1) * std::cos(2 * y) + .1 * std::cos(4 * y - x);
    return Eigen::Vector3d(x, y, z);
  });
}

/// H of the reference runs: barycentric areas, and at the boundary the mean of the neighbours
/// inside
inline Eigen::VectorXd barycentric_mean_curvature(const Mesh_view& mesh)
{
  Eigen::VectorXd H = CGP::mean_curvature(mesh).cwiseProduct(
      CGP::voronoi_areas(mesh).cwiseQuotient(CGP::vertex_areas(mesh)));
  const std::vector<char> is_boundary = CGP::boundary_vertices(mesh);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(H.size()), count = sum;
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    for (int end : {0, 1}) {
      const int v = mesh.ends(k)[at(end)], u = mesh.ends(k)[at(1 - end)];
      if (!is_boundary[at(u)]) sum[v] += H[u], count[v] += 1;
    }
  for (int v = 0; v < H.size(); ++v)
    if (is_boundary[at(v)]) H[v] = sum[v] / count[v];
  return H;
}

/// the flow of the reference runs
struct Barycentric_direction {
  Eigen::VectorXd operator()(const Mesh_view& mesh) const
  {
    return -barycentric_mean_curvature(mesh);
  }
  double energy(const Mesh_view& mesh) const
  {
    return CGP::vertex_areas(mesh).dot(barycentric_mean_curvature(mesh).cwiseAbs2());
  }
};

/// steps as `plain_steps()` with a condition for the boundary
inline CGP::Flow_options plain_steps(double time_step, int steps,
                                     const Boundary_condition& condition)
{
  CGP::Flow_options options = plain_steps(time_step, steps);
  options.surface.boundary = condition;
  return options;
}

}  // namespace cgp_test
