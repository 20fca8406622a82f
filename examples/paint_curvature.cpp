// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Paints rings of curvature on a closed surface and computes the surface with that curvature.
//
//   paint_curvature [INPUT [OUTPUT.ply]]
//
// The new surface has the mean curvature half-density (H + rho + gamma)|df|, where H|df| is the old
// one, and the map to it is conformal [CGP (5.3)-(5.5)]; the certificate measures its quality.
#include <Conformal_geometry_processing/core/Conformal_mesh_traits_Surface_mesh.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Conformal_geometry_processing/spin_transform.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>

namespace CGP = Conformal_geometry_processing;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

int main(int argc, char* argv[])
{
  const char* const input = argc > 1 ? argv[1] : "bear.off";
  const char* const output = argc > 2 ? argv[2] : "paint_curvature.ply";
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(input, mesh)) {
    std::cerr << "paint_curvature: cannot read a mesh from " << input << '\n';
    return EXIT_FAILURE;
  }
  try {
    //! [paint]
    CGAL::Bbox_3 box;
    for (auto v : vertices(mesh)) box += mesh.point(v).bbox();
    const double length = box.ymax() - box.ymin();

    CGP::Conformal_mesh_traits<Mesh> data(mesh);  // keeps rho in the mesh, as "v:rho"
    auto rho = data.vertex_curvature_potential_map();
    for (auto v : vertices(mesh))  // six rings, in 1/length
      put(rho, v, 4 / length * std::sin(12 * 3.14159 * (mesh.point(v).y() - box.ymin()) / length));

    const CGP::Spin_report report = CGP::spin_transform(mesh, rho);  // moves the vertices
    std::cout << report;
    //! [paint]
    if (!report) return EXIT_FAILURE;
  } catch (const CGP::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  std::ofstream file(output, std::ios::binary);
  CGAL::IO::set_binary_mode(file);
  return CGAL::IO::write_PLY(file, mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
