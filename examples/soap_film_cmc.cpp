// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Blows a soap film: bends the boundary of a dome, and relaxes it to constant mean curvature.
//
//   soap_film_cmc [INPUT [OUTPUT.ply]]
//
// A film under pressure has constant mean curvature. With prescribed binormals, the directions in
// which it leaves its frame, the Willmore flow ends there, and not at a minimal surface
// [CGP 6.5.3].
#include <Conformal_geometry_processing/conformal_willmore_flow.h>
#include <Conformal_geometry_processing/mesh/Boundary_frames.h>
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
  const char* const input = argc > 1 ? argv[1] : "dome.off";
  const char* const output = argc > 2 ? argv[2] : "soap_film_cmc.ply";
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(input, mesh)) return EXIT_FAILURE;
  try {
    //! [film]
    auto binormals = mesh.add_property_map<Mesh::Vertex_index, Vector>("v:binormal").first;
    const CGP::Graph_view<Mesh> graph(mesh, CGP::parameters::default_values(), "soap_film_cmc");
    const auto frames = CGP::boundary_frames(graph.view());
    const double turn = 2 * 3.14159265 / static_cast<double>(frames.vertices.size());
    for (std::size_t k = 0; k < frames.vertices.size(); ++k) {
      const double tilt = 0.8 * std::cos(4 * turn * static_cast<double>(k));  // from B to N
      const Eigen::Vector3d b =
          std::cos(tilt) * frames.binormal(k) + std::sin(tilt) * frames.normal(k);
      binormals[graph.vertex(frames.vertices[k])] = {b.x(), b.y(), b.z()};
    }
    const auto rho = mesh.add_property_map<Mesh::Vertex_index, double>("v:rho", 0).first;
    const auto kept = CGP::parameters::boundary_direction(CGP::Boundary_direction{0, 0, 1});
    const CGP::Spin_report bent =
        CGP::spin_transform(mesh, rho, kept.boundary_direction_map(binormals));
    const CGP::Flow_report film = CGP::conformal_willmore_flow(mesh, kept.number_of_iterations(20));
    std::cout << "energy " << film.initial_energy << " when bent, " << film.energy << " after "
              << film.steps.size() << " steps: " << to_string(film.stop) << '\n';
    //! [film]
    if (!bent || (film.steps.empty() && !film)) return EXIT_FAILURE;
  } catch (const CGP::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  std::ofstream file(output, std::ios::binary);
  return CGAL::IO::write_PLY(file, mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
