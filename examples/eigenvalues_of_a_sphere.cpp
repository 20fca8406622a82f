// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Finds eigenvalues of the quaternionic Dirac operator with their multiplicities, and writes the
// mesh with the length |lambda| of the last eigenfunction at its vertices.
//
//   eigenvalues_of_a_sphere [INPUT [OUTPUT.ply [COUNT]]]
//
// Of the unit sphere they are all integers n but -1, |n + 1| times: 120 of them besides 0 reach
// from -11 to 10 [CGP 5.8.2]. Other surfaces are welcome.
#include <Conformal_geometry_processing/dirac_spectrum.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <fstream>
#include <iostream>

namespace CGP = Conformal_geometry_processing;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
{
  const char* const input = argc > 1 ? argv[1] : "sphere.off";
  const char* const output = argc > 2 ? argv[2] : "eigenfunction.ply";
  const int count = argc > 3 ? std::atoi(argv[3]) : 16;
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(input, mesh)) {
    std::cerr << "eigenvalues_of_a_sphere: cannot read a mesh from " << input << '\n';
    return EXIT_FAILURE;
  }
  try {
    //! [spectrum]
    const auto spectrum = CGP::dirac_spectrum(mesh, count);
    for (const auto& [value, multiplicity] : CGP::with_multiplicities(spectrum.eigenvalues, 0.3))
      std::cout << value << "  " << multiplicity << '\n';
    //! [spectrum]
    if (!spectrum.converged) return EXIT_FAILURE;
    auto length = mesh.add_property_map<Mesh::Vertex_index, double>("v:quality").first;
    Eigen::Index row = 0;
    for (auto v : vertices(mesh)) length[v] = norm(spectrum.vectors(row++, count - 1));
  } catch (const CGP::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  std::ofstream file(output, std::ios::binary);
  CGAL::IO::set_binary_mode(file);
  return CGAL::IO::write_PLY(file, mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
