// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>

#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Quaternionic_linear_algebra/dense/block_operators.h>
#include <Quaternionic_linear_algebra/threads/Thread_team.h>

#include <cmath>
#include <cstddef>

namespace Conformal_geometry_processing {

Eigen::Vector3d transformed_edge(const Eigen::Vector3d& e, const Quaternion<double>& l_i,
                                 const Quaternion<double>& l_j)
{
  // The two mixed terms are minus conjugates of each other: their sum is twice Im(mixed).
  const Quaternion<double> mixed = conjugate(l_i) * imaginary(e) * l_j;
  return (spin(l_i, e) + imaginary_part(mixed) + spin(l_j, e)) / 3;
}

Eigen::MatrixX3d transformed_edges(const Surface_ref& surface,
                                   const Quaternion_vector<double>& lambda)
{
  Eigen::MatrixX3d edges(surface.size_of_edges(), 3);
  internal::for_each_index(surface.size_of_edges(), 1024, [&](int k) {
    const auto [i, j] = surface.ends(k);
    const Eigen::Vector3d e = surface.position(j) - surface.position(i);
    edges.row(k) = transformed_edge(e, lambda[i], lambda[j]).transpose();
  });
  return edges;
}

double internal::closure_residual(const Surface_ref& surface, const Eigen::VectorXd& weights,
                                  const Points& f, const Eigen::MatrixX3d& edges,
                                  const Surface_part& part)
{
  Eigen::Vector2d sums(0, 0);
  for (int k = 0; k < surface.size_of_edges(); ++k) {
    if (!part.counts(k)) continue;
    const Eigen::Vector3d e = edges.row(k);
    const Eigen::Vector3d d = f.col(surface.ends(k)[1]) - f.col(surface.ends(k)[0]);
    sums += std::abs(weights[k]) * Eigen::Vector2d((d - e).squaredNorm(), e.squaredNorm());
  }
  sums = part.sum(sums);
  return std::sqrt(sums[0] / sums[1]);
}

namespace internal {

// e~ = (l_i^ e l_i + Im(l_i^ e l_j) + l_j^ e l_j) / 3 with l^ = conjugate(l). The changes of the
// outer terms are 2 Im(l^ e dl).
Eigen::MatrixX3d edge_change(const Surface_ref& surface, const Quaternion_vector<double>& lambda,
                             const Quaternion_vector<double>& dlambda)
{
  Eigen::MatrixX3d change(surface.size_of_edges(), 3);
  for (int k = 0; k < surface.size_of_edges(); ++k) {
    const auto [i, j] = surface.ends(k);
    const Quaternion<double> e =
        imaginary(Eigen::Vector3d(surface.position(j) - surface.position(i)));
    const Quaternion<double> at_i = conjugate(2. * lambda[i] + lambda[j]) * e * dlambda[i];
    const Quaternion<double> at_j = conjugate(lambda[i] + 2. * lambda[j]) * e * dlambda[j];
    change.row(k) = imaginary_part(at_i + at_j).transpose() / 3;
  }
  return change;
}

// <y, Im(a^ e dl)> = Re(conjugate(-e a y) dl) for imaginary e and y.
Block<Quaternion<double>> edge_gradients(const Surface_ref& surface,
                                         const Quaternion_vector<double>& lambda,
                                         const Eigen::MatrixXd& a)
{
  Block<Quaternion<double>> V = Block<Quaternion<double>>::Constant(lambda.size(), a.cols(), {});
  for (int k = 0; k < surface.size_of_edges(); ++k) {
    const auto [i, j] = surface.ends(k);
    const Quaternion<double> e =
        imaginary(Eigen::Vector3d((surface.position(j) - surface.position(i)) / -3));
    const Quaternion<double> at_i = e * (2. * lambda[i] + lambda[j]),
                             at_j = e * (lambda[i] + 2. * lambda[j]);
    for (Eigen::Index c = 0; c < a.cols(); ++c) {
      V(i, c) += a(k, c) * at_i;
      V(j, c) += a(k, c) * at_j;
    }
  }
  return V;
}

Quaternion_vector<double> edge_gradient(const Surface_ref& surface,
                                        const Quaternion_vector<double>& lambda,
                                        const Eigen::MatrixX3d& y)
{
  Block<Quaternion<double>> axes(3, 1);
  for (int axis = 0; axis < 3; ++axis) axes(axis, 0) = imaginary(Eigen::Vector3d::Unit(axis));
  return combination(edge_gradients(surface, lambda, y), axes).col(0);
}

}  // namespace internal

Curvature_potential curvature_of_spins(const Surface_ref& surface,
                                       const Quaternion_vector<double>& mu)
{
  Eigen::VectorXd products = Eigen::VectorXd::Zero(surface.size_of_faces()), squares = products,
                  areas = products;
  for (int s = 0; s < surface.size_of_sheets(); ++s) {
    const Sheet sheet = surface.sheet(s);
    Quaternion<double> average, image;  // B mu, and M D mu
    for (int c = 0; c < 3; ++c) {
      const auto& l = mu[sheet.corners[static_cast<std::size_t>(c)]];
      const Eigen::Vector3d e = sheet.vectors.col(c) / 2;
      average += l / 3.;
      image -= imaginary(e) * l;
    }
    products[sheet.face] += sheet.share * dot(average, image);
    areas[sheet.face] += sheet.share * sheet.area;
    squares[sheet.face] += sheet.share * sheet.area * squared_norm(average);
  }
  return Curvature_potential::on_faces((squares.array() > 0 && areas.array() > 1e-6 * areas.mean())
                                           .select(products.cwiseQuotient(squares), 0));
}

Poisson_reconstruction::Poisson_reconstruction(const Surface_ref& surface,
                                               std::shared_ptr<const Sparse_pattern> pattern,
                                               const Spin_solvers& solvers)
    : m_surface(surface), m_L(pattern), m_solver(std::move(pattern), solvers)
{
  update_geometry();
}

void Poisson_reconstruction::update_geometry()
{
  m_weights = cotan_weights(m_surface);
  assemble_cotan_laplacian(m_surface, m_weights, m_L);
  m_solver.factorize(m_L);
}

Points Poisson_reconstruction::positions(const Eigen::MatrixX3d& edges) const
{
  return m_solver.solve(codifferential(m_surface, m_weights, edges)).transpose();
}

Eigen::MatrixXd Poisson_reconstruction::edge_gradient(const Eigen::MatrixXd& y) const
{
  return m_weights.asDiagonal() * differential(m_surface, m_solver.solve(y));
}

double Poisson_reconstruction::residual(const Points& f, const Eigen::MatrixX3d& edges) const
{
  return internal::closure_residual(m_surface, m_weights, f, edges);
}

}  // namespace Conformal_geometry_processing
