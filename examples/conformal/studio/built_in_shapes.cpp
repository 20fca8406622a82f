// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "built_in_shapes.h"

#include <Conformal_geometry_processing/surfaces/spheres.h>
#include <Conformal_geometry_processing/surfaces/tori.h>

#include <cmath>

namespace conformal {
namespace {

/// a bulge of a star-shaped surface: where, how far, and how narrow
struct Limb {
  Eigen::Vector3d direction;
  double length, sharpness;
};

/// Head, ears, arms, legs and tail on a sphere.
CGP::Mesh_view creature(int frequency)
{
  const std::vector<Limb> limbs = {
      {{0, 1, .3}, .95, 8},    {{.5, 1, .1}, .45, 70},   {{-.5, 1, .1}, .45, 70},
      {{0, .7, .75}, .3, 40},  {{1, .1, .4}, .95, 22},   {{-1, .1, .4}, .95, 22},
      {{.55, -1, .35}, 1, 18}, {{-.55, -1, .35}, 1, 18}, {{0, -.35, -1}, .35, 60},
  };
  const CGP::Mesh_view sphere = CGP::geodesic_sphere(frequency);
  CGP::Points points = sphere.positions();
  for (int v = 0; v < points.cols(); ++v) {
    double radius = 1;
    for (const Limb& limb : limbs) {
      const double cosine = sphere.position(v).dot(limb.direction.normalized());
      radius += limb.length * std::exp(limb.sharpness * (cosine - 1));
    }
    points.col(v) *= radius;
  }
  return {points, sphere.corners()};
}

/// Rings of 6, 12, 18, ... vertices around a centre, on a shallow dome.
CGP::Mesh_view dome(int rings)
{
  const auto first = [](int ring) { return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1); };
  CGP::Points points(3, first(rings + 1));
  points.col(0) = Eigen::Vector3d(0, 0, .15);
  CGP::Mesh_view::Corners corners;
  for (int ring = 1; ring <= rings; ++ring) {
    const int count = 6 * ring;
    for (int i = 0; i < count; ++i) {
      const double r = double(ring) / rings, angle = 2 * std::acos(-1.) * i / count;
      points.col(first(ring) + i) =
          Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), .15 * (1 - r * r));
      const int side = i / ring, along = i % ring, inner = 6 * (ring - 1);
      const auto inside = [&](int j) { return inner == 0 ? 0 : first(ring - 1) + j % inner; };
      const int here = first(ring) + i, next = first(ring) + (i + 1) % count;
      const int below = inside(side * (ring - 1) + along);
      corners.push_back({below, here, next});
      if (along < ring - 1) corners.push_back({below, next, inside(side * (ring - 1) + along + 1)});
    }
  }
  return {points, corners};
}

}  // namespace

std::vector<Studio_shape> built_in_shapes()
{
  return {{"Creature", "creature.obj", creature(18)},
          {"Sphere", "sphere.obj", CGP::geodesic_sphere(16)},
          {"Torus", "torus.obj", CGP::round_torus(1, .45, 84, 32)},
          {"Disk", "disk.obj", dome(28)}};
}

}  // namespace conformal
