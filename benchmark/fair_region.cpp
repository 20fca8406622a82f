// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

/// Cuts disks out of surfaces, fills the holes by CGAL's `triangulate_and_refine_hole()`, and fairs
/// them by CGAL's `fair()` with continuity 1 and 2 and by `conformal_fairing()`. Of meshes, it also
/// fairs the disks themselves within their conformal class. Prints a line of JSON for each hole and
/// method.
///
/// Usage: benchmark_fair_region [--write FOLDER] [MESH.off:VERTEX:RADIUS]...
///
/// RADIUS is that of the ball around the vertex, by the diagonal of the mesh. Always on caps of
/// spheres and parts of tori, where the distance from the smooth surface is known; on meshes the
/// distance is that from the faces that were cut out.
#include <Conformal_geometry_processing/conformal_fairing.h>
#include <Conformal_geometry_processing/flow/Fairing_patch.h>
#include <Conformal_geometry_processing/mesh/normals.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#ifndef CGAL_EIGEN3_ENABLED
#define CGAL_EIGEN3_ENABLED
#endif
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/fair.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <functional>
#include <iostream>
#include <set>
#include <string>
#include <vector>

#include "support/Off_file.h"
#include "support/Record.h"
#include "support/cgal_meshes.h"
#include "support/clock.h"
#include "support/spheres.h"
#include "support/tori.h"

namespace {

using namespace cgp_benchmark;
namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
using Distance = std::function<double(const Kernel::Point_3&)>;

struct Filled {
  Mesh mesh;
  std::vector<Face> faces;
  std::vector<Vertex> vertices;
  double diagonal;  // of the hole
};

/// the connected faces with a vertex in the ball around a vertex, if they are a disk
std::vector<Face> disk(const Mesh& mesh, Vertex center, double radius)
{
  std::set<Vertex> inside{center};
  std::vector<Vertex> queue{center};
  for (std::size_t k = 0; k < queue.size(); ++k)
    for (const Vertex v : vertices_around_target(mesh.halfedge(queue[k]), mesh))
      if (CGAL::squared_distance(mesh.point(v), mesh.point(center)) < radius * radius &&
          inside.insert(v).second)
        queue.push_back(v);
  std::vector<Face> found;
  for (const Face f : faces(mesh)) {
    const auto ring = vertices_around_face(mesh.halfedge(f), mesh);
    if (std::any_of(ring.begin(), ring.end(), [&](Vertex v) { return inside.count(v) > 0; }))
      found.push_back(f);
  }
  return found;
}

Filled refilled(Mesh mesh, const std::vector<Face>& cut)
{
  for (const Face f : cut) CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  std::vector<Mesh::Halfedge_index> holes;
  PMP::extract_boundary_cycles(mesh, std::back_inserter(holes));
  if (holes.size() != 1) throw std::runtime_error("the hole is not a disk, or not the only one");
  CGAL::Bbox_3 box;
  for (const auto h : halfedges_around_face(holes[0], mesh))
    box += mesh.point(mesh.target(h)).bbox();
  Filled filled;
  PMP::triangulate_and_refine_hole(mesh, holes[0], std::back_inserter(filled.faces),
                                   std::back_inserter(filled.vertices));
  filled.mesh = std::move(mesh);
  filled.diagonal =
      std::sqrt(CGAL::squared_distance(Kernel::Point_3(box.xmin(), box.ymin(), box.zmin()),
                                       Kernel::Point_3(box.xmax(), box.ymax(), box.zmax())));
  return filled;
}

CGP::Mesh_view view_of(const Mesh& mesh)
{
  return CGP::Graph_view<Mesh>(mesh, CGP::parameters::default_values(), "benchmark").view();
}

/// of all faces of the region, in degrees
double least_angle(const CGP::Mesh_view& view, const std::vector<char>& region)
{
  double least = 180;
  for (int f = 0; f < view.size_of_faces(); ++f)
    for (int c = 0; c < 3 && region[static_cast<std::size_t>(f)]; ++c)
      least = std::min(least, CGP::corner_angle(view.sheet(f), c) * 180 / cgp_test::pi);
  return least;
}

class Hole {
 public:
  Hole(std::string name, const Mesh& mesh, const std::vector<Face>& cut, Distance distance,
       std::string folder)
      : m_name(std::move(name)),
        m_folder(std::move(folder)),
        m_filled(refilled(mesh, cut)),
        m_distance(std::move(distance)),
        m_before(mesh),
        m_cut(cut)
  {}

