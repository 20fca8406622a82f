// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Prescribed_boundary.h>

#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>
#include <Quaternionic_linear_algebra/algebra/rotor.h>
#include <Quaternionic_linear_algebra/dense/hermitian_eigen_decomposition.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace Conformal_geometry_processing {

Quaternion<double> best_turn(const Points& U, const Points& V)
{
  const Quaternion<double> units[] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  Block<double> M = Block<double>::Zero(4, 4);  // of the mean of |U q - q V|^2, in [0, 4]
  for (Eigen::Index k = 0; k < U.cols(); ++k) {
    Quaternion<double> image[4];
    for (int c = 0; c < 4; ++c)
      image[c] = imaginary(U.col(k)) * units[c] - units[c] * imaginary(V.col(k));
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 4; ++r)
        M(r, c) += dot(image[r], image[c]) / static_cast<double>(U.cols());
  }
  const auto eigen = hermitian_eigen_decomposition<double>(M);
  const auto vector = [&](int c) -> Eigen::Vector4d { return eigen.vectors.col(c); };
  // If even the best rotation does not fit, those with up to three times its misfit count as
  // equally good: nearly parallel binormals of a hemisphere, to be tilted inward, do not require a
  // half turn.
  const double as_good = (std::max)(0.02, 2 * eigen.values[0]), nothing = 1e-3;
  Eigen::Vector4d best = Eigen::Vector4d::Zero();
  for (int c = 0; c < 4; ++c)
    if (eigen.values[c] <= eigen.values[0] + as_good) best += vector(c)[0] * vector(c);
  if (best.norm() < nothing) best = vector(0);
  best.normalize();
  return {best[0], best[1], best[2], best[3]};
}

namespace internal {

/// the unit quaternion at an angle in a plane
Quaternion<double> at_angle(const Boundary_plane& plane, double angle)
{
  return plane[0] * std::cos(angle) + plane[1] * std::sin(angle);
}

/// the angle that maps coordinates in one plane to those of the nearest points of another, averaged
/// over all points: a rotation, so that its sum over a loop does not depend on the start
double turn_between(const Boundary_plane& from, const Boundary_plane& to)
{
  const double cosine = dot(to[0], from[0]) + dot(to[1], from[1]);
  const double sine = dot(to[1], from[0]) - dot(to[0], from[1]);
  return std::atan2(sine, cosine);
}

/// the angle by which quaternions, one in each plane, have to turn to be nearest to q on the whole
double angle_to_nearest(const std::vector<Boundary_plane>& planes,
                        const std::vector<double>& angles, const Quaternion<double>& q)
{
  const double quarter = 1.57079632679489661923, nothing = 1e-6;
  double u = 0, v = 0;
  for (std::size_t k = 0; k < planes.size(); ++k) {
    u += dot(at_angle(planes[k], angles[k]), q);
    v += dot(at_angle(planes[k], angles[k] + quarter), q);
  }
  return std::hypot(u, v) > nothing * static_cast<double>(planes.size()) ? std::atan2(v, u) : 0;
}

}  // namespace internal

std::vector<Quaternion<double>> least_twist(
    const std::vector<internal::Reduced_basis<double>::Plane>& planes, const Quaternion<double>& q)
{
  const std::size_t n = planes.size();
  std::vector<double> angles;
  double angle = 0;
  for (std::size_t k = 0; k < n; ++k) {
    angles.push_back(angle);
    angle += internal::turn_between(planes[k], planes[(k + 1) % n]);
  }
  const double missing = -std::remainder(angle, 2 * std::acos(-1.));
  for (std::size_t k = 0; k < n; ++k)
    angles[k] += missing * static_cast<double>(k) / static_cast<double>(n);
  const double turn = internal::angle_to_nearest(planes, angles, q);
  std::vector<Quaternion<double>> section;
  for (std::size_t k = 0; k < n; ++k)
    section.push_back(internal::at_angle(planes[k], angles[k] + turn));
  return section;
}

internal::Reduced_basis<double>::Plane boundary_plane(const Eigen::Vector3d& U,
                                                      const Eigen::Vector3d& V,
                                                      const Eigen::Vector3d& axis)
{
  const double almost_antipodal = 1e-8;
  Quaternion<double> q = rotor(U, V);
  if ((U + V).norm() < almost_antipodal) q = imaginary((axis - axis.dot(U) * U).normalized());
  return {q, -(q * imaginary(V))};
}

