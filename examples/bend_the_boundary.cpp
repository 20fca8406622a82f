// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Bends the boundary of a surface up and down, and the surface follows without shearing.
//
//   bend_the_boundary [INPUT [OUTPUT.ply]]
//
// Prescribed are the binormals, which point out of the surface; its mean curvature half-density
// stays, up to a constant gamma. Any binormals can be realised [CGP 4.5.4, 6.3.1].
#include <Conformal_geometry_processing/mesh/Boundary_frames.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Conformal_geometry_processing/spin_transform.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>

namespace CGP = Conformal_geometry_processing;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Vector = CGAL::Simple_cartesian<double>::Vector_3;

int main(int argc, char* argv[])
{
  const char* const input = argc > 1 ? argv[1] : "mushroom.off";
  const char* const output = argc > 2 ? argv[2] : "bend_the_boundary.ply";
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(input, mesh)) return EXIT_FAILURE;
  try {
    //! [bend]
    auto binormals = mesh.add_property_map<Mesh::Vertex_index, Vector>("v:binormal").first;
    const CGP::Graph_view<Mesh> graph(mesh, CGP::parameters::default_values(), "bend_the_boundary");
    const auto frames = CGP::boundary_frames(graph.view());
    const double turn = 2 * 3.14159265 / static_cast<double>(frames.vertices.size());
    for (std::size_t k = 0; k < frames.vertices.size(); ++k) {
      const double tilt = 0.6 * std::cos(4 * turn * static_cast<double>(k));  // from B to N
      const Eigen::Vector3d b =
          std::cos(tilt) * frames.binormal(k) + std::sin(tilt) * frames.normal(k);
      binormals[graph.vertex(frames.vertices[k])] = {b.x(), b.y(), b.z()};
    }
    const auto rho = mesh.add_property_map<Mesh::Vertex_index, double>("v:rho", 0).first;
    const CGP::Spin_report report =
        CGP::spin_transform(mesh, rho,
                            CGP::parameters::boundary_direction(CGP::Boundary_direction{0, 0, 1})
                                .boundary_direction_map(binormals));
    std::cout << report;
    //! [bend]
    if (!report) return EXIT_FAILURE;
  } catch (const CGP::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  std::ofstream file(output, std::ios::binary);
  return CGAL::IO::write_PLY(file, mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
