// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Prescribed_positions.h>

#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Prescribed_directions.h>
#include <Quaternionic_linear_algebra/algebra/rotor.h>

#include <Eigen/LU>

#include <cmath>

namespace Conformal_geometry_processing {

Eigen::VectorXd internal::Prescribed_positions::weights(double weight) const
{
  if (std::isinf(weight)) return {};
  const double radius = std::sqrt(face_areas(m_surface).sum() / std::acos(-1.));
  Eigen::VectorXd w = Eigen::VectorXd::Zero(m_surface.size_of_vertices());
  for (const std::vector<int>& loop : m_frames.loops)
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const int i = loop[k], j = loop[(k + 1) % loop.size()];
      const double length = (m_surface.position(j) - m_surface.position(i)).norm();
      for (const int v : {i, j}) w[v] += weight / radius * length / 2;
    }
  return w;
}

Block<Quaternion<double>> internal::Prescribed_positions::given_spins() const
{
  const auto loops = static_cast<Eigen::Index>(m_frames.loops.size());
  Block<Quaternion<double>> values =
      Block<Quaternion<double>>::Constant(m_surface.size_of_vertices(), loops, {});
  std::size_t k = 0;
  for (Eigen::Index l = 0; l < loops; ++l)
    for (const int v : m_frames.loops[static_cast<std::size_t>(l)]) values(v, l) = m_spins[k++];
  return values;
}

Eigen::VectorXd internal::Prescribed_positions::signs(const Eigen::MatrixXd& S)
{
  Eigen::VectorXd signs = Eigen::VectorXd::Zero(S.cols());
  signs[0] = 1;
  for (Eigen::Index k = 1; k < S.cols(); ++k) {
    const Eigen::VectorXd slopes = S * signs;
    Eigen::Index next = -1;
    for (Eigen::Index l = 1; l < S.cols(); ++l)
      if (signs[l] == 0 && (next < 0 || std::abs(slopes[l]) > std::abs(slopes[next]))) next = l;
    signs[next] = slopes[next] > 0 ? -1 : 1;
  }
  return signs;
}

Quaternion_vector<double> internal::Prescribed_positions::spins(
    const Hermitian_sparse_matrix<Quaternion<double>>& X)
{
  const Block<Quaternion<double>> given = given_spins();
  const Eigen::Index loops = given.cols();
  const Block<Quaternion<double>> zero =
      Block<Quaternion<double>>::Constant(given.rows(), loops, {});
  const Block<Quaternion<double>> of_loops = m_lambda.solve(X, zero, given);
  Eigen::MatrixXd energy(loops, loops);
  for (Eigen::Index l = 0; l < loops; ++l) {
    const Quaternion_vector<double> force = X * Quaternion_vector<double>(of_loops.col(l));
    for (Eigen::Index k = 0; k < loops; ++k) energy(k, l) = inner_product(given.col(k), force).w;
  }
  const Eigen::VectorXd s = signs(energy);
  Quaternion_vector<double> lambda = Quaternion_vector<double>::Constant(given.rows(), {});
  auto spin = m_spins.begin();
  for (Eigen::Index l = 0; l < loops; ++l) {
    add_multiple(lambda, of_loops.col(l), Quaternion<double>{s[l], 0, 0, 0});
    const auto end =
        spin + static_cast<std::ptrdiff_t>(m_frames.loops[static_cast<std::size_t>(l)].size());
    for (; spin != end; ++spin) *spin *= s[l];
  }
  return lambda;
}