  void compare() const
  {
    report("before", m_before, m_cut, 0, 0);
    report("filled", m_filled.mesh, m_filled.faces, 0, 0);
    for (const unsigned continuity : {1u, 2u}) {
      Mesh mesh = m_filled.mesh;
      const double seconds = seconds_of([&] {
        if (!PMP::fair(mesh, m_filled.vertices, CGAL::parameters::fairing_continuity(continuity)))
          throw std::runtime_error("fair() has failed");
      });
      report("fair, continuity " + std::to_string(continuity), mesh, m_filled.faces, seconds, 1);
    }
    Mesh mesh = m_filled.mesh;
    int steps = 0;
    const double seconds = seconds_of([&] {
      const auto result = CGP::conformal_fairing(mesh, m_filled.faces,
                                                 CGP::parameters::exact_conformal_class(false));
      if (!result) std::cerr << m_name << ": " << result.message << '\n';
      steps = result.steps;
    });
    report("conformal_fairing", mesh, m_filled.faces, seconds, steps);
  }

  /// the surface as it was, smoothed within its class
  void fair_in_class() const
  {
    Mesh mesh = m_before;
    CGP::internal::Fairing_report result;
    const double seconds = seconds_of([&] { result = CGP::conformal_fairing(mesh, m_cut); });
    const CGP::Conformality& map = result.conformality;
    Record record;
    record.add("surface", m_name).add("method", "in class").add("vertices", result.free_vertices);
    record.add("energy_before", result.initial_energy).add("energy", result.energy);
    record.add("jump_rms", result.normal_jump.rms * 180 / cgp_test::pi);
    record.add("q_mean", map.quasi_conformal.mean).add("q_max", map.quasi_conformal.max);
    record.add("cross_ratio_max", map.length_cross_ratio.max).add("flips", map.flipped_faces);
    record.add("seconds", seconds).add("steps", result.steps);
    record.add("message", result.message).print();
  }

 private:
  void report(const std::string& method, const Mesh& mesh, const std::vector<Face>& faces,
              double seconds, int steps) const
  {
    const CGP::Mesh_view view = view_of(mesh);
    const auto region = CGP::internal::read_region(
        CGP::Graph_view<Mesh>(mesh, CGP::parameters::default_values(), "benchmark"), faces,
        "benchmark");
    const CGP::internal::Fairing_patch patch(view, region, m_name);
    const auto jump = CGP::internal::normal_jump(patch, patch.mesh().positions());
    double sum = 0, largest = 0;
    for (int k = 0; k < patch.size(); ++k) {
      const Eigen::Vector3d p = patch.mesh().position(patch.free_vertex(k));
      const double d = m_distance({p.x(), p.y(), p.z()}) / m_filled.diagonal;
      sum += d, largest = std::max(largest, d);
    }
    Record record;
    record.add("surface", m_name).add("method", method).add("vertices", patch.size());
    record.add("distance_mean", sum / patch.size()).add("distance_max", largest);
    const double degree = cgp_test::pi / 180;
    record.add("jump_rms", jump.rms / degree).add("jump_max", jump.max / degree);
    record.add("energy", CGP::internal::Bending_energy(patch, patch.mesh().positions()).value());
    record.add("least_angle", least_angle(view, region));
    record.add("seconds", seconds).add("steps", steps).print();
    if (m_folder.empty()) return;
    std::ofstream file(m_folder + "/" + m_name + "_" + method.substr(0, 4) + method.back() +
                       ".off");
    file.precision(17);
    CGAL::IO::write_OFF(file, mesh);
  }

