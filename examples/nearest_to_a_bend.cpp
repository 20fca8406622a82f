// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Bends a surface by half a turn, and computes the nearest conformal deformation.
//
//   nearest_to_a_bend [INPUT [OUTPUT.ply [BLEND]]]
//
// The curvature of the bend is preserved, its shear is not. With BLEND = 1 its rotations and
// scalings are integrated, with a shear that does not vanish under refinement [CGP 5.9, 6.3].
#include <Conformal_geometry_processing/nearest_spin_transform.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>

namespace CGP = Conformal_geometry_processing;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

int main(int argc, char* argv[])
{
  const char* const input = argc > 1 ? argv[1] : "beam.off";
  const char* const output = argc > 2 ? argv[2] : "nearest_to_a_bend.ply";
  const double blend = argc > 3 ? std::atof(argv[3]) : 0;
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(input, mesh) || mesh.is_empty()) return EXIT_FAILURE;
  try {
    //! [fit]
    const CGAL::Bbox_3 box = CGAL::bbox_3(mesh.points().begin(), mesh.points().end());
    const double radius = (box.zmax() - box.zmin()) / 3.14159265;
    const double middle = (box.ymin() + box.ymax()) / 2;  // keeps its length

    auto target = mesh.add_property_map<Mesh::Vertex_index, Point>("v:target").first;
    for (auto v : vertices(mesh)) {
      const Point& p = mesh.point(v);
      const double angle = (p.z() - box.zmin()) / radius, r = radius + p.y() - middle;
      target[v] = Point(p.x(), r * std::cos(angle), r * std::sin(angle));
    }
    CGP::Nearest_spin_options fit;
    fit.keep_curvature = true;
    const CGP::Nearest_spin_report report =
        CGP::nearest_spin_transform(mesh, target, CGP::parameters::blend(blend).fit(fit));
    std::cout << report << "distance from the bend " << report.distance << " of its size\n";
    //! [fit]
    if (!report) return EXIT_FAILURE;
  } catch (const CGP::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  std::ofstream file(output, std::ios::binary);
  CGAL::IO::set_binary_mode(file);
  return CGAL::IO::write_PLY(file, mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
