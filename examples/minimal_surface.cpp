// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Spans a minimal surface that has prescribed tangents: Enneper's with three petals, on any mesh of
// a disk in the plane z = 0.
//
//   minimal_surface [INPUT [OUTPUT.ply]]
//
// One linear solve, for spin transformations of plane domains are Weierstrass' representation: the
// spin lambda is the square root of his holomorphic function [CGP 6.5.3].
#include <Conformal_geometry_processing/minimal_surface.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <complex>
#include <cstdlib>
#include <fstream>
#include <iostream>

namespace CGP = Conformal_geometry_processing;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Complex = std::complex<double>;

int main(int argc, char* argv[])
{
  const char* const input = argc > 1 ? argv[1] : "disk.off";
  const char* const output = argc > 2 ? argv[2] : "minimal_surface.ply";
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(input, mesh)) {
    std::cerr << "minimal_surface: cannot read a mesh from " << input << '\n';
    return EXIT_FAILURE;
  }
  try {
    //! [span]
    auto tangents = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:tangent").first;
    for (auto h : halfedges(mesh)) {
      if (!is_border(h, mesh)) continue;  // borders run clockwise, tangents the other way
      const auto p = mesh.point(target(h, mesh));
      const auto t = mesh.point(source(h, mesh)) - mesh.point(target(next(h, mesh), mesh));
      const Complex i(0, 1), dz(t.x(), t.y()), z = Complex(p.x(), p.y()), g = 1.5 * z * z;
      tangents[target(h, mesh)] = {std::real((1. - g * g) * dz), std::real(-i * (1. + g * g) * dz),
                                   std::real(2. * g * dz)};
    }
    const CGP::Spin_report report =
        CGP::minimal_surface(mesh, CGP::parameters::boundary_direction_map(tangents));
    std::cout << report;
    //! [span]
    if (!report) return EXIT_FAILURE;
  } catch (const CGP::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  std::ofstream file(output, std::ios::binary);
  CGAL::IO::set_binary_mode(file);
  return CGAL::IO::write_PLY(file, mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
