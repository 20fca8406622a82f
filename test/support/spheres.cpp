// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "support/spheres.h"

namespace cgp_test {

Mesh_view icosahedron()
{
  const double g = (1 + std::sqrt(5.)) / 2;
  Points p = points({{-1, g, 0},
                     {1, g, 0},
                     {-1, -g, 0},
                     {1, -g, 0},
                     {0, -1, g},
                     {0, 1, g},
                     {0, -1, -g},
                     {0, 1, -g},
                     {g, 0, -1},
                     {g, 0, 1},
                     {-g, 0, -1},
                     {-g, 0, 1}});
  p.colwise().normalize();
  return {std::move(p),
          {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
           {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
           {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
}

Mesh_view projected_to_sphere(const Mesh_view& mesh)
{
  return mapped(mesh, [](const Eigen::Vector3d& p) { return Eigen::Vector3d(p.normalized()); });
}

Mesh_view icosphere(int level)
{
  Mesh_view mesh = icosahedron();
  for (int i = 0; i < level; ++i) mesh = projected_to_sphere(subdivided(mesh));
  return mesh;
}

Mesh_view geodesic_sphere(int frequency)
{
  const Mesh_view base = icosahedron();
  const int n = frequency, inner = (n - 1) * (n - 2) / 2, first_inner = 12 + 30 * (n - 1);
  Points p(3, first_inner + 20 * inner);
  Corners corners;
  for (int f = 0; f < 20; ++f) {
    const auto& v = base.corners(f);
    int next_inner = first_inner + f * inner;
    // On the edge h, s steps from its beginning.
    const auto on_edge = [&](int h, int s) {
      return 12 + base.edge(h) * (n - 1) + (base.from(h) < base.to(h) ? s : n - s) - 1;
    };
    // Row i has the points v0 + (i - j)/n (v1 - v0) + j/n (v2 - v0) for j = 0..i.
    const auto number = [&](int i, int j) {
      if (i == 0) return v[0];
      if (i == n && j == 0) return v[1];
      if (i == n && j == n) return v[2];
      if (j == 0) return on_edge(3 * f + 2, i);
      if (j == i) return on_edge(3 * f + 1, n - i);
      if (i == n) return on_edge(3 * f, j);
      return next_inner + (i - 1) * (i - 2) / 2 + j - 1;
    };
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= i; ++j) {
        p.col(number(i, j)) = ((n - i) * base.position(v[0]) + (i - j) * base.position(v[1]) +
                               j * base.position(v[2]))
                                  .normalized();
        if (i == n) continue;
        corners.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1)});
        if (j < i) corners.push_back({number(i, j), number(i + 1, j + 1), number(i, j + 1)});
      }
  }
  return {std::move(p), std::move(corners)};
}

Mesh_view bumpy_sphere(int level, double amplitude)
{
  return mapped(icosphere(level), [amplitude](const Eigen::Vector3d& p) {
    const double x = p.x(), y = p.y(), z = p.z();
    const double bump = x * y + z * (5 * z * z - 3) / 4 + 0.4 * (x * x - y * y) * z;
    return Eigen::Vector3d((1 + amplitude * bump) * p);
  });
}

double rho_of_section_3(const Eigen::Vector3d& point)
{
  const Eigen::Vector3d p = point.normalized();
  const double x = p.x(), y = p.y(), z = p.z();
  return 1.5 * x * y + 0.4 * z * (5 * z * z - 3) + 0.7 * (x * x - y * y) * z + 0.5 * x * y * z;
}

Eigen::VectorXd rho_of_section_3_on_vertices(const Mesh_view& mesh)
{
  Eigen::VectorXd rho(mesh.size_of_vertices());
  for (int v = 0; v < mesh.size_of_vertices(); ++v) rho[v] = rho_of_section_3(mesh.position(v));
  return rho;
}

Eigen::VectorXd rho_of_section_3_on_faces(const Mesh_view& mesh)
{
  Eigen::VectorXd rho(mesh.size_of_faces());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto& v = mesh.corners(f);
    rho[f] = rho_of_section_3(mesh.position(v[0]) + mesh.position(v[1]) + mesh.position(v[2]));
  }
  return rho;
}

}  // namespace cgp_test
