// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Gives a surface with boundary, say a face, texture coordinates that keep angles.
//
//   flatten_a_face [INPUT [OUTPUT.ply [FLAT.ply]]]
//
// The map to the plane of least conformal energy, by an eigenvector: nothing is pinned, so there is
// no vertex to choose [CGP 6.1]. OUTPUT is the surface with the vertex properties texture_u and
// texture_v, FLAT its image in the plane.
#include <Conformal_geometry_processing/conformal_parameterization.h>

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
  const char* const input = argc > 1 ? argv[1] : "nefertiti.off";
  const char* const output = argc > 2 ? argv[2] : "flatten_a_face.ply";
  const char* const flat = argc > 3 ? argv[3] : nullptr;
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(input, mesh)) {
    std::cerr << "flatten_a_face: cannot read a mesh from " << input << '\n';
    return EXIT_FAILURE;
  }
  try {
    //! [flatten]
    auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
    const CGP::Parameterization_report report = CGP::conformal_parameterization(mesh, uv);
    std::cout << report;
    //! [flatten]
    if (!report) return EXIT_FAILURE;
    auto u = mesh.add_property_map<Mesh::Vertex_index, float>("v:texture_u").first;
    auto v = mesh.add_property_map<Mesh::Vertex_index, float>("v:texture_v").first;
    for (auto p : vertices(mesh)) u[p] = float(uv[p].x()), v[p] = float(uv[p].y());
    std::ofstream file(output, std::ios::binary);
    CGAL::IO::set_binary_mode(file);
    if (!CGAL::IO::write_PLY(file, mesh)) return EXIT_FAILURE;
    for (auto p : vertices(mesh)) mesh.point(p) = {uv[p].x(), uv[p].y(), 0};
  } catch (const CGP::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  if (flat == nullptr) return EXIT_SUCCESS;
  std::ofstream file(flat, std::ios::binary);
  CGAL::IO::set_binary_mode(file);
  return CGAL::IO::write_PLY(file, mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
