// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Smooths a surface with handles, for example a curled torus, without shearing it.
//
//   uncurl_a_torus [INPUT [OUTPUT.ply]]
//
// The conformal Willmore flow omits changes of curvature that would open the loops around handles
// [CGP 4.5.2]. Because its energy is invariant under inversions in spheres, the flow might drift
// until all area is in a few faces: balancing towards the areas of the canonical metric, which
// every surface with handles has, prevents this [CGP 4.5.3].
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
  const char* const input = argc > 1 ? argv[1] : "knot1.off";
  const char* const output = argc > 2 ? argv[2] : "uncurl_a_torus.ply";
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(input, mesh)) {
    std::cerr << "uncurl_a_torus: cannot read a mesh from " << input << '\n';
    return EXIT_FAILURE;
  }
  try {
    //! [flow]
    const CGP::Flow_report report = CGP::conformal_willmore_flow(
        mesh,
        CGP::parameters::number_of_iterations(20).balance(CGP::Flow_options::Balance::canonical));

    for (const CGP::Flow_step_report& step : report.steps)
      std::cout << "step " << step.step << ": energy " << step.energy << ", loops open by "
                << step.period_defect << ", quasi-conformal error " << step.quasi_conformal.mean
                << '\n';
    std::cout << to_string(report.stop) << '\n';
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
