// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/linear_algebra/multigrid/Prolongation.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

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
