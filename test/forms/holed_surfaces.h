// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include "support/bounded_meshes.h"
#include "support/tori.h"

/// Surfaces that harmonic forms of Neumann type are found on.
namespace cgp_test {

/// Removes some faces of a mesh; every vertex must keep a face
inline Mesh_view without_faces(Mesh_view mesh, std::vector<int> faces)
{
  std::sort(faces.begin(), faces.end(), std::greater<int>());
  for (const int f : faces) mesh = without_face(mesh, f);
  return mesh;
}

/// `disk(n)` without three faces far from each other and from the rim; n >= 6, even
inline Mesh_view disk_with_three_holes(int n)
{
  // The first face of every second sector in the ring n / 2.
  const int k = n / 2, first = 6 * (k - 1) * (k - 1), per_sector = 2 * k - 1;
  return without_faces(disk(n), {first, first + 2 * per_sector, first + 4 * per_sector});
}

/// a torus with one face missing
inline Mesh_view torus_with_hole(int m, int n)
{
  return without_face(torus(2, 1, m, n), m * n);
}

/// a plane annulus, mapped conformally so that it has no symmetry but a reflection
inline Mesh_view bent_annulus(int m, int n)
{
  return mapped(annulus(.4, 1, m, n), [](const Eigen::Vector3d& p) {
    const double x = p.x(), y = p.y();
    return Eigen::Vector3d(x + .3 * (x * x - y * y), y + .6 * x * y, 0);
  });
}

}  // namespace cgp_test
