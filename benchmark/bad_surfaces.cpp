// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

/// Writes surfaces as CAD programs and scanners make them, with triangles as bad as theirs, for
/// `benchmark/survey --bad`.
///
/// Usage: benchmark_bad_surfaces FOLDER NUMBER
///
/// NUMBER of each kind: unions (of solids, by corefinement), vessels (thin walls), extrusions,
/// scans (noise up to an edge length, crowded vertices), these cut open, and of all of them:
/// decimated, snapped to grids of 8 to 12 bits, and in single precision. The same arguments give
/// the same files.
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_ratio_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <cmath>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>
#include <string>

#include "bad_surfaces/solids.h"

namespace {

using namespace cgp_benchmark;
namespace SMS = CGAL::Surface_mesh_simplification;

Mesh closed(Chance& chance)
{
  switch (chance() % 4) {
    case 0:
      return random_union(chance);
    case 1:
      return random_vessel(chance);
    case 2:
      return random_extrusion(chance);
    default:
      return random_scan(chance);
  }
}

Mesh cut(Chance& chance)
{
  return random_cut(chance, closed(chance));
}

Mesh any(Chance& chance)
{
  return chance() % 3 == 0 ? cut(chance) : closed(chance);
}

Mesh decimated(Chance& chance)
{
  Mesh mesh = any(chance);
  SMS::edge_collapse(mesh, SMS::Count_ratio_stop_predicate<Mesh>(uniform(chance, .1, .6)));
  mesh.collect_garbage();
  return mesh;
}

/// coordinates as multiples of the extent / 2^bits
Mesh snapped(Chance& chance)
{
  Mesh mesh = any(chance);
  const CGAL::Bbox_3 box = CGAL::bbox_3(mesh.points().begin(), mesh.points().end());
  const double cell = box.x_span() / std::exp2(8 + chance() % 5);
  const auto nearest = [cell](double x) { return cell * std::round(x / cell); };
  for (auto v : mesh.vertices()) {
    const Point p = mesh.point(v);
    mesh.point(v) = Point(nearest(p.x()), nearest(p.y()), nearest(p.z()));
  }
  return mesh;
}

using Maker = std::function<Mesh(Chance&)>;

const std::map<std::string, Maker>& makers()
{
  static const std::map<std::string, Maker> makers = {{"decimated", decimated},
                                                      {"extrusion", random_extrusion},
                                                      {"open", cut},
                                                      {"scan", random_scan},
                                                      {"single.stl", any},
                                                      {"snapped", snapped},
                                                      {"union", random_union},
                                                      {"vessel", random_vessel}};
  return makers;
}

/// kind_007.off, or .stl if the kind has this ending
void write(const std::string& folder, const std::string& kind, int number, const Mesh& mesh)
{
  const std::string name = kind.substr(0, kind.find('.'));
  const bool is_stl = name != kind;
  std::ostringstream path;
  path << folder << "/" << name << "_" << std::setw(3) << std::setfill('0') << number
       << (is_stl ? ".stl" : ".off");
  std::ofstream file(path.str(), std::ios::binary);
  file.precision(17);
  if (is_stl) CGAL::IO::set_binary_mode(file);
  if (!(is_stl ? CGAL::IO::write_STL(file, mesh) : CGAL::IO::write_OFF(file, mesh)) || !file)
    throw std::runtime_error("cannot write " + path.str());
}

}  // namespace

int main(int argc, char* argv[])
try {
  if (argc != 3 || std::atoi(argv[2]) <= 0) {
    std::cerr << "usage: benchmark_bad_surfaces FOLDER NUMBER\n";
    return 2;
  }
  for (const auto& [kind, make] : makers())
    for (int i = 0; i < std::atoi(argv[2]); ++i) {
      Chance chance(static_cast<unsigned>(1000 * i) + static_cast<unsigned>(kind.size()) +
                    static_cast<unsigned>(kind[0]));
      write(argv[1], kind, i, make(chance));
    }
  return 0;
} catch (const std::exception& error) {
  std::cerr << "benchmark_bad_surfaces: " << error.what() << '\n';
  return 1;
}
