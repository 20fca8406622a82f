// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Spectral_pairs.h>

#include <Quaternionic_linear_algebra/dense/hermitian_eigen_decomposition.h>
#include <Quaternionic_linear_algebra/krylov/Krylov_space.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace Conformal_geometry_processing {

double internal::squared_error(const internal::Spectral_pairs& pairs, Eigen::Index count)
{
  const Eigen::Index n = (std::min)(count, pairs.size());
  const auto errors = pairs.energies.head(n).array() - pairs.quotients.head(n).array().square();
  return n == 0 ? 0. : (std::max)(errors.maxCoeff(), 0.);
}

double internal::needed_reach(const internal::Spectral_pairs& pairs, Eigen::Index count)
{
  const double last = pairs.quotients[count - 1];
  return last * last + 2 * squared_error(pairs, count);
}

double internal::complete_radius(const internal::Spectral_pairs& pairs, Eigen::Index count)
{
  Eigen::Index sure = 0;
  while (sure < (std::min)(count, pairs.size()) && is_window_complete(pairs, sure + 1)) ++sure;
  if (sure == 0) return 0;
  const double radius = std::sqrt(pairs.reach - 2 * squared_error(pairs, sure));
  return sure < pairs.size() ? (std::min)(radius, std::abs(pairs.quotients[sure])) : radius;
}

bool internal::is_window_complete(const internal::Spectral_pairs& pairs, Eigen::Index count)
{
  return count <= pairs.size() && needed_reach(pairs, count) <= pairs.reach;
}

internal::Spectral_pairs internal::resolved_nearest_first(const internal::Spectral_pairs& pairs)
{
  const Eigen::ArrayXd errors = pairs.energies.array() - pairs.quotients.array().square();
  double reach = pairs.reach;
  std::vector<Eigen::Index> order;
  for (Eigen::Index k = 0; k < pairs.size(); ++k)
    if (2 * std::abs(errors[k]) <= pairs.squared_images[k] ||
        pairs.squared_images[k] <= pairs.slow_energy)
      order.push_back(k);
    else
      reach = (std::min)(reach, pairs.energies[k]);
  std::stable_sort(order.begin(), order.end(), [&](Eigen::Index i, Eigen::Index j) {
    return std::abs(pairs.quotients[i]) < std::abs(pairs.quotients[j]);
  });
  return {pairs.quotients(order),
          pairs.energies(order),
          pairs.squared_images(order),
          pairs.of_pencil(order),
          pairs.residuals(order),
          pairs.vectors(Eigen::indexing::all, order),
          reach,
          pairs.slow_energy,
          reach < pairs.reach};
}

int internal::first_subspace_size(int count)
{
  return count + 2 * static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count)))) + 2;
}

int internal::next_subspace_size(int size, int most, const internal::Spectral_pairs& pairs,
                                 int count)
{
  const bool is_estimate = count <= pairs.size() && pairs.reach > 0;
  const double needed = is_estimate ? needed_reach(pairs, count) / pairs.reach : 2;
  const double growth = std::clamp(1.1 * needed, 1.25, 2.);
  return (std::min)(most, static_cast<int>(std::ceil(size * growth)));
}

int internal::largest_subspace_size(int count)
{
  return count + 128;
}