std::vector<char> make_continuous(const std::vector<std::vector<int>>& loops,
                                  std::vector<Quaternion<double>>& values)
{
  std::vector<char> closes;
  std::size_t first = 0;
  for (const std::vector<int>& loop : loops) {
    const std::size_t end = first + loop.size();
    double sum = values[first].w;
    for (std::size_t k = first + 1; k < end; ++k) {
      if (dot(values[k], values[k - 1]) < 0) values[k] *= -1;
      sum += values[k].w;
    }
    closes.push_back(dot(values[end - 1], values[first]) >= 0);
    if (sum < 0)
      for (std::size_t k = first; k < end; ++k) values[k] *= -1;
    first = end;
  }
  return closes;
}

Quaternion<double> boundary_spin(const internal::Boundary_frame& source,
                                 const internal::Boundary_frame& target, double ratio)
{
  return spin_of(Eigen::Matrix3d(target * source.transpose()), ratio);
}

void internal::Prescribed_directions::update_geometry()
{
  m_frames = boundary_frames(m_surface);
  update();
}

Eigen::VectorXd internal::Prescribed_directions::errors(const Surface_ref& surface,
                                                        const Points& targets) const
{
  const internal::Boundary_frames frames = boundary_frames(surface);
  Eigen::VectorXd angles(targets.cols());
  for (Eigen::Index k = 0; k < angles.size(); ++k) {
    const Eigen::Vector3d U = frames.frames[static_cast<std::size_t>(k)] * m_coefficients;
    const Eigen::Vector3d V = targets.col(k);
    angles[k] = std::atan2(U.cross(V).norm(), U.dot(V));
  }
  return angles;
}

Points internal::Prescribed_directions::normalized(Points v)
{
  for (Eigen::Index k = 0; k < v.cols(); ++k) v.col(k) = stable_normalized(v.col(k));
  return v;
}

Points internal::Prescribed_directions::sources() const
{
  Points U(3, static_cast<Eigen::Index>(m_frames.frames.size()));
  for (std::size_t k = 0; k < m_frames.frames.size(); ++k)
    U.col(static_cast<Eigen::Index>(k)) = m_frames.frames[k] * m_coefficients;
  return U;
}

void internal::Prescribed_directions::update()
{
  const Points U = sources();
  if (!m_has_targets) m_targets = U;
  std::vector<internal::Reduced_basis<double>::Plane> planes;
  const Quaternion<double> turn = best_turn(U, m_targets);
  for (Eigen::Index k = 0; k < U.cols(); ++k) {
    const Eigen::Vector3d N = m_frames.normal(static_cast<std::size_t>(k));
    const internal::Reduced_basis<double>::Plane rest =
        boundary_plane(spin(turn, U.col(k)), m_targets.col(k), spin(turn, N));
    planes.push_back({turn * rest[0], turn * rest[1]});
  }
  std::vector<Quaternion<double>> rotors;
  auto first = planes.begin();
  for (const std::vector<int>& loop : m_frames.loops) {
    const auto end = first + static_cast<std::ptrdiff_t>(loop.size());
    const auto section = least_twist({first, end}, turn);
    rotors.insert(rotors.end(), section.begin(), section.end());
    first = end;
  }
  m_basis = Reduced_basis<double>(m_surface.size_of_vertices(), m_frames.vertices, planes);
  m_guide = m_basis.project(harmonic_extension(rotors)).col(0);
}

Block<Quaternion<double>> internal::Prescribed_directions::harmonic_extension(
    const std::vector<Quaternion<double>>& rotors)
{
  const Eigen::Index n = m_surface.size_of_vertices();
  Block<double> values = Block<double>::Zero(n, 4);
  for (std::size_t k = 0; k < rotors.size(); ++k)
    values.row(m_frames.vertices[k]) << rotors[k].w, rotors[k].x, rotors[k].y, rotors[k].z;
  assemble_cotan_laplacian(m_surface, cotan_weights(m_surface), m_L);
  m_harmonic.factorize(m_L);
  const Block<double> q = m_harmonic.solve(m_L, Block<double>::Zero(n, 4), values);
  Block<Quaternion<double>> extension(n, 1);
  for (Eigen::Index i = 0; i < n; ++i) extension(i, 0) = {q(i, 0), q(i, 1), q(i, 2), q(i, 3)};
  return extension;
}

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