double internal::Prescribed_positions::residual(
    const Hermitian_sparse_matrix<Quaternion<double>>& X,
    const Quaternion_vector<double>& lambda) const
{
  const bool is_exact = m_weights.size() == 0;
  Quaternion_vector<double> given = Quaternion_vector<double>::Constant(lambda.size(), {});
  for (std::size_t k = 0; k < m_spins.size(); ++k) given[m_frames.vertices[k]] = m_spins[k];
  Quaternion_vector<double> r = X * lambda, b = X * given;
  double left = 0, all = 0;
  for (Eigen::Index i = 0; i < lambda.size(); ++i) {
    if (is_exact && m_lambda.is_given(static_cast<int>(i))) continue;
    if (!is_exact) {
      r[i] += m_weights[i] * (lambda[i] - given[i]);
      b[i] = m_weights[i] * given[i];
    }
    left += squared_norm(r[i]);
    all += squared_norm(b[i]);
  }
  return all > 0 ? std::sqrt(left / all) : 0;
}

Eigen::VectorXd internal::Prescribed_positions::errors(const Points& f) const
{
  Eigen::VectorXd distances(m_targets.cols());
  for (Eigen::Index k = 0; k < distances.size(); ++k)
    distances[k] =
        (f.col(m_frames.vertices[static_cast<std::size_t>(k)]) - m_targets.col(k)).norm();
  return distances;
}

Points internal::Prescribed_positions::positions(const Eigen::MatrixX3d& edges)
{
  const Eigen::VectorXd weights = cotan_weights(m_surface);
  const auto L = cotan_laplacian(m_surface);
  factorize(m_positions, L);
  Block<double> values = Block<double>::Zero(m_surface.size_of_vertices(), 3);
  for (std::size_t k = 0; k < m_frames.vertices.size(); ++k)
    values.row(m_frames.vertices[k]) = m_targets.col(static_cast<Eigen::Index>(k)).transpose();
  return m_positions.solve(L, codifferential(m_surface, weights, edges), values).transpose();
}

std::vector<Quaternion<double>> internal::Prescribed_positions::spins(
    const Boundary_condition& condition, const std::string& function) const
{
  std::vector<Quaternion<double>> spins;
  std::size_t first = 0;
  for (const std::vector<int>& loop : m_frames.loops) {
    for (std::size_t k = 0; k < loop.size(); ++k)
      spins.push_back(spin_at(condition, first, loop, k, function));
    first += loop.size();
  }
  const std::vector<char> closes = make_continuous(m_frames.loops, spins);
  for (std::size_t l = 0; l < closes.size(); ++l)
    if (!closes[l])
      throw Precondition_error(
          function, "the curve for the loop at vertex " +
                        std::to_string(m_frames.loops[l].front()) +
                        " is twisted by a full turn against it; no continuous spins do that");
  return spins;
}

Quaternion<double> internal::Prescribed_positions::spin_at(const Boundary_condition& condition,
                                                           std::size_t first,
                                                           const std::vector<int>& loop,
                                                           std::size_t k,
                                                           const std::string& function) const
{
  const std::size_t n = loop.size(), next = (k + 1) % n, previous = (k + n - 1) % n;
  const auto target = [&](std::size_t i) -> Eigen::Vector3d {
    return condition.targets.col(static_cast<Eigen::Index>(first + i));
  };
  const auto source = [&](std::size_t i) -> Eigen::Vector3d { return m_surface.position(loop[i]); };
  // The stretch at the vertex is the mean of the edges' weighted as in `circle_tangent()`.
  const double in = (source(k) - source(previous)).norm(), out = (source(next) - source(k)).norm();
  const double to_in = (target(k) - target(previous)).norm(),
               to_out = (target(next) - target(k)).norm();
  const bool has_edges = in > 0 && out > 0;
  const double stretch = has_edges ? (to_in / in * out + to_out / out * in) / (in + out)
                                   : (to_in + to_out) / (in + out);
  const internal::Boundary_frame frame =
      boundary_frame(circle_tangent(target(previous), target(k), target(next)),
                     condition.normals.col(static_cast<Eigen::Index>(first + k)));
  if (!(frame.determinant() > 0.5))
    throw Precondition_error(function, "the curve folds back, or has its normal along it, at " +
                                           internal::name_of_vertex(loop[k]));
  return boundary_spin(m_frames.frames[first + k], frame, stretch);
}

}  // namespace Conformal_geometry_processing
