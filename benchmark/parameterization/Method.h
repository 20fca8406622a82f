// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <functional>
#include <string>
#include <vector>

namespace cgp_benchmark {

using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Border = Surface::Halfedge_index;
using UV_map = Surface::Property_map<Surface::Vertex_index, Kernel::Point_2>;

/// a way to parameterize a surface
struct Method {
  std::string name;
  std::function<std::string(Surface&, Border, UV_map)> run;  ///< returns its status in words
};

/// The methods of CGAL, with default options
std::vector<Method> methods_of_cgal();

/// Those with symmetric systems, with the solver of this library
std::vector<Method> methods_of_cgal_with_our_solver();

/// the methods of this library
std::vector<Method> our_methods();

/// the thesis' variant in the way of the reference implementation, on which its numbers depend
Method reference_method();

}  // namespace cgp_benchmark
