// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Smooths a closed surface to the round sphere that it is conformally equivalent to.
//
//   willmore_to_a_sphere [INPUT [OUTPUT.ply]]
//
// Ten large steps of the conformal Willmore flow [CGP 6.4] do what thousands of small ones of mean
// curvature flow would, and keep the angles of the triangles.
#include <Conformal_geometry_processing/conformal_willmore_flow.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <fstream>
#include <iostream>

namespace CGP = Conformal_geometry_processing;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

int main(int argc, char* argv[])
{
  const char* const input = argc > 1 ? argv[1] : "bear.off";
  const char* const output = argc > 2 ? argv[2] : "willmore_to_a_sphere.ply";
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(input, mesh)) {
    std::cerr << "willmore_to_a_sphere: cannot read a mesh from " << input << '\n';
    return EXIT_FAILURE;
  }
  try {
    //! [flow]
    const CGP::Flow_report report =
        CGP::conformal_willmore_flow(mesh, CGP::parameters::number_of_iterations(10));

    const double energy_of_sphere = 4 * 3.14159265;
    std::cout << "energy " << report.initial_energy / energy_of_sphere << " times that of a sphere";
    for (const CGP::Flow_step_report& step : report.steps)
      std::cout << "\nstep " << step.step << ": " << step.energy / energy_of_sphere
                << ", quasi-conformal error " << step.quasi_conformal.mean;
    std::cout << '\n' << to_string(report.stop) << '\n';
    //! [flow]
    if (report.steps.empty() && !report) return EXIT_FAILURE;
  } catch (const CGP::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  std::ofstream file(output, std::ios::binary);
  CGAL::IO::set_binary_mode(file);
  return CGAL::IO::write_PLY(file, mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
