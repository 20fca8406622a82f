// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_component.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <cmath>
#include <string>
#include <vector>

#include "Off_file.h"
#include "support/spheres.h"

/// The meshes and the potential that all models of solvers are compared on.
namespace cgp_benchmark {

/// 20 frequency^2 faces; smooth bumps of a tenth of the radius, without symmetry
inline CGP::Mesh_view bumpy_geodesic_sphere(int frequency)
{
  return cgp_test::mapped(cgp_test::geodesic_sphere(frequency), [](const Eigen::Vector3d& p) {
    const double bump = std::sin(5 * p.x() + 1) * std::sin(4 * p.y() + 2) +
                        0.7 * std::sin(6 * p.z() + 3 * p.x()) +
                        0.5 * std::sin(9 * p.y() - 4 * p.z());
    return Eigen::Vector3d((1 + 0.1 * bump) * p);
  });
}

/// with area 4 pi and the centroid of the surface at the origin
inline CGP::Mesh_view in_unit_frame(const CGP::Mesh_view& mesh)
{
  const Eigen::VectorXd areas = CGP::vertex_areas(mesh);
  const Eigen::Vector3d centre = mesh.positions() * areas / areas.sum();
  const auto centred =
      cgp_test::mapped(mesh, [&](const Eigen::Vector3d& p) { return Eigen::Vector3d(p - centre); });
  return cgp_test::scaled_to_area(centred, 4 * cgp_test::pi);
}

/// \brief the mesh of a name, in the unit frame.
///
/// `81` is the bumpy sphere of that frequency, `bear.off` a file, `bear.off:2` that file with every
/// face split in four, twice; files in the order in which the program hands meshes to the library.
inline CGP::Mesh_view make_mesh(const std::string& name)
{
  if (name.find_first_not_of("0123456789") == std::string::npos)
    return in_unit_frame(bumpy_geodesic_sphere(std::stoi(name)));
  const std::size_t colon = name.rfind(".off:");
  CGP::Mesh_view mesh = read_off(colon == std::string::npos ? name : name.substr(0, colon + 4));
  const int splits = colon == std::string::npos ? 0 : std::stoi(name.substr(colon + 5));
  for (int i = 0; i < splits; ++i) mesh = cgp_test::subdivided(mesh);
  const std::vector<char> all(mesh.corners().size(), 1);
  return in_unit_frame(in_morton_order(CGP::internal::selected_faces(mesh, all)).mesh);
}

/// \brief rho on faces, with mean zero: amplitude (sin(3x + 1/2) cos 2y + 0.6 sin(4z + x)) less its
/// mean, at the centroids of the faces.
///
/// In the unit frame the unit of rho is 1/R, with R the radius of the sphere of the same area:
/// amplitude 1 is an edit that one sees, 3 a strong one.
inline CGP::Curvature_potential smooth_potential(const CGP::Mesh_view& mesh, double amplitude)
{
  CGP::Curvature_potential rho{CGP::Curvature_potential::On::faces,
                               Eigen::VectorXd(mesh.size_of_faces())};
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto& v = mesh.corners(f);
    const Eigen::Vector3d c = (mesh.position(v[0]) + mesh.position(v[1]) + mesh.position(v[2])) / 3;
    rho.values[f] = amplitude * (std::sin(3 * c.x() + 0.5) * std::cos(2 * c.y()) +
                                 0.6 * std::sin(4 * c.z() + c.x()));
  }
  rho.values.array() -= CGP::mean(mesh, rho);
  return rho;
}

}  // namespace cgp_benchmark
