// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Finds the shape of a vesicle: of all surfaces with its area and its volume the one that bends the
// least.
//
//   red_blood_cell [VOLUME [OUTPUT.ply]]
//
// VOLUME is by that of the round sphere of the same area, 0.6 by default. The flow begins with a
// flat spheroid and ends, below about 0.75, at a disc that is hollow on both sides.
#include <Conformal_geometry_processing/conformal_willmore_flow.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/PLY.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>

namespace CGP = Conformal_geometry_processing;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

int main(int argc, char* argv[])
{
  const double volume = argc > 1 ? std::atof(argv[1]) : .6;
  const char* const output = argc > 2 ? argv[2] : "red_blood_cell.ply";
  Mesh mesh;
  CGAL::make_icosahedron<Mesh, Point>(mesh, Point(0, 0, 0), 1);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(4));
  for (const Mesh::Vertex_index v : mesh.vertices()) {
    Point& p = mesh.point(v);
    const double r = std::sqrt(CGAL::squared_distance(p, Point(0, 0, 0)));
    p = Point(p.x() / r, p.y() / r, .35 * p.z() / r);
  }
  try {
    //! [flow]
    const CGP::Flow_report report =
        CGP::conformal_willmore_flow(mesh, CGP::parameters::reduced_volume(volume));

    std::cout << "volume " << report.enclosure.reduced_volume << " of that of a sphere, energy "
              << report.energy_of_faces / (4 * std::acos(-1.)) << " times that of a sphere\n";
    //! [flow]
    if (!report) std::cout << report;
  } catch (const CGP::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  std::ofstream file(output, std::ios::binary);
  CGAL::IO::set_binary_mode(file);
  return CGAL::IO::write_PLY(file, mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
