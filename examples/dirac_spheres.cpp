// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Transforms a mesh of a round sphere to Dirac spheres, whose curvature half-density is a multiple
// of their length density, and writes the last of them.
//
//   dirac_spheres [INPUT [OUTPUT.ply]]
//
// Their spins are the spherical spinors, known from the hydrogen atom, and their Willmore energy is
// 4 pi kappa^2 [CGP 6.5.1].
#include <Conformal_geometry_processing/dirac_sphere.h>
#include <Conformal_geometry_processing/measure/energies.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>

namespace CGP = Conformal_geometry_processing;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
{
  const char* const input = argc > 1 ? argv[1] : "sphere.off";
  const char* const output = argc > 2 ? argv[2] : "dirac_sphere.ply";
  Mesh sphere;
  if (!CGAL::IO::read_polygon_mesh(input, sphere)) {
    std::cerr << "dirac_spheres: cannot read a mesh from " << input << '\n';
    return EXIT_FAILURE;
  }
  Mesh mesh;
  try {
    std::cout << "kappa  eigenvalue  Willmore energy / 4 pi\n";
    for (int kappa : {-1, -2, 2, -4, 4, 3, -3}) {
      //! [sphere]
      mesh = sphere;
      const CGP::Spin_report report = CGP::dirac_sphere(mesh, kappa, 0);
      //! [sphere]
      if (!report) return EXIT_FAILURE;
      const CGP::Graph_view<Mesh> graph(mesh, CGP::parameters::default_values(), "dirac_spheres");
      std::cout << kappa << "  " << report.eigenvalue << "  "
                << CGP::willmore_energy(graph.view()) / (16 * std::atan(1.)) << '\n';
    }
  } catch (const CGP::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  std::ofstream file(output, std::ios::binary);
  CGAL::IO::set_binary_mode(file);
  return CGAL::IO::write_PLY(file, mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
