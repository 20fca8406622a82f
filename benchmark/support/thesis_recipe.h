// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <Eigen/CholmodSupport>
#include <Eigen/SparseCore>

#include <stdexcept>
#include <vector>

/// \brief A spin transformation as described in the thesis [CGP 5.5, 5.6, 6.6], implemented
/// carefully with the libraries it names: the baseline of the comparison.
///
/// Every quaternion is a real 4 x 4 block; the matrix X is assembled from triplets face by face
/// (Listing 6.1), with its lower triangle only, as required by CHOLMOD; `CholmodSupernodalLLT`
/// orders, analyzes and factors it with default options; three steps of the inverse power method
/// from lambda = 1 (Algorithm 1); then the scalar Poisson problem by the same means, with the three
/// coordinates at once. Nothing is checked or certified.
namespace cgp_benchmark {

namespace CGP = Conformal_geometry_processing;
using Sparse_matrix = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

/// the lower triangle of X as a real matrix of size 4 |V|, plus shift * (masses on the diagonal)
inline Sparse_matrix real_dirac_energy(const CGP::Mesh_view& mesh,
                                       const CGP::Curvature_potential& rho, double shift)
{
  using Quaternion = CGP::Quaternion<double>;
  Triplets triplets;
  triplets.reserve(60 * static_cast<std::size_t>(mesh.size_of_faces()));
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto& v = mesh.corners(f);
    const double A = mesh.double_area_vector(f).norm() / 2;
    const double a = -1 / (4 * A), b = rho.values[f] / 6, c = A * rho.values[f] * rho.values[f] / 9;
    Quaternion e[3];
    for (int i = 0; i < 3; ++i)
      e[i] = CGP::imaginary(mesh.position(v[(i + 2) % 3]) - mesh.position(v[(i + 1) % 3]));
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        if (v[i] < v[j]) continue;
        Quaternion x = a * (e[i] * e[j]) + b * (e[j] - e[i]);
        x.w += c + (i == j ? shift * A / 3 : 0);
        const Eigen::Matrix4d block = CGP::real_block(x);
        for (int q = 0; q < 4; ++q)
          for (int p = i == j ? q : 0; p < (i == j ? q + 1 : 4); ++p)
            triplets.emplace_back(4 * v[i] + p, 4 * v[j] + q, block(p, q));
      }
  }
  Sparse_matrix X(4 * mesh.size_of_vertices(), 4 * mesh.size_of_vertices());
  X.setFromTriplets(triplets.begin(), triplets.end());
  return X;
}

/// the lower triangle of the cotan Laplacian, vertex 0 fixed
inline Sparse_matrix real_laplacian(const CGP::Mesh_view& mesh)
{
  Triplets triplets{{0, 0, 1.}};
  triplets.reserve(9 * static_cast<std::size_t>(mesh.size_of_faces()));
  for (int h = 0; h < mesh.size_of_halfedges(); ++h) {
    const double w = CGP::cotangent(mesh, h) / 2;
    const int i = std::max(mesh.from(h), mesh.to(h)), j = std::min(mesh.from(h), mesh.to(h));
    triplets.emplace_back(i, i, w);
    if (j == 0) continue;
    triplets.emplace_back(j, j, w);
    triplets.emplace_back(i, j, -w);
  }
  Sparse_matrix L(mesh.size_of_vertices(), mesh.size_of_vertices());
  L.setFromTriplets(triplets.begin(), triplets.end());
  return L;
}

class Thesis_solver {
 public:
  explicit Thesis_solver(const Sparse_matrix& A) : m_llt(A)
  {
    if (m_llt.info() != Eigen::Success) throw std::runtime_error("CHOLMOD: no factorization");
  }

  Eigen::MatrixXd operator()(const Eigen::MatrixXd& b) const { return m_llt.solve(b); }

 private:
  Eigen::CholmodSupernodalLLT<Sparse_matrix, Eigen::Lower> m_llt;
};

/// lambda, not normalised
/// \param shift of X relative to its low eigenvalues: that rounding does not make X indefinite
inline CGP::Quaternion_vector<double> thesis_lambda(const CGP::Mesh_view& mesh,
                                                    const CGP::Curvature_potential& rho,
                                                    int iterations, double shift)
{
  const Eigen::VectorXd areas = CGP::vertex_areas(mesh);
  const double unit = 4 * std::acos(-1.) / areas.sum();
  const Thesis_solver solve(real_dirac_energy(mesh, rho, shift * unit));
  Eigen::MatrixXd x = Eigen::MatrixXd::Zero(4 * areas.size(), 1);
  for (Eigen::Index v = 0; v < areas.size(); ++v) x(4 * v, 0) = 1;
  for (int k = 0; k < iterations; ++k) {
    for (Eigen::Index i = 0; i < x.rows(); ++i) x(i, 0) *= areas[i / 4];
    x = solve(x);
    x.normalize();
  }
  CGP::Quaternion_vector<double> lambda(areas.size());
  for (Eigen::Index v = 0; v < areas.size(); ++v)
    lambda[v] = {x(4 * v, 0), x(4 * v + 1, 0), x(4 * v + 2, 0), x(4 * v + 3, 0)};
  return lambda;
}

/// \param rho on faces
inline CGP::Points thesis_recipe(const CGP::Mesh_view& mesh, const CGP::Curvature_potential& rho,
                                 int iterations = 3, double shift = 1e-8)
{
  const auto lambda = thesis_lambda(mesh, rho, iterations, shift);
  Eigen::MatrixXd b =
      CGP::codifferential(mesh, CGP::cotan_weights(mesh), CGP::transformed_edges(mesh, lambda));
  b.row(0).setZero();
  return Thesis_solver(real_laplacian(mesh))(b).transpose();
}

}  // namespace cgp_benchmark