namespace internal {

/// of |N^-1 K v|^2, where |v| = 1 by M: mixtures lose nearly 1, all others some thousandths even on
/// coarse meshes
inline constexpr double lost_by_mixtures = 0.1;

/// A^H diag(d) A
Block<Quaternion<double>> congruent(const Block<Quaternion<double>>& A, const Vector<double>& d)
{
  Block<Quaternion<double>> scaled = A;
  for (Eigen::Index j = 0; j < A.cols(); ++j)
    for (Eigen::Index i = 0; i < A.rows(); ++i) scaled(i, j) *= d[i];
  return gram_matrix(A, scaled);
}

/// the eigenvectors of M x = theta N x, M-orthonormal instead of N-orthonormal
Block<Quaternion<double>> normalized_by_mass(const Krylov_result& square)
{
  Block<Quaternion<double>> v = square.vectors;
  for (Eigen::Index j = 0; j < v.cols(); ++j) scale_column(v, j, 1 / std::sqrt(square.values[j]));
  return v;
}

Vector<double> combined_residuals(const Block<Quaternion<double>>& coefficients,
                                  const Vector<double>& residuals)
{
  Vector<double> norms = Vector<double>::Zero(coefficients.cols());
  for (Eigen::Index j = 0; j < norms.size(); ++j)
    for (Eigen::Index i = 0; i < residuals.size(); ++i)
      norms[j] += squared_norm(coefficients(i, j)) * residuals[i] * residuals[i];
  return norms.cwiseSqrt();
}

/// K and the losses |N^-1 K v|^2 - |component of N^-1 K v in the span|^2, in a basis
struct Signed_projection {
  Block<Quaternion<double>> form, losses;
};

Signed_projection signed_projection(const Pencil& pencil, const Row_major_multivector& basis,
                                    const Block<Quaternion<double>>& v, const Vector<double>& theta)
{
  const Block<Quaternion<double>> Kv = pencil.K(v);
  Row_major_multivector images(v.rows(), v.cols());
  images.append(Kv);
  Signed_projection p{basis.gram(Kv, pencil.coefficients),
                      images.gram(pencil.solve(Kv), pencil.coefficients)};
  p.losses -= congruent(p.form, theta);
  return p;
}

/// the coefficients of the vectors that lose nothing, and those of the others
std::array<Block<Quaternion<double>>, 2> split_by_losses(const Block<Quaternion<double>>& losses)
{
  const auto pairs = hermitian_eigen_decomposition(losses);
  const Eigen::Index kept = (pairs.values.array() < lost_by_mixtures).count();
  return {pairs.vectors.leftCols(kept), pairs.vectors.rightCols(pairs.values.size() - kept)};
}

/// the least Rayleigh quotient of diag(values)
double least_value(const Block<Quaternion<double>>& vectors, const Vector<double>& values)
{
  if (vectors.cols() == 0) return std::numeric_limits<double>::infinity();
  return hermitian_eigen_decomposition(congruent(vectors, values)).values[0];
}

/// \brief of sqrt(mu_i mu_j), which bounds |<v_i, K v_j>|: what N has mixed exceeds this share,
/// also where discretisation errors tell the squares of s + g and s - g apart by a large factor.
/// The error of K between vectors that N has not mixed is far below it.
inline constexpr double coupling_of_mixtures = 0.25;

bool may_be_mixed(double mu, double other, const Quaternion<double>& coupling)
{
  const bool are_close = mu <= 2 * other && other <= 2 * mu;
  return are_close || norm(coupling) > coupling_of_mixtures * std::sqrt(mu * other);
}

/// \brief S without the entries between vectors that N has not mixed: equal quotients of some that
/// the mesh resolves and others that it does not would.
Block<Quaternion<double>> between_mixtures(Block<Quaternion<double>> S, const Vector<double>& mu)
{
  for (Eigen::Index j = 0; j < S.cols(); ++j)
    for (Eigen::Index i = 0; i < S.rows(); ++i)
      if (!may_be_mixed(mu[i], mu[j], S(i, j))) S(i, j) = {};
  return S;
}

}  // namespace internal

internal::Signed_eigenvectors signed_eigenvectors(const internal::Pencil& form,
                                                  const internal::Krylov_result& square)
{
  using Vectors = Block<Quaternion<double>>;
  const Vectors v = internal::normalized_by_mass(square);
  internal::Row_major_multivector basis(v.rows(), v.cols());
  basis.append(v);
  const auto projection = internal::signed_projection(form, basis, v, square.values);
  const auto [pure, mixtures] = internal::split_by_losses(projection.losses);
  const Vector<double> mu = square.values.cwiseInverse();
  const Vectors S = internal::between_mixtures(projection.form, mu);
  const auto ritz = hermitian_eigen_decomposition(gram_matrix(pure, combination(S, pure)));
  const Vectors coefficients = combination(pure, ritz.vectors);
  return {basis.combination(coefficients),
          internal::combined_residuals(coefficients, square.residuals),
          (std::min)(mu.maxCoeff(), internal::least_value(mixtures, mu))};
}

}  // namespace Conformal_geometry_processing
