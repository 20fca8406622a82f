// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "bad_surfaces/solids.h"

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/clip.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/transform.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <optional>

namespace cgp_benchmark {

namespace PMP = CGAL::Polygon_mesh_processing;
using Vertices = std::vector<Mesh::Vertex_index>;

namespace {

const double pi = std::acos(-1);

int whole(Chance& chance, int low, int high)
{
  return std::uniform_int_distribution<int>(low, high)(chance);
}

/// a random rotation, dilatation along axes and translation of this size
void place(Mesh& mesh, Chance& chance, double move)
{
  Eigen::Quaterniond turn(uniform(chance, -1, 1), uniform(chance, -1, 1), uniform(chance, -1, 1),
                          uniform(chance, -1, 1));
  const Eigen::Vector3d size(uniform(chance, .4, 1), uniform(chance, .4, 1),
                             uniform(chance, .4, 1));
  const Eigen::Matrix3d m = turn.normalized().toRotationMatrix() * size.asDiagonal();
  double to[3];
  for (double& x : to) x = move * uniform(chance, -1, 1);
  PMP::transform(
      CGAL::Aff_transformation_3<Kernel>(m(0, 0), m(0, 1), m(0, 2), to[0], m(1, 0), m(1, 1),
                                         m(1, 2), to[1], m(2, 0), m(2, 1), m(2, 2), to[2]),
      mesh);
}

/// the faces of a grid of rows of vertices, each of them closed
void add_rings(Mesh& mesh, const std::vector<Vertices>& rows, bool is_closed)
{
  const std::size_t bands = rows.size() - (is_closed ? 0 : 1);
  for (std::size_t i = 0; i < bands; ++i) {
    const Vertices &low = rows[i], &high = rows[(i + 1) % rows.size()];
    for (std::size_t j = 0, n = low.size(); j < n; ++j) {
      mesh.add_face(low[j], low[(j + 1) % n], high[(j + 1) % n]);
      mesh.add_face(low[j], high[(j + 1) % n], high[j]);
    }
  }
}

Vertices ring(Mesh& mesh, double radius, double height, int segments)
{
  Vertices row;
  for (int j = 0; j < segments; ++j) {
    const double angle = 2 * pi * j / segments;
    row.push_back(mesh.add_vertex({radius * std::cos(angle), radius * std::sin(angle), height}));
  }
  return row;
}

void add_fan(Mesh& mesh, Mesh::Vertex_index apex, const Vertices& row, bool is_top)
{
  for (std::size_t j = 0, n = row.size(); j < n; ++j) {
    const auto a = row[j], b = row[(j + 1) % n];
    is_top ? mesh.add_face(a, b, apex) : mesh.add_face(b, a, apex);
  }
}

Mesh torus(double radius, double thickness, int around, int across)
{
  Mesh mesh;
  std::vector<Vertices> rows;
  for (int i = 0; i < across; ++i) {
    const double angle = 2 * pi * i / across;
    rows.push_back(
        ring(mesh, radius + thickness * std::cos(angle), thickness * std::sin(angle), around));
  }
  add_rings(mesh, rows, true);
  return mesh;
}

Mesh ball(int across, int segments)
{
  std::vector<std::pair<double, double>> profile;
  for (int i = 0; i <= across; ++i)
    profile.emplace_back(std::sin(pi * i / across), -std::cos(pi * i / across));
  return turned(profile, segments);
}

Mesh box()
{
  const double half = std::sqrt(.5);
  return turned({{0, -1}, {half, -1}, {half, 1}, {0, 1}}, 4);
}

// Coordinates of intersections are rounded, so that the next one may find a surface that meets
// itself: nullopt then.
template <class Operation>
std::optional<Mesh> combined(Operation operation, Mesh a, Mesh b)
{
  Mesh result;
  try {
    const auto strictly = CGAL::parameters::throw_on_self_intersection(true);
    if (operation(a, b, result, strictly) && !result.is_empty()) return result;
  } catch (const PMP::Corefinement::Self_intersection_exception&) {
  }
  return std::nullopt;
}

const auto unite = [](Mesh& a, Mesh& b, Mesh& result, const auto& np) {
  return PMP::corefine_and_compute_union(a, b, result, np, np);
};

const auto subtract = [](Mesh& a, Mesh& b, Mesh& result, const auto& np) {
  return PMP::corefine_and_compute_difference(a, b, result, np, np);
};

}  // namespace

double uniform(Chance& chance, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(chance);
}

Mesh turned(const std::vector<std::pair<double, double>>& profile, int segments)
{
  Mesh mesh;
  std::vector<Vertices> rows;
  for (std::size_t i = 1; i + 1 < profile.size(); ++i)
    rows.push_back(ring(mesh, profile[i].first, profile[i].second, segments));
  add_rings(mesh, rows, false);
  add_fan(mesh, mesh.add_vertex({0, 0, profile.front().second}), rows.front(), false);
  add_fan(mesh, mesh.add_vertex({0, 0, profile.back().second}), rows.back(), true);
  return mesh;
}

Mesh random_solid(Chance& chance)
{
  const int kind = whole(chance, 0, 4), segments = whole(chance, 5, 40);
  Mesh mesh = kind == 0   ? box()
              : kind == 1 ? turned({{0, -1}, {.5, -1}, {.5, 1}, {0, 1}}, segments)
              : kind == 2
                  ? turned({{0, -1}, {.7, -1}, {uniform(chance, .001, .2), 1}, {0, 1}}, segments)
              : kind == 3 ? ball(whole(chance, 4, 14), segments)
                          : torus(.7, uniform(chance, .05, .3), segments, whole(chance, 4, 12));
  place(mesh, chance, .5);
  return mesh;
}

Mesh random_extrusion(Chance& chance)
{
  const int corners = whole(chance, 3, 120), rows = whole(chance, 2, 5);
  const double height = std::pow(10, uniform(chance, -2, 1.5));
  std::vector<double> radii;
  for (int j = 0; j < corners; ++j) radii.push_back(uniform(chance, .3, 1));
  Mesh mesh;
  std::vector<Vertices> rings;
  for (int i = 0; i < rows; ++i) {
    rings.push_back(ring(mesh, 1, height * i / (rows - 1), corners));
    for (std::size_t j = 0; j < rings.back().size(); ++j) {
      Point& p = mesh.point(rings.back()[j]);
      p = Point(radii[j] * p.x(), radii[j] * p.y(), p.z());
    }
  }
  add_rings(mesh, rings, false);
  mesh.add_face(rings.back());
  mesh.add_face(Vertices(rings.front().rbegin(), rings.front().rend()));
  PMP::triangulate_faces(mesh);
  return mesh;
}

Mesh random_scan(Chance& chance)
{
  const int segments = whole(chance, 20, 40);
  Mesh mesh = whole(chance, 0, 2) == 0 ? torus(.8, uniform(chance, .1, .4), segments, 12)
                                       : ball(20, segments);
  const double waves = uniform(chance, 0, .2), count = uniform(chance, 2, 8),
               noise = std::pow(10, uniform(chance, -4, -1.3)), crowd = uniform(chance, 0, .95);
  for (auto v : mesh.vertices()) {
    const Point p = mesh.point(v);
    const double factor = 1 + waves * std::sin(count * p.x()) * std::cos(count * p.z());
    const auto moved = [&](double x) { return factor * x + noise * uniform(chance, -1, 1); };
    const double z = moved(p.z());
    mesh.point(v) = Point(moved(p.x()), moved(p.y()), z - crowd * (1 - z * z) / 2);
  }
  return mesh;
}

Mesh random_union(Chance& chance)
{
  Mesh all = random_solid(chance);
  for (int left = whole(chance, 1, 3); left > 0; --left) {
    all = combined(unite, all, random_solid(chance)).value_or(all);
  }
  return all;
}

Mesh random_vessel(Chance& chance)
{
  Mesh outside = random_solid(chance);
  const CGAL::Bbox_3 box = PMP::bbox(outside);
  const double share = 1 - std::pow(10, uniform(chance, -4, -1));
  Mesh inside = outside;
  const auto centre = [&](int i) { return (box.min(i) + box.max(i)) / 2 * (1 - share); };
  PMP::transform(CGAL::Aff_transformation_3<Kernel>(share, 0, 0, centre(0), 0, share, 0, centre(1),
                                                    0, 0, share, centre(2)),
                 inside);
  Mesh lid = turned({{0, 0}, {9, 0}, {9, 9}, {0, 9}}, 4);
  PMP::transform(CGAL::Aff_transformation_3<Kernel>(
                     CGAL::TRANSLATION,
                     Kernel::Vector_3(.01, .02, box.zmin() + .6 * (box.zmax() - box.zmin()))),
                 lid);
  const std::optional<Mesh> shell = combined(subtract, outside, inside);
  const std::optional<Mesh> vessel = shell ? combined(subtract, *shell, lid) : shell;
  return vessel ? *vessel : random_vessel(chance);
}

Mesh random_cut(Chance& chance, const Mesh& mesh)
{
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  const auto inside = [&](int i) {
    return box.min(i) + uniform(chance, .3, .7) * (box.max(i) - box.min(i));
  };
  const Point middle(inside(0), inside(1), inside(2));
  const Kernel::Vector_3 normal(uniform(chance, -1, 1), uniform(chance, -1, 1),
                                uniform(chance, -1, 1));
  Mesh part = mesh;
  PMP::clip(part, Kernel::Plane_3(middle, normal),
            CGAL::parameters::allow_self_intersections(true));
  part.collect_garbage();
  return part;
}

}  // namespace cgp_benchmark
