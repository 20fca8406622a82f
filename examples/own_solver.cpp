// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Deforms a surface with a linear solver of one's own, which is in Ldl_solver.h, and compares
// the result with that of the library's solver.
//
//   own_solver [INPUT [OUTPUT.ply]]
#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Conformal_geometry_processing/spin_transform.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <optional>

#include "Ldl_solver.h"

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "sphere.off", mesh)) return EXIT_FAILURE;
  const CGAL::Bbox_3 box = CGAL::bbox_3(mesh.points().begin(), mesh.points().end());
  const double length = box.zmax() - box.zmin();
  auto rho = mesh.add_property_map<Mesh::Vertex_index, double>("v:rho").first;
  auto theirs = mesh.add_property_map<Mesh::Vertex_index, Point>("v:theirs").first;
  for (auto v : vertices(mesh)) rho[v] = 8 / length * std::cos(25 * mesh.point(v).z() / length);
  double farthest = 0;
  try {
    // The eigenvector is the same up to the tolerance; where a search within a bound ends, less so.
    const auto plain = CGP::parameters::scale_bound(std::nullopt);
    if (!CGP::spin_transform(mesh, rho, plain.output_vertex_point_map(theirs))) return EXIT_FAILURE;
    //! [call]
    const CGP::Spin_report report =
        CGP::spin_transform(mesh, rho, plain.sparse_solver(Ldl_solver_traits()));
    //! [call]
    for (auto v : vertices(mesh))
      farthest = std::max(farthest, CGAL::squared_distance(mesh.point(v), theirs[v]));
    std::cout << report << "distance from the surface by the library's solver "
              << std::sqrt(farthest) / length << " of its length\n";
    if (!report) return EXIT_FAILURE;
  } catch (const CGP::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  std::ofstream file(argc > 2 ? argv[2] : "own_solver.ply", std::ios::binary);
  CGAL::IO::set_binary_mode(file);
  return CGAL::IO::write_PLY(file, mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