  std::string m_name, m_folder;
  Filled m_filled;
  Distance m_distance;
  Mesh m_before;
  std::vector<Face> m_cut;
};

std::vector<Face> faces_where(const CGP::Mesh_view& view,
                              const std::function<bool(const Eigen::Vector3d&)>& is_inside)
{
  std::vector<Face> found;
  for (int f = 0; f < view.size_of_faces(); ++f) {
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    for (const int v : view.corners(f)) center += view.position(v) / 3;
    if (is_inside(center)) found.push_back(Face(static_cast<unsigned>(f)));
  }
  return found;
}

void compare_smooth_surfaces(const std::string& folder)
{
  for (const int frequency : {8, 16, 32, 64}) {
    const CGP::Mesh_view view = cgp_test::geodesic_sphere(frequency);
    const auto cap = faces_where(view, [](const auto& c) { return c.z() > .2; });
    Hole(
        "sphere " + std::to_string(frequency), cgp_test::to_cgal_mesh<Mesh>(view), cap,
        [](const auto& p) {
          return std::abs(std::sqrt(CGAL::squared_distance(p, Kernel::Point_3(0, 0, 0))) - 1);
        },
        folder)
        .compare();
  }
  const std::pair<const char*, double> tori[] = {{"Clifford torus", std::sqrt(2.)}, {"torus", 3}};
  for (const auto& [name, R] : tori)
    for (const int n : {16, 32, 64, 128}) {
      const double radius = R;
      const CGP::Mesh_view view = cgp_test::torus(R, 1, static_cast<int>(std::lround(n * R)), n);
      const auto top = faces_where(view, [radius](const auto& c) {
        return (c - Eigen::Vector3d(radius, 0, 1)).norm() < 1.1;
      });
      Hole(
          name + (" " + std::to_string(n)), cgp_test::to_cgal_mesh<Mesh>(view), top,
          [radius](const auto& p) {
            return std::abs(std::hypot(std::hypot(p.x(), p.y()) - radius, p.z()) - 1);
          },
          folder)
          .compare();
    }
}

using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

void compare_mesh(const std::string& argument, const std::string& folder)
{
  const std::size_t second = argument.rfind(':'), first = argument.rfind(':', second - 1);
  const std::string path = argument.substr(0, first);
  const Mesh mesh = cgp_test::to_cgal_mesh<Mesh>(read_off(path));
  CGAL::Bbox_3 box;
  for (const auto& p : mesh.points()) box += p.bbox();
  const double diagonal =
      std::sqrt(CGAL::square(box.xmax() - box.xmin()) + CGAL::square(box.ymax() - box.ymin()) +
                CGAL::square(box.zmax() - box.zmin()));
  const Vertex center(static_cast<unsigned>(std::stoul(argument.substr(first + 1))));
  const auto cut = disk(mesh, center, diagonal * std::stod(argument.substr(second + 1)));
  Tree tree(cut.begin(), cut.end(), mesh);
  std::string name = path.substr(path.rfind('/') + 1);
  name.resize(name.rfind('.'));
  const Hole hole(
      name + " " + std::to_string(center.idx()), mesh, cut,
      [&](const auto& p) { return std::sqrt(tree.squared_distance(p)); }, folder);
  hole.compare();
  hole.fair_in_class();
}

}  // namespace

int main(int argc, char* argv[])
{
  try {
    const bool writes = argc > 2 && std::string(argv[1]) == "--write";
    const std::string folder = writes ? argv[2] : "";
    if (argc == (writes ? 3 : 1)) compare_smooth_surfaces(folder);
    for (int i = writes ? 3 : 1; i < argc; ++i) compare_mesh(argv[i], folder);
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::cerr << "benchmark_fair_region: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
