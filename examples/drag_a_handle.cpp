// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Drags the highest point of a surface, and holds points that are spread over the rest.
//
//   drag_a_handle [INPUT [OUTPUT.ply [DISTANCE]]]
//
// DISTANCE is relative to the height. All angles are kept, so textures are not sheared.
#include <Conformal_geometry_processing/conformal_deformation.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <vector>

namespace CGP = Conformal_geometry_processing;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
{
  const char* const output = argc > 2 ? argv[2] : "drag_a_handle.ply";
  const double distance = argc > 3 ? std::atof(argv[3]) : 0.2;
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "bear.off", mesh) || mesh.is_empty())
    return EXIT_FAILURE;
  try {
    //! [drag]
    const CGAL::Bbox_3 box = CGAL::bbox_3(mesh.points().begin(), mesh.points().end());
    const double height = box.ymax() - box.ymin();
    std::vector<std::pair<Mesh::Vertex_index, Kernel::Point_3>> targets;
    const auto away = [&](auto v) {  // from the points so far; the first one is the highest
      double nearest = targets.empty() ? mesh.point(v).y() - box.ymin() : height * height;
      for (const auto& [u, p] : targets)
        nearest = (std::min)(nearest, CGAL::squared_distance(mesh.point(v), p));
      return nearest;
    };
    while (targets.size() < 8) {
      const auto v = *std::max_element(vertices(mesh).begin(), vertices(mesh).end(),
                                       [&](auto a, auto b) { return away(a) < away(b); });
      targets.emplace_back(v, mesh.point(v));
    }
    targets[0].second += Kernel::Vector_3(distance * height, 0, 0);
    const CGP::Spin_report report = CGP::conformal_deformation(mesh, targets);
    std::cout << report << "distance from the targets " << report.position_error.max << '\n';
    //! [drag]
    if (!report) return EXIT_FAILURE;
  } catch (const CGP::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  std::ofstream file(output, std::ios::binary);
  CGAL::IO::set_binary_mode(file);
  return CGAL::IO::write_PLY(file, mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
