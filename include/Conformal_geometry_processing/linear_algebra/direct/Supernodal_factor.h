// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_SUPERNODAL_FACTOR_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_SUPERNODAL_FACTOR_H

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Aligned_array.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Extend_add.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Update_places.h>
#include <Conformal_geometry_processing/linear_algebra/direct/number_of_threads.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief the numbers of a supernodal Cholesky factor L L^H, found by the multifrontal method.
///
/// Fronts are eliminated children before parents; the update that a front leaves to its parent
/// waits in an array (`Update_places`). Subtrees are tasks for several threads, and the large
/// fronts above them are divided by rows. The cuts follow from the structure alone, and each number
/// is computed by the same operations in the same order whoever does it: the factor is the same to
/// the bit for any number of threads. Memory is allocated once and used again.
///
/// \tparam Scalar a real, complex or quaternion type \tparam Real the numbers stored
template <class Scalar, class Real>
class Supernodal_factor {
 public:
  using Kernels = Front_kernels<Scalar, Real>;
  using FT = typename Scalar_traits<Scalar>::FT;

  explicit Supernodal_factor(std::shared_ptr<const Supernodal_structure> structure)
      : m_structure(std::move(structure)), m_tasks(*m_structure)
  {
    const Supernodal_structure& S = *m_structure;
    m_panel_offsets.assign(1, 0);
    for (int s = 0; s < S.size(); ++s)
      m_panel_offsets.push_back(m_panel_offsets.back() +
                                Kernels::panel_size(S.width(s), S.height(s)));
    plan();
  }

  const Supernodal_structure& structure() const { return *m_structure; }
  const Elimination_tasks& tasks() const { return m_tasks; }

  /// threads for a step that takes one thread about so many seconds: one where more would not pay
  static int threads(double seconds)
  {
    const double worth_it = 1e-3;
    return seconds < worth_it ? 1 : (std::min)(number_of_threads(), 1024);
  }

  /// bytes of the panels, and of the updates as well
  std::int64_t panel_bytes() const { return m_panel_offsets.back() * std::int64_t(sizeof(Real)); }
  std::int64_t bytes() const
  {
    return panel_bytes() + m_places.size() * std::int64_t(sizeof(Real));
  }

  /// \brief factors A + diag(shift).
  /// \returns the vertex whose pivot is not positive, the first one in the order of elimination; -1
  /// if all are positive
  /// \throw std::bad_alloc
  int factorize(const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift)
  {
    plan();
    m_panels.resize(m_panel_offsets.back());
    m_updates.resize(m_places.size());
    Input input{A, shift};
    if (m_is_parallel)
      m_tasks.run(threads(seconds()), [&](const Elimination_tasks::Task& task, Task_pool& pool) {
        for (int s = task.begin; s < task.end; ++s) eliminate(s, input, pool);
      });
    else
      for (int s = 0; s < m_structure->size(); ++s) eliminate(s, input, One_by_one());
    if (m_structure->size_of_kept() == 0 &&
        m_updates.size() * std::int64_t(sizeof(Real)) > kept_bytes)
      m_updates.resize(0);
    return input.bad_column == no_column ? -1 : m_structure->order()[at(input.bad_column)];
  }

  /// gives the memory of the numbers back; the next factorization allocates it anew
  void release()
  {
    m_panels.resize(0);
    m_updates.resize(0);
  }

  /// the panel of supernode s
  const Real* panel(int s) const { return m_panels.data() + m_panel_offsets[at(s)]; }

  /// what the last factorization has left to the kept vertices below supernode s
  /// \pre s has no parent
  const Real* update(int s) const { return m_updates.data() + m_places[s]; }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  static constexpr int lanes = Kernels::lanes, planes = Kernels::planes;
  static constexpr int no_column = (std::numeric_limits<int>::max)();

  // Updates larger than this are not kept for the next factorization, but leave room for what
  // follows this one.
  static constexpr std::int64_t kept_bytes = std::int64_t(1) << 27;

  // So many row blocks of a large front are one piece of work; they stay in the second-level cache.
  static constexpr int piece = 8;

  struct Input {
    const Hermitian_sparse_matrix<Scalar>& A;
    const Vector<FT>& shift;
    std::atomic<int> bad_column{no_column};  // the least one found

    void report(int column)
    {
      for (int least = bad_column; column < least;)
        if (bad_column.compare_exchange_weak(least, column)) return;
    }
  };

  struct One_by_one {
    template <class Visitor>
    void for_each(int count, const Visitor& visit) const
    {
      for (int i = 0; i < count; ++i) visit(i);
    }
  };

  // Of a factorization, at an ordinary 20 Gflop/s.
  double seconds() const { return m_structure->operations() * planes * planes / 20e9; }

  // Places for the updates, with one thread in the least memory.
  void plan()
  {
    const bool is_parallel = m_tasks.size() > 1 && threads(seconds()) > 1;
    if (m_places.size() > 0 && is_parallel == m_is_parallel) return;
    m_is_parallel = is_parallel;
    const auto size = [&](int s) { return Kernels::update_size(m_structure->height(s)); };
    m_places = is_parallel ? Update_places(*m_structure, m_tasks, size)
                           : Update_places(*m_structure, size);
  }

