// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Paints curvature on a surface by a gray-scale image, unfiltered or filtered.
//
//   paint_and_filter [INPUT [OUTPUT.ply [low | high | unsharp]]]
//
// Filters of surfaces are filters of images: the image is blurred or sharpened, and the map to
// every result is conformal [CGP 6.2].
#include <Conformal_geometry_processing/painting/image_filters.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Conformal_geometry_processing/spin_transform.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

namespace CGP = Conformal_geometry_processing;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

/// six broad petals under narrow rings
CGP::Gray_image rosette(int size)
{
  Eigen::ArrayXXd gray(size, size);
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      const double x = 2. * column / size - 1, y = 1 - 2. * row / size, r = std::hypot(x, y);
      const double petals = 1.4 * std::cos(6 * std::atan2(y, x)) * r * std::exp(-4 * r * r);
      gray(row, column) = 0.5 + petals + 0.24 * std::cos(36 * r) * std::exp(-2.5 * r * r);
    }
  return CGP::Gray_image(gray);
}

int main(int argc, char* argv[])
{
  const char* const input = argc > 1 ? argv[1] : "disk.off";
  const char* const output = argc > 2 ? argv[2] : "paint_and_filter.ply";
  const std::string filter = argc > 3 ? argv[3] : "";
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(input, mesh)) return EXIT_FAILURE;
  try {
    //! [paint]
    CGP::Gray_image image = rosette(256);
    const double radius = 8;  // pixels
    if (filter == "low") image = CGP::filtered(image, CGP::Curvature_band::low, radius);
    if (filter == "high") image = CGP::filtered(image, CGP::Curvature_band::high, radius);
    if (filter == "unsharp") image = CGP::filtered(image, CGP::Curvature_band::unsharp, radius);

    auto rho = mesh.add_property_map<Mesh::Face_index, double>("f:rho").first;
    for (auto f : faces(mesh)) {  // the surface is in [-1, 1]^3, and the picture is seen along z
      CGAL::Simple_cartesian<double>::Vector_3 sum(0, 0, 0);
      for (auto v : vertices_around_face(mesh.halfedge(f), mesh))
        sum += mesh.point(v) - CGAL::ORIGIN;
      rho[f] = 20 * (image(0.5 + sum.x() / 6, 0.5 + sum.y() / 6) - 0.5);
    }
    const auto binormals_stay =
        CGP::parameters::boundary_direction(CGP::Boundary_direction{0, 0, 1});
    const CGP::Spin_report report = CGP::spin_transform(mesh, rho, binormals_stay);
    std::cout << report;
    //! [paint]
    if (!report) return EXIT_FAILURE;
  } catch (const CGP::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  std::ofstream file(output, std::ios::binary);
  return CGAL::IO::write_PLY(file, mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
