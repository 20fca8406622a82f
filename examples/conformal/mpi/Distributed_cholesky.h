// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Border_vertices.h"
#include "collective.h"

#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/direct/Supernodal_cholesky.h>
#include <Quaternionic_linear_algebra/direct/Supernodal_factor.h>
#include <Quaternionic_linear_algebra/direct/Supernodal_substitution.h>
#include <Quaternionic_linear_algebra/direct/choose_ordering.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numeric>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace conformal::mpi {

/// a factored matrix in parts
class Distributed_factor {
 public:
  virtual ~Distributed_factor() = default;

  /// \brief Overwrites right-hand sides by solutions. Collective.
  /// \param x four real numbers for each own vertex: a quaternion, or four right-hand sides
  virtual void solve(Eigen::Matrix4Xd& x) const = 0;
};

/// \brief The sparse Cholesky factorization of a positive definite matrix in parts.
///
/// Each process eliminates the vertices of its own that are not along a border, which share no edge
/// with those of others. What this leaves of the matrix along the borders, its Schur complement,
/// is added up and factored by the first process: on n vertices in p parts these are some
/// sqrt(n p), so it is dense in small blocks only.
///
/// \tparam Real the numbers of the factor
template <class Scalar, class Real>
class Distributed_cholesky final : public Distributed_factor {
  using Matrix = CGP::Hermitian_sparse_matrix<Scalar>;
  using Planes = CGP::internal::Scalar_planes<Scalar>;
  using Small = std::conditional_t<Planes::size == 1, Real, CGP::Quaternion<Real>>;
  using Small_planes = CGP::internal::Scalar_planes<Small>;
  using Complement = CGP::Hermitian_sparse_matrix<Small>;
  using Rows = Eigen::Matrix<Real, 4, Eigen::Dynamic>;

 public:
  /// \param A on the graph of the mesh of the part, in which rows of own vertices are complete
  Distributed_cholesky(const Distributed_mesh& mesh, const Border_vertices& border, const Matrix& A)
      : m_border(border), m_own(mesh.own_vertices())
  {
    m_is_positive_definite = eliminate(mesh, A) && factor_border(A);
  }

  /// on all processes; if not, there is no factor
  bool is_positive_definite() const { return m_is_positive_definite; }

  void solve(Eigen::Matrix4Xd& x) const override
  {
    const double size = largest(m_own > 0 ? x.cwiseAbs().maxCoeff() : 0.);
    if (size == 0) return;
    const double unit = std::ldexp(1., std::ilogb(size));  // far from the limits of Real
    Rows y(4, static_cast<Eigen::Index>(m_order.size()));
    for (Eigen::Index k = 0; k < y.cols(); ++k) {
      const int v = m_order[at(k)];
      if (v < m_own)
        y.col(k) = (x.col(v) / unit).template cast<Real>();
      else
        y.col(k).setZero();
    }
    substitute(y);
    for (Eigen::Index k = 0; k < y.cols(); ++k)
      if (m_order[at(k)] < m_own) x.col(m_order[at(k)]) = unit * y.col(k).template cast<double>();
  }

 private:
  /// of the Schur complement, by the numbers of border vertices, row >= column
  struct Entry {
    int row, column;
    Small value;
  };

  static Small rounded(const Scalar& a)
  {
    typename Matrix::FT c[Planes::size];
    Real r[Planes::size];
    Planes::get(a, c);
    for (int q = 0; q < Planes::size; ++q) r[q] = static_cast<Real>(c[q]);
    return Small_planes::put(r);
  }

  static std::size_t at(Eigen::Index i) { return static_cast<std::size_t>(i); }

  int others_before() const { return m_border.others_before; }

  // The number of a vertex of the mesh of the part among those that a process eliminates or keeps;
  // -1 of those of processes before, which are not next to any that it eliminates.
  int place(int v) const
  {
    if (v < m_own) return v;
    return v < m_own + others_before() ? -1 : v - others_before();
  }

  // border vertices are not eliminated
  bool is_kept(int v) const { return m_border.numbers[at(v)] >= 0; }

  // The matrix of the vertices that are eliminated or kept, without the entries between the latter
  Matrix matrix_to_eliminate(const Matrix& A) const
  {
    const auto pattern = std::make_shared<CGP::Sparse_pattern>();
    pattern->offsets.push_back(0);
    std::vector<Scalar> values;
    for (int j = 0; j < A.size(); ++j) {
      if (place(j) < 0) continue;
      for (int k = A.pattern().offsets[at(j)]; k < A.pattern().offsets[at(j + 1)]; ++k) {
        const int i = A.pattern().indices[at(k)];
        const bool are_kept = is_kept(i) && is_kept(j);
        if (place(i) < 0 || (are_kept && i != j)) continue;
        pattern->indices.push_back(place(i));
        values.push_back(are_kept ? Scalar{} : A.value(k));
      }
      pattern->offsets.push_back(static_cast<int>(pattern->indices.size()));
    }
    Matrix own(pattern);
    for (std::size_t k = 0; k < values.size(); ++k) own.value(static_cast<int>(k)) = values[k];
    return own;
  }

