// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "spin/branch_tools.h"
#include "support/meshes.h"

/// Closed meshes on which the errors of discretisation are large, with potentials of size one.
namespace cgp_test {

struct Coarse_case {
  std::string name;
  Mesh_view mesh;
  Curvature_potential rho;
};

inline Mesh_view bumpy_ellipsoid(int level)
{
  return scaled_to_area(mapped(bumpy_sphere(level, .2),
                               [](const Eigen::Vector3d& p) {
                                 return Eigen::Vector3d(1.4 * p.x(), p.y(), .7 * p.z());
                               }),
                        4 * pi);
}

/// a wave along a direction, with extrema that are not placed symmetrically
inline Curvature_potential wave_potential(const Mesh_view& mesh)
{
  Eigen::VectorXd rho(mesh.size_of_vertices());
  for (int v = 0; v < mesh.size_of_vertices(); ++v)
    rho[v] = std::sin(mesh.position(v).dot(Eigen::Vector3d(1.7, -1.1, .6)) + .5);
  return Curvature_potential::on_vertices(std::move(rho));
}

/// three potentials for a mesh, on vertices and on faces
inline std::vector<Coarse_case> cases_on(const std::string& name, const Mesh_view& mesh)
{
  return {{name + ", harmonics", mesh, smooth_potential(mesh, 1)},
          {name + ", wave", mesh, wave_potential(mesh)},
          {name + ", faces", mesh, Curvature_potential::on_faces(rho_of_section_3_on_faces(mesh))}};
}

inline void append(std::vector<Coarse_case>& cases, const std::vector<Coarse_case>& more)
{
  cases.insert(cases.end(), more.begin(), more.end());
}

/// 42 to 60 vertices: small enough for dense matrices
inline std::vector<Coarse_case> smallest_coarse_cases()
{
  std::vector<Coarse_case> cases =
      cases_on("perturbed icosphere 1", radially_perturbed(icosphere(1), .15));
  append(cases, cases_on("bumpy ellipsoid 1", bumpy_ellipsoid(1)));
  append(cases, cases_on("scan of 60", scaled_to_area(scan(60), 4 * pi)));
  return cases;
}

inline std::vector<Coarse_case> coarse_cases()
{
  std::vector<Coarse_case> cases = smallest_coarse_cases();
  append(cases, cases_on("perturbed icosphere 2", radially_perturbed(icosphere(2), .1)));
  append(cases, cases_on("scan of 200", scaled_to_area(scan(200), 4 * pi)));
  return cases;
}

}  // namespace cgp_test
