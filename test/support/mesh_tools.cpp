// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "support/mesh_tools.h"

namespace cgp_test {

Points points(const std::vector<std::array<double, 3>>& list)
{
  Points p(3, static_cast<Eigen::Index>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i)
    p.col(static_cast<Eigen::Index>(i)) << list[i][0], list[i][1], list[i][2];
  return p;
}

Mesh_view scaled(const Mesh_view& mesh, double factor)
{
  return {factor * mesh.positions(), mesh.corners()};
}

double area(const Mesh_view& mesh)
{
  double sum = 0;
  for (const auto& v : mesh.corners()) {
    const Eigen::Vector3d a = mesh.position(v[1]) - mesh.position(v[0]);
    const Eigen::Vector3d b = mesh.position(v[2]) - mesh.position(v[0]);
    sum += a.cross(b).norm() / 2;
  }
  return sum;
}

Mesh_view scaled_to_area(const Mesh_view& mesh, double wanted)
{
  return scaled(mesh, std::sqrt(wanted / area(mesh)));
}

Mesh_view with_reversed_faces(const Mesh_view& mesh)
{
  Corners corners = mesh.corners();
  for (auto& v : corners) std::swap(v[1], v[2]);
  return {mesh.positions(), std::move(corners)};
}

Mesh_view renumbered(const Mesh_view& mesh, const std::vector<int>& new_number)
{
  Points p(3, mesh.size_of_vertices());
  for (int v = 0; v < mesh.size_of_vertices(); ++v) p.col(new_number[at(v)]) = mesh.position(v);
  Corners corners = mesh.corners();
  for (auto& face : corners)
    for (int& v : face) v = new_number[at(v)];
  return {std::move(p), std::move(corners)};
}

Mesh_view disjoint_union(const Mesh_view& a, const Mesh_view& b, const Eigen::Vector3d& offset)
{
  const int n = a.size_of_vertices();
  Points p(3, n + b.size_of_vertices());
  p << a.positions(), b.positions().colwise() + offset;
  Corners corners = a.corners();
  for (const auto& v : b.corners()) corners.push_back({v[0] + n, v[1] + n, v[2] + n});
  return {std::move(p), std::move(corners)};
}

Mesh_view without_face(const Mesh_view& mesh, int f)
{
  Corners corners = mesh.corners();
  corners.erase(corners.begin() + f);
  return {mesh.positions(), std::move(corners)};
}

Mesh_view subdivided(const Mesh_view& mesh)
{
  const int n = mesh.size_of_vertices();
  Points p(3, n + mesh.size_of_edges());
  p.leftCols(n) = mesh.positions();
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    p.col(n + k) = (mesh.position(mesh.ends(k)[0]) + mesh.position(mesh.ends(k)[1])) / 2;
  Corners corners;
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto& v = mesh.corners(f);
    const int a = n + mesh.edge(3 * f), b = n + mesh.edge(3 * f + 1), c = n + mesh.edge(3 * f + 2);
    corners.insert(corners.end(), {{v[0], c, b}, {v[1], a, c}, {v[2], b, a}, {a, b, c}});
  }
  return {std::move(p), std::move(corners)};
}

double slope(const std::vector<double>& h, const std::vector<double>& error)
{
  const auto n = static_cast<Eigen::Index>(h.size());
  Eigen::ArrayXd x = Eigen::ArrayXd::Map(h.data(), n).log();
  Eigen::ArrayXd y = Eigen::ArrayXd::Map(error.data(), n).abs().log();
  x -= x.mean();
  y -= y.mean();
  return (x * y).sum() / (x * x).sum();
}

}  // namespace cgp_test
