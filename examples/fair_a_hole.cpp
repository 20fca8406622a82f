// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Cuts off the top of a surface, fills the hole by CGAL, and fairs the filling.
//
//   fair_a_hole [INPUT [OUTPUT.ply [SHARE [FILLED.ply]]]]
//
// SHARE is that of the height. The headers of Polygon_mesh_processing are under the GPL.
#include <Conformal_geometry_processing/conformal_fairing.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <set>
#include <vector>

namespace CGP = Conformal_geometry_processing;
namespace PMP = CGAL::Polygon_mesh_processing;
using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

void cut_off_the_top(Mesh& mesh, double share)
{
  const CGAL::Bbox_3 box = CGAL::bbox_3(mesh.points().begin(), mesh.points().end());
  const double height = box.ymax() - share * (box.ymax() - box.ymin());
  std::set<Mesh::Face_index> top;
  for (const auto h : halfedges(mesh))
    if (mesh.point(mesh.target(h)).y() > height && !is_border(h, mesh)) top.insert(face(h, mesh));
  for (const auto f : top) CGAL::Euler::remove_face(halfedge(f, mesh), mesh);
  mesh.collect_garbage();
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "bear.off", mesh)) return EXIT_FAILURE;
  cut_off_the_top(mesh, argc > 3 ? std::atof(argv[3]) : 0.1);
  try {
    //! [fair]
    std::vector<Mesh::Halfedge_index> holes;
    std::vector<Mesh::Face_index> filled;
    PMP::extract_boundary_cycles(mesh, std::back_inserter(holes));
    for (const auto h : holes)
      PMP::triangulate_and_refine_hole(mesh, h, std::back_inserter(filled),
                                       CGAL::Emptyset_iterator());
    if (argc > 4) CGAL::IO::write_polygon_mesh(argv[4], mesh);
    const auto report =
        CGP::conformal_fairing(mesh, filled, CGP::parameters::exact_conformal_class(false));
    std::cout << "angle between the normals at the rim " << report.initial_normal_jump.rms << " to "
              << report.normal_jump.rms << ", " << report.steps << " steps\n";
    //! [fair]
    if (!report) return EXIT_FAILURE;
  } catch (const CGP::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return CGAL::IO::write_polygon_mesh(argc > 2 ? argv[2] : "fair_a_hole.ply", mesh) ? EXIT_SUCCESS
                                                                                    : EXIT_FAILURE;
}
