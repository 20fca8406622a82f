// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Computes the tangent fields along and around the handles of a surface, and the metric that they
// define.
//
//   fields_along_handles [INPUT [OUTPUT.ply]]
//
// A surface of genus G has 2G harmonic fields. Half the sum of their squared lengths is the area
// density of its canonical metric, which depends on the conformal structure only, and whose area is
// G [CGP 4.5.3, 6.4.5]. OUTPUT is the surface with that density, as the vertex property quality.
#include <Conformal_geometry_processing/canonical_metric.h>
#include <Conformal_geometry_processing/harmonic_basis.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>

namespace CGP = Conformal_geometry_processing;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
{
  const char* const input = argc > 1 ? argv[1] : "eight.off";
  const char* const output = argc > 2 ? argv[2] : "fields_along_handles.ply";
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(input, mesh)) return EXIT_FAILURE;
  try {
    //! [fields]
    const auto forms = CGP::harmonic_basis(mesh);
    for (int i = 0; i < forms.size(); ++i) {
      const auto field = forms.tangent_field(i);  // of faces, in 1/length
      double longest = 0;
      for (auto f : faces(mesh)) longest = std::max(longest, get(field, f).squared_length());
      std::cout << "field " << i << ": at most " << std::sqrt(longest) << '\n';
    }
    auto density = mesh.add_property_map<Mesh::Vertex_index, double>("v:quality").first;
    const CGP::Canonical_metric_report metric = CGP::canonical_metric(mesh, density);
    std::cout << "genus " << metric.genus << ", canonical area " << metric.area << '\n';
    //! [fields]
  } catch (const CGP::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  std::ofstream file(output, std::ios::binary);
  CGAL::IO::set_binary_mode(file);
  return CGAL::IO::write_PLY(file, mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
