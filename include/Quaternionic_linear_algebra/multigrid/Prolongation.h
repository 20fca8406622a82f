// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

/// \ingroup PkgLinearAlgebra
/// \brief An undirected graph with positive weights: every edge is in the lists of both its ends.
struct Connection_graph {
  std::vector<int> offsets;    ///< size() + 1 positions in `neighbors`
  std::vector<int> neighbors;  ///< ascending for each vertex
  std::vector<float> weights;  ///< parallel to `neighbors`

  int size() const { return static_cast<int>(offsets.size()) - 1; }
  int begin(int i) const { return offsets[static_cast<std::size_t>(i)]; }
  int end(int i) const { return offsets[static_cast<std::size_t>(i) + 1]; }
  int neighbor(int k) const { return neighbors[static_cast<std::size_t>(k)]; }
  float weight(int k) const { return weights[static_cast<std::size_t>(k)]; }
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Finds the strongly connected pairs of rows: i and j are connected, with weight
/// w = -Re A_ij, if w > threshold sqrt(A_ii A_jj).
///
/// If the real part of A is approximately a Laplacian, errors that smoothing cannot reduce vary
/// slowly along these connections. Positive entries (opposite obtuse angles) are ignored.
/// \pre the diagonal of A is positive
template <class Scalar>
internal::Connection_graph strong_connections(const Hermitian_sparse_matrix<Scalar>& A,
                                              double threshold)
{
  const auto for_each_connection = [&](auto visit) {
    A.for_each_entry([&](int i, int j, const Scalar& a) {
      if (i == j) return;
      const double w = -static_cast<double>(internal::Scalar_traits<Scalar>::real(a));
      const double d = static_cast<double>(A.diagonal(i)) * static_cast<double>(A.diagonal(j));
      if (w > 0 && w * w > threshold * threshold * d) visit(i, j, static_cast<float>(w));
    });
  };
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  internal::Connection_graph g;
  g.offsets.assign(at(A.size()) + 1, 0);
  for_each_connection([&](int i, int j, float) { ++g.offsets[at(i) + 1], ++g.offsets[at(j) + 1]; });
  for (int i = 0; i < A.size(); ++i) g.offsets[at(i) + 1] += g.offsets[at(i)];
  g.neighbors.resize(at(g.offsets.back()));
  g.weights.resize(g.neighbors.size());
  std::vector<int> next(g.offsets.begin(), g.offsets.end() - 1);
  const auto add = [&](int i, int j, float w) {
    const std::size_t k = at(next[at(i)]++);
    g.neighbors[k] = j;
    g.weights[k] = w;
  };
  for_each_connection([&](int i, int j, float w) { add(i, j, w), add(j, i, w); });
  return g;
}

namespace internal {

/// \ingroup PkgLinearAlgebra
/// \brief A partition of the vertices of a graph into connected groups.
struct Aggregation {
  std::vector<int> aggregate_of;  ///< per vertex; -1 for isolated vertices
  int size = 0;                   ///< number of aggregates
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Groups vertices with their neighborhoods: about nine vertices each on a triangle mesh.
///
/// Vertices with free neighborhoods become centres, in the order of their numbers; each remaining
/// vertex joins the neighborhood with the strongest connection (one exists, because otherwise the
/// vertex would be a centre). Every aggregate has at least two vertices. Linear time.
internal::Aggregation aggregate(const internal::Connection_graph& graph);

namespace internal {

/// \ingroup PkgLinearAlgebra
/// \brief A sparse real matrix P, row by row, that interpolates vectors from a coarse to a fine
/// level; its transpose restricts residuals.
struct Prolongation {
  std::vector<int> offsets;    ///< number of fine vertices + 1
  std::vector<int> columns;    ///< coarse vertices
  std::vector<float> weights;  ///< parallel to `columns`
  int coarse_size = 0;

  int fine_size() const { return static_cast<int>(offsets.size()) - 1; }
  std::size_t bytes() const;

  /// Calls visit(I, P_iI) for the entries of row i
  template <class Visitor>
  void for_each_in_row(int i, Visitor visit) const
  {
    const std::size_t begin = static_cast<std::size_t>(offsets[static_cast<std::size_t>(i)]);
    const std::size_t end = static_cast<std::size_t>(offsets[static_cast<std::size_t>(i) + 1]);
    for (std::size_t k = begin; k < end; ++k) visit(columns[k], weights[k]);
  }
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Computes a prolongation that is piecewise constant on the aggregates, smoothed by one
/// step of weighted Jacobi along the connections: row i is
/// (1 - omega) e(i) + omega sum_j w_ij e(j) / sum_j w_ij, with e(j) the unit vector of the
/// aggregate of j.
///
/// Rows have no negative entries and sum to one, so constants are reproduced exactly; rows of
/// vertices without connections are empty, because smoothing solves for these.
internal::Prolongation smoothed_prolongation(const internal::Connection_graph& graph,
                                             const internal::Aggregation& a, double omega);

namespace internal {

/// Entries (row, column, value), row by row, columns in any order
template <class Scalar>
struct Sparse_rows {
  std::vector<int> offsets, columns;
  std::vector<Scalar> values;

  explicit Sparse_rows(int size) : offsets(static_cast<std::size_t>(size) + 1, 0) {}
  int size() const { return static_cast<int>(offsets.size()) - 1; }

  template <class Visitor>
  void for_each_entry(Visitor visit) const
  {
    for (int i = 0; i < size(); ++i)
      for (int k = offsets[static_cast<std::size_t>(i)];
           k < offsets[static_cast<std::size_t>(i) + 1]; ++k)
        visit(i, columns[static_cast<std::size_t>(k)], values[static_cast<std::size_t>(k)]);
  }

