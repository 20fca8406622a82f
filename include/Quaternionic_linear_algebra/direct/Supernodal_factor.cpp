// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/direct/Supernodal_factor.h>

#include <Quaternionic_linear_algebra/vector_units/Vector_unit.h>

#include <utility>

namespace Conformal_geometry_processing {

internal::Elimination_tasks::Elimination_tasks(const internal::Supernodal_structure& S,
                                               double share)
{
  std::vector<double> work(at(S.size()), 0);
  double all = 0;
  for (int s = 0; s < S.size(); ++s) {
    const double front = S.width(s) + S.height(s);
    all += S.width(s) * front * front;
    work[at(s)] += S.width(s) * front * front;
    if (S.parent(s) >= 0) work[at(S.parent(s))] += work[at(s)];
  }
  cut(S, work, share * all);
}

std::vector<int> internal::Elimination_tasks::leaves() const
{
  std::vector<int> result;
  for (int t = 0; t < size(); ++t)
    if ((*this)[t].children == 0) result.push_back(t);
  return result;
}

std::vector<std::atomic<int>> internal::Elimination_tasks::missing_children() const
{
  std::vector<std::atomic<int>> result(at(size()));
  for (int t = 0; t < size(); ++t) result[at(t)] = (*this)[t].children;
  return result;
}

std::vector<std::vector<int>> internal::Elimination_tasks::lists_of_children() const
{
  std::vector<std::vector<int>> result(at(size()));
  for (int t = 0; t < size(); ++t)
    if ((*this)[t].parent >= 0) result[at((*this)[t].parent)].push_back(t);
  return result;
}

void internal::Elimination_tasks::cut(const internal::Supernodal_structure& S,
                                      const std::vector<double>& work, double most)
{
  std::vector<int> above(at(S.size()) + 1, -1), parent;  // the task of a supernode above the cut
  double last = 0;
  for (int s = 0; s < S.size(); ++s) {
    const int up = S.parent(s);
    const bool is_above = work[at(s)] > most;
    if (!is_above && up >= 0 && work[at(up)] <= most) continue;  // inside a subtree
    const int begin = m_tasks.empty() ? 0 : m_tasks.back().end;
    const bool joins =
        !is_above && !m_tasks.empty() && parent.back() == up && last + work[at(s)] <= most;
    last = joins ? last + work[at(s)] : (is_above ? most : work[at(s)]);
    if (joins) {
      m_tasks.back().end = s + 1;
      continue;
    }
    if (is_above) above[at(s)] = size();
    m_tasks.push_back({begin, s + 1, -1, 0});
    parent.push_back(up);
  }
  for (int t = 0; t < size(); ++t)
    if (const int up = parent[at(t)]; up >= 0) {
      m_tasks[at(t)].parent = above[at(up)];
      ++m_tasks[at(above[at(up)])].children;
    }
}

// For a single supernode: its update uses the free space of one of the inner regions, and more.
void internal::Contribution_stack::enclose(Region& own, std::int64_t update, const Region& roomiest)
{
  own.padding = (std::max<std::int64_t>)(0, update - roomiest.spare());
  own.size += own.padding;
  own.kept = update;
}

// The region with most free space lies where the update of the enclosing supernode is placed.
void internal::Contribution_stack::put(Region& own, bool is_roomiest, Region& around,
                                       bool is_at_low_end)
{
  if (is_roomiest)
    own.begin = is_at_low_end ? around.begin + around.padding
                              : around.begin + around.size - around.padding - own.size;
  else
    own.begin = around.next;
  if (!is_roomiest) around.next += own.size;
}

namespace internal {

constexpr int no_column = (std::numeric_limits<int>::max)();

// Updates larger than this are released after the factorization, to leave memory for subsequent
// steps; a next one gets huge pages, in little time.
constexpr std::int64_t kept_bytes = std::int64_t(1) << 22;

// Number of row blocks of a large front per work item; they fit in the second-level cache.
constexpr int blocks_per_piece = 8;

}  // namespace internal

template <class Scalar, class Real>
struct internal::Supernodal_factor<Scalar, Real>::Input {
  const Hermitian_sparse_matrix<Scalar>& A;
  const Vector<FT>&shift, &scale;
  std::atomic<int> bad_column{internal::no_column};  // the smallest one found