  /// A supernode with its columns, the rows below, and the same in row blocks.
  struct Front {
    int s, columns, rows, triangle, blocks;
    Real *panel, *update;
    Extend_add<Scalar, Real> extend_add;
  };

  Front front(int s)
  {
    const int k = m_structure->width(s), u = m_structure->height(s);
    return {s,
            k,
            u,
            Kernels::blocks(k),
            Kernels::blocks(u),
            m_panels.data() + m_panel_offsets[at(s)],
            m_updates.data() + m_places[s],
            Extend_add<Scalar, Real>(k, u)};
  }

  // Once a column is known to be bad, only columns before it are of interest.
  template <class Loops>
  void eliminate(int s, Input& input, Loops&& loops)
  {
    if (m_structure->first(s) > input.bad_column) return;
    const Front f = front(s);
    const int bad =
        f.blocks > 2 * piece ? eliminate_in_pieces(f, input, loops) : eliminate_at_once(f, input);
    if (bad >= 0) input.report(m_structure->first(s) + bad);
  }

  int eliminate_at_once(const Front& f, const Input& input)
  {
    add_matrix(f, input);
    add_children_to_panel(f, 0, f.columns + f.rows);
    const int bad = Kernels::factor_panel(f.panel, f.columns, f.triangle + f.blocks);
    if (bad < 0) set_update(f, 0, f.blocks);
    return bad;
  }

  template <class Loops>
  int eliminate_in_pieces(const Front& f, const Input& input, Loops&& loops)
  {
    add_matrix(f, input);
    add_children_to_panel(f, 0, f.columns);
    const int bad = Kernels::factor_panel(f.panel, f.columns, f.triangle);
    if (bad >= 0) return bad;
    const int pieces = (f.blocks + piece - 1) / piece;
    loops.for_each(pieces, [&](int i) {
      const int begin = i * piece, end = (std::min)(begin + piece, f.blocks);
      add_children_to_panel(f, f.columns + begin * lanes,
                            f.columns + (std::min)(end * lanes, f.rows));
      Kernels::solve_below(f.panel, f.columns, f.triangle + begin, f.triangle + end);
    });
    loops.for_each(pieces, [&](int i) {  // the longest rows first
      const int end = f.blocks - i * piece;
      set_update(f, (std::max)(0, end - piece), end);
    });
    return -1;
  }

  template <class Visitor>
  void for_each_child(const Front& f, Visitor visit) const
  {
    const Supernodal_structure& S = *m_structure;
    for (const int* c = S.children_begin(f.s); c != S.children_end(f.s); ++c)
      visit({m_updates.data() + m_places[*c], S.height(*c), S.relative_rows(*c)});
  }

  void add_children_to_panel(const Front& f, int begin, int end) const
  {
    for_each_child(f, [&](const typename Extend_add<Scalar, Real>::Child& child) {
      f.extend_add.add_to_panel(child, f.panel, begin, end);
    });
  }

  // The row blocks begin <= block < end of the update.
  void set_update(const Front& f, int begin, int end) const
  {
    Kernels::set_outer_product(f.update, f.panel + Kernels::panel_size(f.columns, 0), f.columns,
                               f.rows, begin, end);
    for_each_child(f, [&](const typename Extend_add<Scalar, Real>::Child& child) {
      f.extend_add.add_to_update(child, f.update, begin * lanes, (std::min)(end * lanes, f.rows));
    });
  }

  void add_matrix(const Front& f, const Input& input) const
  {
    const Supernodal_structure& S = *m_structure;
    std::fill_n(f.panel, Kernels::panel_size(f.columns, f.rows), Real(0));
    for (const auto* e = S.entries_begin(f.s); e != S.entries_end(f.s); ++e) {
      FT c[planes];
      Scalar_planes<Scalar>::get(
          e->source >= 0 ? input.A.value(e->source) : conjugate(input.A.value(~e->source)), c);
      Real* const target =
          f.panel + f.extend_add.in_panel(static_cast<int>(e->row), static_cast<int>(e->column));
      for (std::ptrdiff_t q = 0; q < planes; ++q) target[q * lanes] += static_cast<Real>(c[q]);
    }
    if (input.shift.size() == 0) return;
    for (int j = 0; j < f.columns; ++j)
      f.panel[f.extend_add.in_panel(j, j)] +=
          static_cast<Real>(input.shift[S.order()[at(S.first(f.s) + j)]]);
  }

  std::shared_ptr<const Supernodal_structure> m_structure;
  Elimination_tasks m_tasks;
  std::vector<std::int64_t> m_panel_offsets;  // size + 1
  bool m_is_parallel = false;
  Update_places m_places;
  Aligned_array<Real> m_panels, m_updates;
};

}  // namespace Conformal_geometry_processing

#endif