  /// Allocates the entries that were counted in offsets[row + 1]; returns the begin of each row
  std::vector<int> allocate()
  {
    for (std::size_t i = 1; i < offsets.size(); ++i) offsets[i] += offsets[i - 1];
    columns.resize(static_cast<std::size_t>(offsets.back()));
    values.resize(columns.size());
    return {offsets.begin(), offsets.end() - 1};
  }
};

/// Returns P^T, row by row
Sparse_rows<float> transpose(const Prolongation& P);

/// Returns P^T (D / 2 + U) P, where D is the diagonal and U the strictly upper triangle of A
template <class Scalar>
Sparse_rows<Scalar> half_galerkin_product(const Hermitian_sparse_matrix<Scalar>& A,
                                          const Prolongation& P)
{
  using FT = typename Scalar_traits<Scalar>::FT;
  const Sparse_rows<float> R = transpose(P);
  const Sparse_pattern& pattern = A.pattern();
  Sparse_rows<Scalar> S(P.coarse_size);
  std::vector<int> place(static_cast<std::size_t>(P.coarse_size), -1);
  int row = 0;
  const auto add = [&](int c, FT weight, const Scalar& a) {
    int& k = place[static_cast<std::size_t>(c)];
    if (k < row) {
      k = static_cast<int>(S.columns.size());
      S.columns.push_back(c);
      S.values.push_back(Scalar{});
    }
    S.values[static_cast<std::size_t>(k)] += weight * a;
  };
  for (int c = 0; c < P.coarse_size; ++c) {
    for (int q = R.offsets[static_cast<std::size_t>(c)];
         q < R.offsets[static_cast<std::size_t>(c) + 1]; ++q) {
      const int j = R.columns[static_cast<std::size_t>(q)];
      const FT weight = static_cast<FT>(R.values[static_cast<std::size_t>(q)]);
      const int diagonal = pattern.offsets[static_cast<std::size_t>(j)];
      for (int k = diagonal; k < pattern.offsets[static_cast<std::size_t>(j) + 1]; ++k) {
        const Scalar a = (k == diagonal ? weight / 2 : weight) * conjugate(A.value(k));
        P.for_each_in_row(pattern.indices[static_cast<std::size_t>(k)],
                          [&](int d, float w) { add(d, static_cast<FT>(w), a); });
      }
    }
    row = static_cast<int>(S.columns.size());
    S.offsets[static_cast<std::size_t>(c) + 1] = row;
  }
  return S;
}

/// Returns the lower triangle of S + S^H, column by column; entries may occur twice in succession
template <class Scalar>
Sparse_rows<Scalar> folded_to_lower_triangle(const Sparse_rows<Scalar>& S)
{
  Sparse_rows<Scalar> by_row(S.size()), by_column(S.size());
  S.for_each_entry([&](int i, int j, const Scalar&) {
    ++by_row.offsets[static_cast<std::size_t>((std::max)(i, j)) + 1];
    ++by_column.offsets[static_cast<std::size_t>((std::min)(i, j)) + 1];
  });
  // Sorting by rows, then stably by columns, makes the rows of every column ascend.
  std::vector<int> next = by_row.allocate();
  S.for_each_entry([&](int i, int j, const Scalar& s) {
    const std::size_t k =
        static_cast<std::size_t>(next[static_cast<std::size_t>((std::max)(i, j))]++);
    by_row.columns[k] = (std::min)(i, j);
    by_row.values[k] = i > j ? s : i < j ? conjugate(s) : s + conjugate(s);
  });
  next = by_column.allocate();
  by_row.for_each_entry([&](int i, int j, const Scalar& s) {
    const std::size_t k = static_cast<std::size_t>(next[static_cast<std::size_t>(j)]++);
    by_column.columns[k] = i;
    by_column.values[k] = s;
  });
  return by_column;
}

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Computes the Galerkin matrix P^T A P of the coarse level, with its own pattern.
///
/// Hermitian with a real diagonal, and positive definite if A is and P has full rank. Uses only
/// counting sorts; costs about ten multiplications of an entry by a number per entry of A on a
/// triangle mesh.
/// \pre every column of P has an entry
template <class Scalar>
Hermitian_sparse_matrix<Scalar> galerkin_product(const Hermitian_sparse_matrix<Scalar>& A,
                                                 const internal::Prolongation& P)
{
  const internal::Sparse_rows<Scalar> folded =
      internal::folded_to_lower_triangle(internal::half_galerkin_product(A, P));
  Sparse_pattern pattern;
  pattern.offsets.push_back(0);
  int last_column = -1;
  folded.for_each_entry([&](int j, int i, const Scalar&) {
    if (j != last_column || i != pattern.indices.back()) pattern.indices.push_back(i);
    last_column = j;
    pattern.offsets.resize(static_cast<std::size_t>(j) + 2);
    pattern.offsets.back() = static_cast<int>(pattern.indices.size());
  });
  Hermitian_sparse_matrix<Scalar> C(std::make_shared<const Sparse_pattern>(std::move(pattern)));
  int k = -1, last_row = -1;
  last_column = -1;
  folded.for_each_entry([&](int j, int i, const Scalar& s) {
    if (j != last_column || i != last_row) ++k;
    last_column = j, last_row = i;
    C.value(k) += s;
  });
  return C;
}

}  // namespace Conformal_geometry_processing
