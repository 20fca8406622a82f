// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Goes from one shape to another, and beyond, through conformally equivalent ones.
//
//   blend_two_shapes [INPUT [OUTPUT.ply [T]]]
//
// Conformally equivalent surfaces differ by their mean curvature half-densities H |df|, and these
// can be added [CGP 4.4]: T = 0 gives the first shape, 1 the second, 1.5 exaggerates it.
#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Conformal_geometry_processing/spin/curvature_difference.h>
#include <Conformal_geometry_processing/spin_transform.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <optional>

namespace CGP = Conformal_geometry_processing;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

/// the mesh with its mean curvature changed by a function of the points
Mesh shape(Mesh mesh, const std::function<double(const Point&)>& change)
{
  auto rho = mesh.add_property_map<Mesh::Vertex_index, double>("v:rho").first;
  for (auto v : vertices(mesh)) rho[v] = change(mesh.point(v));
  if (!CGP::spin_transform(mesh, rho, CGP::parameters::scale_bound(std::nullopt)))
    throw CGP::Solver_error("blend_two_shapes", "no shape");
  return mesh;
}

int main(int argc, char* argv[])
{
  const char* const input = argc > 1 ? argv[1] : "sphere.off";
  const char* const output = argc > 2 ? argv[2] : "blend_two_shapes.ply";
  const double t = argc > 3 ? std::atof(argv[3]) : 0.5;
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(input, mesh)) return EXIT_FAILURE;
  try {
    const Mesh lobes = shape(mesh, [](const Point& p) {
      const double x = p.x() * p.x(), z = p.z() * p.z();
      return 2.5 * (x * x - 6 * x * z + z * z);
    });
    mesh = shape(mesh, [](const Point& p) { return 1.6 * std::sin(6 * p.y()); });  // a vase
    //! [blend]
    const auto view = [](const Mesh& m) {
      return CGP::Graph_view<Mesh>(m, CGP::parameters::default_values(), "blend_two_shapes");
    };
    const CGP::Curvature_potential difference =
        CGP::curvature_difference(view(mesh).view(), view(lobes).view().positions());
    auto rho = mesh.property_map<Mesh::Vertex_index, double>("v:rho").first;
    for (auto v : vertices(mesh)) rho[v] = t * difference.values[Eigen::Index(v.idx())];
    // no bound on lengths: they are those of the other shape
    const CGP::Spin_report report =
        CGP::spin_transform(mesh, rho, CGP::parameters::scale_bound(std::nullopt));
    std::cout << report;
    //! [blend]
    if (!report) return EXIT_FAILURE;
  } catch (const CGP::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  std::ofstream file(output, std::ios::binary);
  CGAL::IO::set_binary_mode(file);
  return CGAL::IO::write_PLY(file, mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