  void find_order(const Distributed_mesh& mesh, const CGP::Sparse_pattern& pattern)
  {
    Eigen::Matrix3Xd positions(3, pattern.size());
    std::vector<int> numbers(at(pattern.size()));  // along the border
    for (int v = 0; v < mesh.mesh().size_of_vertices(); ++v)
      if (const int p = place(v); p >= 0) {
        positions.col(p) = mesh.mesh().position(v);
        numbers[at(p)] = m_border.numbers[at(v)];
      }
    m_order = CGP::choose_ordering(pattern, &positions);
    const auto kept = std::stable_partition(m_order.begin(), m_order.end(),
                                            [&](int p) { return numbers[at(p)] < 0; });
    for (auto p = kept; p != m_order.end(); ++p) m_kept.push_back(numbers[at(*p)]);
  }

  bool eliminate(const Distributed_mesh& mesh, const Matrix& A)
  {
    bool is_positive = true;
    together([&] {
      const Matrix own = matrix_to_eliminate(A);
      find_order(mesh, own.pattern());
      if (m_kept.size() == m_order.size()) return;
      auto structure = std::make_shared<const CGP::internal::Supernodal_structure>(
          own.pattern(), m_order, static_cast<int>(m_kept.size()));
      m_order = structure->order();
      m_factor.emplace(std::move(structure));
      is_positive = m_factor->factorize(own, {}) < 0;
    });
    return smallest(is_positive ? 1 : 0) > 0;
  }

  // The entries between border vertices of which the one of larger number is an own one
  std::vector<Entry> border_entries(const Matrix& A) const
  {
    std::vector<Entry> entries;
    A.for_each_entry([&](int i, int j, const Scalar& a) {
      const int row = m_border.numbers[at(i)], column = m_border.numbers[at(j)];
      if (row < 0 || column < 0 || !m_border.ranges.is_mine((std::max)(row, column))) return;
      const Small value = rounded(a);
      entries.push_back(row >= column ? Entry{row, column, value}
                                      : Entry{column, row, CGP::conjugate(value)});
    });
    return entries;
  }

  // What the elimination adds to the border vertices `numbers`: a lower triangle, row by row
  std::vector<Small> update(std::vector<int>& numbers) const
  {
    std::vector<Small> values;
    if (!m_factor) return values;
    const auto& S = m_factor->structure();
    const int eliminated = S.size_of_columns() - S.size_of_kept();
    std::vector<int> index(m_kept.size(), -1);
    const auto for_each_root = [&](const auto& visit) {
      for (int s = 0; s < S.size(); ++s)
        if (S.parent(s) < 0) visit(s);
    };
    for_each_root([&](int s) {
      for (int r = 0; r < S.height(s); ++r) index[at(S.rows(s)[r] - eliminated)] = 0;
    });
    for (std::size_t k = 0; k < index.size(); ++k)
      if (index[k] == 0) {
        index[k] = static_cast<int>(numbers.size());
        numbers.push_back(m_kept[k]);
      }
    values.resize(numbers.size() * (numbers.size() + 1) / 2);
    for_each_root([&](int s) {
      const CGP::internal::Panel_layout& layout = m_factor->layout();
      const int height = S.height(s), blocks = layout.blocks(height);
      for (int j = 0; j < height; ++j)
        for (int i = j; i < height; ++i) {
          const Real* const from = m_factor->update(s) + layout.in_update(blocks, i, j);
          Real c[Planes::size];
          for (int q = 0; q < Planes::size; ++q) c[q] = from[q * layout.lanes()];
          const std::size_t row = at(index[at(S.rows(s)[i] - eliminated)]);
          values[row * (row + 1) / 2 + at(index[at(S.rows(s)[j] - eliminated)])] +=
              Small_planes::put(c);
        }
    });
    return values;
  }

  bool factor_border(const Matrix& A)
  {
    std::vector<std::vector<Entry>> entries(at(processes()));
    entries[0] = border_entries(A);
    const std::vector<Entry> between = deliver(entries);
    std::vector<std::vector<int>> cliques(at(processes()));
    const std::vector<Small> own = update(cliques[0]);
    std::vector<int> sizes;
    const std::vector<int> numbers = deliver(cliques, &sizes);
    bool is_positive = true;
    if (rank() != 0)
      send(own);
    else
      is_positive = factor_collected(between, numbers, sizes, own);
    share_places();
    return broadcast(is_positive);
  }

  static void send(const std::vector<Small>& own)
  {
    MPI_Send(own.data(), static_cast<int>(own.size()) * Planes::size, type(), 0, 0, MPI_COMM_WORLD);
  }

  static MPI_Datatype type() { return std::is_same_v<Real, float> ? MPI_FLOAT : MPI_DOUBLE; }

