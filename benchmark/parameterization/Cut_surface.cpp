// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "parameterization/Cut_surface.h"

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <stdexcept>
#include <utility>

namespace cgp_benchmark {
namespace {

using Vertex = Surface::Vertex_index;
using Path = std::vector<Vertex>;

/// from one vertex to all
struct Shortest_paths {
  std::vector<double> length;       // infinite where there is none
  std::vector<Vertex> predecessor;  // of the vertex, on its path
};

Shortest_paths shortest_paths(const Surface& mesh, Vertex source,
                              const std::vector<char>& is_barred)
{
  Shortest_paths paths;
  paths.length.assign(mesh.number_of_vertices(), std::numeric_limits<double>::infinity());
  paths.predecessor.assign(mesh.number_of_vertices(), Surface::null_vertex());
  using Entry = std::pair<double, Vertex>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> front;
  paths.length[source] = 0;
  front.push({0, source});
  while (!front.empty()) {
    const auto [length, v] = front.top();
    front.pop();
    if (length > paths.length[v]) continue;  // has been shortened since
    for (const Vertex u : CGAL::vertices_around_target(mesh.halfedge(v), mesh)) {
      const double longer =
          length + std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(u)));
      if (is_barred[u] || longer >= paths.length[u]) continue;
      paths.length[u] = longer;
      paths.predecessor[u] = v;
      front.push({longer, u});
    }
  }
  return paths;
}

std::vector<Vertex> far_vertices(const Surface& mesh, int count)
{
  const std::vector<char> none(mesh.number_of_vertices(), false);
  const auto farthest = [](const std::vector<double>& lengths) {
    return Vertex(static_cast<Surface::size_type>(std::max_element(lengths.begin(), lengths.end()) -
                                                  lengths.begin()));
  };
  std::vector<Vertex> chosen{farthest(shortest_paths(mesh, Vertex(0), none).length)};
  std::vector<double> nearest = shortest_paths(mesh, chosen[0], none).length;
  while (static_cast<int>(chosen.size()) < count) {
    chosen.push_back(farthest(nearest));
    const std::vector<double> lengths = shortest_paths(mesh, chosen.back(), none).length;
    for (std::size_t v = 0; v < nearest.size(); ++v) nearest[v] = std::min(nearest[v], lengths[v]);
  }
  return chosen;
}

Path path_between(const Surface& mesh, Vertex source, Vertex target,
                  const std::vector<char>& is_barred)
{
  const Shortest_paths paths = shortest_paths(mesh, source, is_barred);
  Path path{target};
  while (path.back() != source) {
    path.push_back(paths.predecessor[path.back()]);
    if (path.back() == Surface::null_vertex()) throw std::runtime_error("no path between cones");
  }
  return path;
}

}  // namespace

Cut_surface::Cut_surface(const Surface& surface, int number_of_cones)
    : closed(surface),
      cones(far_vertices(closed, number_of_cones)),
      seam(closed, closed.add_property_map<Surface::Edge_index, bool>("e:seam", false).first,
           closed.add_property_map<Surface::Vertex_index, bool>("v:seam", false).first)
{
  std::vector<char> is_barred(closed.number_of_vertices(), false);
  for (const Vertex cone : cones) is_barred[cone] = true;
  for (std::size_t i = 1; i < cones.size(); ++i) {
    is_barred[cones[i]] = false;
    const Path path = path_between(closed, cones[i - 1], cones[i], is_barred);
    for (const Vertex v : path) is_barred[v] = true;
    add_path(path);
  }
  build_disk();
}

void Cut_surface::add_path(const Path& path)
{
  for (std::size_t i = 1; i < path.size(); ++i) seam.add_seam(path[i - 1], path[i]);
}

void Cut_surface::build_disk()
{
  const auto points = get(CGAL::vertex_point, seam);
  for (const Seam_vertex v : vertices(seam)) {
    numbers.emplace(v, static_cast<int>(numbers.size()));
    disk.add_vertex(get(points, v));
  }
  for (const Surface::Face_index f : faces(seam)) {
    Path corners;
    for (const Seam_vertex v : CGAL::vertices_around_face(halfedge(f, seam), seam))
      corners.emplace_back(static_cast<Surface::size_type>(numbers.at(v)));
    disk.add_face(corners);
  }
}

}  // namespace cgp_benchmark