  void report(int column)
  {
    for (int least = bad_column; column < least;)
      if (bad_column.compare_exchange_weak(least, column)) return;
  }
};

template <class Scalar, class Real>
struct internal::Supernodal_factor<Scalar, Real>::One_by_one {
  template <class Visitor>
  void for_each(int count, const Visitor& visit) const
  {
    for (int i = 0; i < count; ++i) visit(i);
  }
};

// A supernode with its columns and the rows below, also counted in row blocks.
template <class Scalar, class Real>
struct internal::Supernodal_factor<Scalar, Real>::Front {
  int s, columns, rows, triangle, blocks;
  Real *panel, *update;
};

template <class Scalar, class Real>
internal::Supernodal_factor<Scalar, Real>::Supernodal_factor(
    std::shared_ptr<const internal::Supernodal_structure> structure, bool is_rounded)
    : m_structure(std::move(structure)),
      m_kernels(kernels_for<Real>(internal::Scalar_planes<Scalar>::size)),
      m_tasks(*m_structure),
      m_is_rounded(is_rounded),
      m_offsets(1, 0)
{
  const internal::Supernodal_structure& S = *m_structure;
  for (int s = 0; s < S.size(); ++s)
    m_offsets.push_back(m_offsets.back() + layout().panel_size(S.width(s), S.height(s)));
  plan();
}

template <class Scalar, class Real>
int internal::Supernodal_factor<Scalar, Real>::threads(double seconds)
{
  // what is worth a thread: several times the time in which it wakes up, or starts
  const double least = Thread_team::exists() ? 1e-4 : 5e-4;
  const double most = (std::min)(seconds / least, static_cast<double>(number_of_threads()));
  return (std::max)(1, static_cast<int>(most));
}

template <class Scalar, class Real>
int internal::Supernodal_factor<Scalar, Real>::factorize(const Hermitian_sparse_matrix<Scalar>& A,
                                                         const Vector<FT>& shift,
                                                         const Vector<FT>& scale)
{
  plan();
  m_panels.resize(m_is_rounded ? 0 : m_offsets.back());
  m_rounded.resize(m_is_rounded ? m_offsets.back() : 0);
  m_columns.resize(size_of_columns());
  m_updates.resize(m_places.size());
  Input input{A, shift, scale};
  One_by_one loops;
  if (m_is_parallel)
    m_tasks.run(threads(seconds()),
                [&](const internal::Elimination_tasks::Task& task, internal::Task_pool& pool) {
                  for (int s = task.begin; s < task.end; ++s) eliminate(s, input, pool);
                });
  else
    for (int s = 0; s < m_structure->size(); ++s) eliminate(s, input, loops);
  if (m_structure->size_of_kept() == 0 &&
      m_updates.size() * std::int64_t(sizeof(Real)) > internal::kept_bytes)
    m_updates.resize(0);
  return input.bad_column == internal::no_column ? -1 : m_structure->order()[at(input.bad_column)];
}

template <class Scalar, class Real>
void internal::Supernodal_factor<Scalar, Real>::release()
{
  m_panels.resize(0);
  m_rounded.resize(0);
  m_columns.resize(0);
  m_updates.resize(0);
}

// Estimated time of a factorization, at 20 Gflop/s.
template <class Scalar, class Real>
double internal::Supernodal_factor<Scalar, Real>::seconds() const
{
  return m_structure->operations() * layout().planes * layout().planes / 20e9;
}

// Computes positions for the updates; sequentially, those with the least memory.
template <class Scalar, class Real>
void internal::Supernodal_factor<Scalar, Real>::plan()
{
  const bool is_parallel = m_tasks.size() > 1 && threads(seconds()) > 1;
  if (m_places.size() > 0 && is_parallel == m_is_parallel) return;
  m_is_parallel = is_parallel;
  const auto size = [&](int s) { return layout().update_size(m_structure->height(s)); };
  m_places = is_parallel ? internal::Contribution_stack(*m_structure, m_tasks, size)
                         : internal::Contribution_stack(*m_structure, size);
}

template <class Scalar, class Real>
typename internal::Supernodal_factor<Scalar, Real>::Front
internal::Supernodal_factor<Scalar, Real>::open_front(int s, Aligned_array<Real>& panel)
{
  const int k = m_structure->width(s), u = m_structure->height(s);
  if (m_is_rounded) panel.resize(layout().panel_size(k, u));
  return {s,
          k,
          u,
          layout().blocks(k),
          layout().blocks(u),
          m_is_rounded ? panel.data() : m_panels.data() + m_offsets[at(s)],
          m_updates.data() + m_places[s]};
}

template <class Scalar, class Real>
internal::Factored_front<Real> internal::Supernodal_factor<Scalar, Real>::front(int s) const
{
  const int k = m_structure->width(s), u = m_structure->height(s);
  const int* const rows = m_structure->rows(s);
  const std::int64_t begin = m_offsets[at(s)];
  if (!m_is_rounded) return {m_panels.data() + begin, k, u, rows};
  const Real* const units = m_columns.data() + 2 * m_structure->first(s);
  return {nullptr, k, u, rows, m_rounded.data() + begin, units, units + k};
}

// Once a bad column is found, only columns before it are eliminated.
template <class Scalar, class Real>
template <class Loops>
void internal::Supernodal_factor<Scalar, Real>::eliminate(int s, Input& input, Loops& loops)
{
  if (m_structure->first(s) > input.bad_column) return;
  Aligned_array<Real> panel;  // of this front alone: threads may work on others
  const Front f = open_front(s, panel);
  const int bad = f.blocks > 2 * internal::blocks_per_piece ? eliminate_in_pieces(f, input, loops)
                                                            : eliminate_at_once(f, input);
  if (bad >= 0)
    input.report(m_structure->first(s) + bad);
  else if (m_is_rounded)
    round(f);
}

template <class Scalar, class Real>
int internal::Supernodal_factor<Scalar, Real>::eliminate_at_once(const Front& f, const Input& input)
{
  add_matrix(f, input);
  add_children_to_panel(f, 0, f.columns + f.rows);
  const int bad = m_kernels.factor_panel(f.panel, f.columns, f.triangle + f.blocks);
  if (bad < 0) set_update(f, 0, f.blocks);
  return bad;
}

template <class Scalar, class Real>
template <class Loops>
int internal::Supernodal_factor<Scalar, Real>::eliminate_in_pieces(const Front& f,
                                                                   const Input& input, Loops& loops)
{
  const int lanes = layout().lanes();
  add_matrix(f, input);
  add_children_to_panel(f, 0, f.columns);
  const int bad = m_kernels.factor_panel(f.panel, f.columns, f.triangle);
  if (bad >= 0) return bad;
  constexpr int length = internal::blocks_per_piece;
  const int pieces = (f.blocks + length - 1) / length;
  loops.for_each(pieces, [&](int i) {
    const int begin = i * length, end = (std::min)(begin + length, f.blocks);
    add_children_to_panel(f, f.columns + begin * lanes,
                          f.columns + (std::min)(end * lanes, f.rows));
    m_kernels.solve_below(f.panel, f.columns, f.triangle + begin, f.triangle + end);
  });
  loops.for_each(pieces, [&](int i) {  // longest rows first
    const int end = f.blocks - i * length;
    set_update(f, (std::max)(0, end - length), end);
  });
  return -1;
}

template <class Scalar, class Real>
template <class Visitor>
void internal::Supernodal_factor<Scalar, Real>::for_each_child(const Front& f,
                                                               const Visitor& visit) const
{
  const internal::Supernodal_structure& S = *m_structure;
  for (const int* c = S.children_begin(f.s); c != S.children_end(f.s); ++c)
    visit(internal::Child_update<Real>{m_updates.data() + m_places[*c], S.height(*c),
                                       S.relative_rows(*c)});
}

template <class Scalar, class Real>
void internal::Supernodal_factor<Scalar, Real>::add_children_to_panel(const Front& f, int begin,
                                                                      int end) const
{
  for_each_child(f, [&](const internal::Child_update<Real>& child) {
    m_kernels.add_to_panel(child, f.columns, f.panel, begin, end);
  });
}

// Computes the row blocks begin <= block < end of the update.
template <class Scalar, class Real>
void internal::Supernodal_factor<Scalar, Real>::set_update(const Front& f, int begin, int end) const
{
  const int lanes = layout().lanes();
  m_kernels.set_outer_product(f.update, f.panel + layout().panel_size(f.columns, 0), f.columns,
                              f.rows, begin, end);
  for_each_child(f, [&](const internal::Child_update<Real>& child) {
    m_kernels.add_to_update(child, f.columns, f.rows, f.update, begin * lanes,
                            (std::min)(end * lanes, f.rows));
  });
}

// The vertex of a row of the front, or of a column.
template <class Scalar, class Real>
int internal::Supernodal_factor<Scalar, Real>::vertex(const Front& f, int row) const
{
  const internal::Supernodal_structure& S = *m_structure;
  return S.order()[at(row < f.columns ? S.first(f.s) + row : S.rows(f.s)[row - f.columns])];
}

template <class Scalar, class Real>
void internal::Supernodal_factor<Scalar, Real>::add_matrix(const Front& f, const Input& input) const
{
  constexpr int planes = internal::Scalar_planes<Scalar>::size;
  const internal::Supernodal_structure& S = *m_structure;
  const internal::Panel_layout where = layout();
  std::fill_n(f.panel, where.panel_size(f.columns, f.rows), Real(0));
  for (const auto* e = S.entries_begin(f.s); e != S.entries_end(f.s); ++e) {
    FT c[planes];
    internal::Scalar_planes<Scalar>::get(
        e->source >= 0 ? input.A.value(e->source) : conjugate(input.A.value(~e->source)), c);
    // Before rounding to Real, where a small shift may be lost.
    const int row = static_cast<int>(e->row), column = static_cast<int>(e->column);
    if (row == column && input.shift.size() > 0) c[0] += input.shift[vertex(f, row)];
    if (input.scale.size() > 0)
      for (FT& x : c) x *= input.scale[vertex(f, row)] * input.scale[vertex(f, column)];
    Real* const target = f.panel + where.in_panel(f.columns, row, column);
    for (int q = 0; q < planes; ++q) target[q * where.lanes()] += static_cast<Real>(c[q]);
  }
}

template <class Scalar, class Real>
void internal::Supernodal_factor<Scalar, Real>::round(const Front& f)
{
  Real* const units = m_columns.data() + 2 * m_structure->first(f.s);
  m_kernels.round_panel(f.panel, f.columns, f.triangle + f.blocks,
                        m_rounded.data() + m_offsets[at(f.s)], units, units + f.columns);
}

#define CGP_DEFINE(Scalar, Real) template class internal::Supernodal_factor<Scalar, Real>;
CGP_FOR_SUPERNODAL_INSTANCES(CGP_DEFINE)
#undef CGP_DEFINE

}  // namespace Conformal_geometry_processing
