// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "quaternionic_linear_algebra/hermitian_matrices.h"

namespace cgp_test {

Pattern pattern_of_edges(int n, const std::vector<std::pair<int, int>>& edges)
{
  std::vector<std::vector<int>> columns(at(n));
  for (const auto& [i, j] : edges) columns[at(std::min(i, j))].push_back(std::max(i, j));
  return CGP::sparse_pattern(std::move(columns));
}

Pattern random_pattern(int n, std::uint64_t seed)
{
  Random random(seed);
  std::vector<std::pair<int, int>> edges;
  for (int i = 0; i < n; ++i) {
    edges.push_back({i, (i + 1) % n});
    edges.push_back({i, random.below(n)});
  }
  return pattern_of_edges(n, edges);
}

Pattern full_pattern(int n)
{
  std::vector<std::pair<int, int>> edges;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < i; ++j) edges.push_back({i, j});
  return pattern_of_edges(n, edges);
}

Pattern grid_pattern(int rows, int columns)
{
  std::vector<std::pair<int, int>> edges;
  for (int i = 0; i < rows * columns; ++i) {
    if (i % columns + 1 < columns) edges.push_back({i, i + 1});
    if (i + columns < rows * columns) edges.push_back({i, i + columns});
  }
  return pattern_of_edges(rows * columns, edges);
}

CGP::Hermitian_sparse_matrix<double> random_laplacian(const Pattern& pattern, std::uint64_t seed)
{
  Random random(seed);
  CGP::Hermitian_sparse_matrix<double> L(pattern);
  Eigen::VectorXd degrees = Eigen::VectorXd::Zero(L.size());
  for (int j = 0; j < L.size(); ++j)
    for (int k = pattern->offsets[at(j)] + 1; k < pattern->offsets[at(j) + 1]; ++k) {
      const double weight = 1.5 + random.number();
      L.value(k) = -weight;
      degrees[j] += weight;
      degrees[pattern->indices[at(k)]] += weight;
    }
  return plus_diagonal(L, degrees);
}

Eigen::MatrixXd real_form(const CGP::Block<double>& A)
{
  return A;
}

Eigen::MatrixXd real_form(const CGP::Block<std::complex<double>>& A)
{
  Eigen::MatrixXd D(2 * A.rows(), 2 * A.cols());
  for (Eigen::Index j = 0; j < A.cols(); ++j)
    for (Eigen::Index i = 0; i < A.rows(); ++i)
      D.block<2, 2>(2 * i, 2 * j) << A(i, j).real(), -A(i, j).imag(), A(i, j).imag(),
          A(i, j).real();
  return D;
}

Eigen::MatrixXd real_columns(const CGP::Block<double>& b)
{
  return b;
}

Eigen::MatrixXd real_columns(const CGP::Block<std::complex<double>>& b)
{
  return Eigen::Map<const Eigen::MatrixXd>(reinterpret_cast<const double*>(b.data()), 2 * b.rows(),
                                           b.cols());
}

Eigen::MatrixXd real_columns(const CGP::Block<Quaternion<double>>& b)
{
  return Eigen::Map<const Eigen::MatrixXd>(reinterpret_cast<const double*>(b.data()), 4 * b.rows(),
                                           b.cols());
}

Eigen::VectorXd four_times(const Eigen::VectorXd& m)
{
  Eigen::VectorXd d(4 * m.size());
  for (Eigen::Index i = 0; i < m.size(); ++i) d.segment<4>(4 * i).setConstant(m[i]);
  return d;
}

}  // namespace cgp_test