  static std::vector<Small> received(int process, int clique)
  {
    std::vector<Small> values(at(clique) * at(clique + 1) / 2);
    MPI_Recv(values.data(), static_cast<int>(values.size()) * Planes::size, type(), process, 0,
             MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return values;
  }

  bool factor_collected(const std::vector<Entry>& between, const std::vector<int>& numbers,
                        const std::vector<int>& sizes, const std::vector<Small>& own)
  {
    Complement S(pattern_of(between, numbers, sizes));
    for (const auto& [row, column, value] : between)
      S.value(S.pattern().find(row, column)) += value;
    const int* clique = numbers.data();
    for (int p = 0; p < processes(); ++p) {
      add(p == 0 ? own : received(p, sizes[at(p)]), clique, sizes[at(p)], S);
      clique += sizes[at(p)];
    }
    if (S.size() == 0) return true;
    return m_first.analyze(S.pattern()) == CGP::Solver_status::success &&
           m_first.factorize(S, {}) == CGP::Solver_status::success;
  }

  std::shared_ptr<const CGP::Sparse_pattern> pattern_of(const std::vector<Entry>& between,
                                                        const std::vector<int>& numbers,
                                                        const std::vector<int>& sizes) const
  {
    std::vector<std::vector<int>> columns(at(m_border.ranges.total()));
    for (const Entry& e : between) columns[at(e.column)].push_back(e.row);
    auto begin = numbers.begin();
    for (const int size : sizes) {
      std::vector<int> clique(begin, begin + size);
      std::sort(clique.begin(), clique.end());
      for (auto j = clique.begin(); j != clique.end(); ++j)
        columns[at(*j)].insert(columns[at(*j)].end(), j, clique.end());
      begin += size;
    }
    return CGP::sparse_pattern(std::move(columns));
  }

  static void add(const std::vector<Small>& values, const int* clique, int size, Complement& S)
  {
    std::size_t next = 0;
    for (int r = 0; r < size; ++r)
      for (int c = 0; c <= r; ++c) {
        const Small& value = values[next++];
        if (clique[r] >= clique[c])
          S.value(S.pattern().find(clique[r], clique[c])) += value;
        else
          S.value(S.pattern().find(clique[c], clique[r])) += CGP::conjugate(value);
      }
  }

  // Which border vertices each process has a part of, for the first one
  void share_places()
  {
    std::vector<std::vector<int>> kept(at(processes()));
    kept[0] = m_kept;
    m_places = deliver(kept, &m_counts);
    for (int& count : m_counts) count *= 4;
    m_offsets.assign(m_counts.size(), 0);
    std::partial_sum(m_counts.begin(), m_counts.end() - 1, m_offsets.begin() + 1);
  }

  // y: in the order of elimination
  void substitute(Rows& y) const
  {
    std::optional<CGP::internal::Supernodal_substitution<Scalar, Real>> own;
    if (m_factor) own.emplace(*m_factor).forward(y.data());
    const auto kept = static_cast<Eigen::Index>(m_kept.size());
    Real* const part = y.data() + 4 * (y.cols() - kept);
    const int count = static_cast<int>(4 * kept);
    Rows all(4, static_cast<Eigen::Index>(m_places.size()));
    MPI_Gatherv(part, count, type(), all.data(), m_counts.data(), m_offsets.data(), type(), 0,
                MPI_COMM_WORLD);
    if (rank() == 0) solve_border(all);
    MPI_Scatterv(all.data(), m_counts.data(), m_offsets.data(), type(), part, count, type(), 0,
                 MPI_COMM_WORLD);
    if (own) own->backward(y.data());
  }

  void solve_border(Rows& all) const
  {
    Rows sums = Rows::Zero(4, m_border.ranges.total());
    for (Eigen::Index k = 0; k < all.cols(); ++k) sums.col(m_places[at(k)]) += all.col(k);
    if (sums.cols() == 0) return;
    constexpr int columns = 4 / Planes::size;
    CGP::Block<Small> x(sums.cols(), columns);
    for (Eigen::Index k = 0; k < sums.cols(); ++k)
      for (int c = 0; c < columns; ++c) x(k, c) = Small_planes::put(&sums(c * Planes::size, k));
    m_first.solve(x, x);
    for (Eigen::Index k = 0; k < sums.cols(); ++k)
      for (int c = 0; c < columns; ++c) Small_planes::get(x(k, c), &sums(c * Planes::size, k));
    for (Eigen::Index k = 0; k < all.cols(); ++k) all.col(k) = sums.col(m_places[at(k)]);
  }

  const Border_vertices& m_border;
  int m_own;
  bool m_is_positive_definite = false;
  CGP::internal::Ordering m_order;  // of elimination; those that are kept are last
  std::vector<int> m_kept;          // the numbers of these along the border
  std::optional<CGP::internal::Supernodal_factor<Scalar, Real>> m_factor;
  // of the first process
  CGP::Supernodal_cholesky<Small> m_first;
  std::vector<int> m_places, m_counts, m_offsets;
};

}  // namespace conformal::mpi
