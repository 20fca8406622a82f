// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// The program of README.md: deforms a closed surface by rings of curvature.
//
//   first_program INPUT OUTPUT
//! [program]
#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Conformal_geometry_processing/spin_transform.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <iostream>
#include <stdexcept>

namespace CGP = Conformal_geometry_processing;

int main(int argc, char* argv[])
try {
  CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> mesh;
  if (argc < 3 || !CGAL::IO::read_polygon_mesh(argv[1], mesh))
    throw std::runtime_error("wanted: MESH OUTPUT");
  const CGAL::Bbox_3 box = CGAL::bbox_3(mesh.points().begin(), mesh.points().end());
  const double unit = std::hypot(box.x_span(), box.y_span(), box.z_span()) / 2;

  auto rho = mesh.add_property_map<CGAL::SM_Vertex_index, double>("v:rho").first;
  for (auto v : vertices(mesh)) {  // the change of mean curvature, in 1/length: rings
    const double y = (mesh.point(v).y() - (box.ymin() + box.ymax()) / 2) / unit;
    rho[v] = 1.5 * std::sin(5 * y) / unit;
  }

  // moves vertices; no length changes by more than a factor of 2
  const auto report = CGP::spin_transform(mesh, rho);
  std::cout << report;  // the certificate
  return report && CGAL::IO::write_polygon_mesh(argv[2], mesh) ? 0 : 1;
} catch (const std::exception& error) {  // names the first face that is not a triangle, ...
  std::cerr << error.what() << '\n';
  return 1;
}
//! [program]
