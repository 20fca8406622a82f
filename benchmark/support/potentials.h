// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <array>
#include <cmath>
#include <functional>
#include <utility>

/// The changes of curvature of the surveys, on surfaces of one size.
namespace cgp_benchmark {

namespace CGP = Conformal_geometry_processing;

/// of area 4 pi, around the origin
inline CGP::Mesh_view normalized(CGP::Mesh_view mesh)
{
  const Eigen::VectorXd areas = CGP::vertex_areas(mesh);
  const Eigen::Vector3d center = mesh.positions() * areas / areas.sum();
  mesh.set_positions((mesh.positions().colwise() - center) *
                     std::sqrt(4 * std::acos(-1.) / areas.sum()));
  return mesh;
}

struct Potential {
  const char* name;
  std::function<double(const Eigen::Vector3d&, double height)> value;  // height in [0, 1]
};

inline const std::array<Potential, 3> potentials = {{
    {"bands", [](const Eigen::Vector3d& p, double) { return std::sin(5 * p.y()); }},
    {"rings", [](const Eigen::Vector3d&, double h) { return std::sin(12 * std::acos(-1.) * h); }},
    {"waves", [](const Eigen::Vector3d& p,
                 double) { return std::sin(3 * p.x() + 1) * std::cos(4 * p.z()) + p.y() / 2; }},
}};

inline CGP::Curvature_potential sampled(const CGP::Mesh_view& mesh, const Potential& potential,
                                        double amplitude)
{
  const auto y = mesh.positions().row(1);
  const double low = y.minCoeff(), height = y.maxCoeff() - low;
  Eigen::VectorXd rho(mesh.size_of_vertices());
  for (int v = 0; v < mesh.size_of_vertices(); ++v)
    rho[v] = amplitude * potential.value(mesh.position(v), (y[v] - low) / height);
  return CGP::Curvature_potential::on_vertices(std::move(rho));
}

}  // namespace cgp_benchmark
