// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <CGAL/boost/graph/graph_traits_Surface_mesh.h>
// after the traits of its mesh
#include <CGAL/boost/graph/Seam_mesh.h>

#include <unordered_map>
#include <vector>

#include "parameterization/Method.h"

namespace cgp_benchmark {

using Seam = CGAL::Seam_mesh<Surface, Surface::Property_map<Surface::Edge_index, bool>,
                             Surface::Property_map<Surface::Vertex_index, bool>>;
using Seam_vertex = boost::graph_traits<Seam>::vertex_descriptor;

/// \brief a sphere, cut open along a path of edges that passes through its cones.
///
/// The cones are far from each other: the first is the vertex farthest from vertex 0, each of the
/// others is the farthest from those before it, in length of edges. One shortest path joins each
/// to the next; none meets another but in its ends.
class Cut_surface {
 public:
  Cut_surface(const Surface& closed, int number_of_cones);
  Cut_surface(const Cut_surface&) = delete;  // `seam` refers to `closed`

  Surface closed;
  std::vector<Surface::Vertex_index> cones;  ///< in their order along the path
  Seam seam;                                 ///< the cut surface as CGAL has it
  std::unordered_map<Seam_vertex, int> numbers;
  Surface disk;  ///< the same with vertices doubled: vertex v of the seam mesh has `numbers[v]`

 private:
  void add_path(const std::vector<Surface::Vertex_index>& path);
  void build_disk();
};

/// The orbifold Tutte embeddings of CGAL with this number of cones; they map `cut.disk`
std::vector<Method> orbifold_methods(Cut_surface& cut);

}  // namespace cgp_benchmark
