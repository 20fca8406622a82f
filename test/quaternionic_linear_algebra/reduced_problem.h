// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Quaternionic_linear_algebra/algebra/Reduced_basis.h>

#include <Eigen/Core>

#include <algorithm>
#include <vector>

#include "quaternionic_linear_algebra/hermitian_matrices.h"
#include "support/bounded_meshes.h"
#include "support/decompositions.h"

/// Systems with unknowns in planes of H at some rows, and their dense counterparts.
namespace cgp_test {

using Plane = CGP::internal::Reduced_basis<double>::Plane;

/// two orthonormal quaternions for each of so many rows
inline std::vector<Plane> random_planes(std::size_t count, std::uint64_t seed)
{
  Random random(seed);
  std::vector<Plane> planes(count);
  for (auto& [u, v] : planes) {
    u = random.quaternion();
    u = u / norm(u);
    v = random.quaternion();
    v -= u * dot(u, v);
    v = v / norm(v);
    v -= u * dot(u, v);
    v = v / norm(v);
  }
  return planes;
}

/// X + shift reduced at given rows
struct Reduced_problem {
  CGP::Hermitian_sparse_matrix<Quaternion<double>> X;
  Eigen::VectorXd shift;
  std::vector<int> reduced;
  std::vector<Plane> planes;

  CGP::internal::Reduced_rows rows() const { return {X.size(), reduced}; }
  CGP::internal::Reduced_basis<double> basis() const { return {X.size(), reduced, planes}; }

  /// B, its columns in the order of the rows
  Eigen::MatrixXd dense_basis() const
  {
    const int n = X.size();
    Eigen::MatrixXd B(4 * n, 4 * n - 2 * static_cast<int>(reduced.size()));
    B.setZero();
    for (int i = 0, column = 0; i < n; ++i) {
      const auto place = std::find(reduced.begin(), reduced.end(), i);
      if (place == reduced.end()) {
        B.block<4, 4>(4 * i, column).setIdentity();
        column += 4;
      } else {
        for (const Quaternion<double>& q : planes[at(static_cast<int>(place - reduced.begin()))])
          B.block<4, 1>(4 * i, column++) << q.w, q.x, q.y, q.z;
      }
    }
    return B;
  }

  Eigen::MatrixXd dense_matrix() const
  {
    const Eigen::MatrixXd B = dense_basis();
    return B.transpose() * real_form(plus_diagonal(X, shift)) * B;
  }

  /// the solution for right-hand sides b, as components of quaternions
  Eigen::MatrixXd dense_solution(const CGP::Block<Quaternion<double>>& b) const
  {
    const Eigen::MatrixXd B = dense_basis();
    return B * definite_solution(dense_matrix(), B.transpose() * real_columns(b));
  }
};

/// the vertices of all boundary loops
inline std::vector<int> vertices_of_boundary(const Mesh_view& mesh)
{
  std::vector<int> vertices;
  for (const std::vector<int>& loop : CGP::boundary_loops(mesh))
    vertices.insert(vertices.end(), loop.begin(), loop.end());
  return vertices;
}

/// the Dirac energy of a surface, rho = x y + 1, with random planes at the boundary
inline Reduced_problem reduced_problem(const Mesh_view& mesh, std::uint64_t seed)
{
  Eigen::VectorXd rho(mesh.size_of_vertices());
  for (int i = 0; i < rho.size(); ++i) rho[i] = 1 + mesh.position(i).x() * mesh.position(i).y();
  const std::vector<int> boundary = vertices_of_boundary(mesh);
  return {CGP::dirac_energy(mesh, CGP::Curvature_potential::on_vertices(rho)),
          1e-3 * CGP::vertex_areas(mesh), boundary, random_planes(boundary.size(), seed)};
}

/// a random matrix on a pattern, reduced at the given rows
inline Reduced_problem reduced_problem(const Pattern& pattern, const std::vector<int>& reduced,
                                       std::uint64_t seed)
{
  return {random_definite<Quaternion<double>>(pattern, seed),
          random_numbers(pattern->size(), seed + 1).cwiseAbs(), reduced,
          random_planes(reduced.size(), seed + 2)};
}

}  // namespace cgp_test
