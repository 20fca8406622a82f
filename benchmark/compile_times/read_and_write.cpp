// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// The part of examples/first_program.cpp without this library, to measure the compile time of CGAL.
#include <CGAL/Bbox_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <iostream>
int main(int argc, char* argv[])
{
  CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> mesh;
  if (argc < 3 || !CGAL::IO::read_polygon_mesh(argv[1], mesh)) return 1;
  const CGAL::Bbox_3 box = CGAL::bbox_3(mesh.points().begin(), mesh.points().end());
  std::cout << box.ymin();
  return CGAL::IO::write_polygon_mesh(argv[2], mesh) ? 0 : 1;
}
