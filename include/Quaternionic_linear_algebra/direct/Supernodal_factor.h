// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion.h>
#include <Quaternionic_linear_algebra/direct/Aligned_array.h>
#include <Quaternionic_linear_algebra/direct/Supernodal_structure.h>
#include <Quaternionic_linear_algebra/threads/Task_pool.h>
#include <Quaternionic_linear_algebra/threads/Thread_team.h>
#include <Quaternionic_linear_algebra/vector_units/Front_kernels.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

/// The instances of `Supernodal_factor` and `Supernodal_substitution` in the compiled library:
/// apply(Scalar, Real) for each combination of matrix entries and numbers of the factor
#define CGP_FOR_SUPERNODAL_INSTANCES(apply)                                                    \
  apply(double, double) apply(std::complex<double>, double) apply(Quaternion<double>, double)  \
      apply(double, float) apply(std::complex<double>, float) apply(Quaternion<double>, float) \
          apply(float, float) apply(Quaternion<float>, float)

/// those of them with real entries
#define CGP_FOR_REAL_SUPERNODAL_INSTANCES(apply) \
  apply(double, double) apply(double, float) apply(float, float)

namespace Conformal_geometry_processing::internal {

/// The largest of absolute values, in `sum_of_ranges()`; NaN is larger than all others
template <class FT>
struct Largest {
  FT value = 0;

  void add(FT number)
  {
    const FT size = std::abs(number);
    if (!(size <= value || std::isnan(value))) value = size;
  }

  Largest& operator+=(const Largest& other)
  {
    add(other.value);
    return *this;
  }
};

/// The largest absolute value of the numbers that the scalars at(i), 0 <= i < count, consist of
template <class Scalar, class At>
auto largest_of(std::ptrdiff_t count, const At& at)
{
  using FT = typename Scalar_traits<Scalar>::FT;
  constexpr int planes = Scalar_planes<Scalar>::size;
  constexpr std::ptrdiff_t at_once = 1 << 13;
  const auto add = [&](std::ptrdiff_t first, std::ptrdiff_t last, Largest<FT>& largest) {
    for (std::ptrdiff_t i = first; i < last; ++i) {
      FT c[planes];
      Scalar_planes<Scalar>::get(at(i), c);
      for (int q = 0; q < planes; ++q) largest.add(c[q]);
    }
  };
  return sum_of_ranges(count, at_once, Largest<FT>(), add).value;
}

template <class Scalar>
bool is_finite(const Hermitian_sparse_matrix<Scalar>& A)
{
  const auto value = [&A](std::ptrdiff_t k) { return A.value(static_cast<int>(k)); };
  return std::isfinite(largest_of<Scalar>(A.pattern().size_of_entries(), value));
}

/// The power of two just above the numbers of the scalars at(i), 0 <= i < count, which may be too
/// small, or too large, for another type of numbers; 1 if a number is not finite
template <class Scalar, class At>
auto power_of_two(std::ptrdiff_t count, const At& at)
{
  using FT = typename Scalar_traits<Scalar>::FT;
  const FT largest = largest_of<Scalar>(count, at);
  const bool is_usual = largest >= (std::numeric_limits<FT>::min)() && std::isfinite(largest);
  return is_usual ? std::ldexp(FT(1), (std::min)(std::ilogb(largest) + 1, 1000)) : FT(1);
}

template <class Real>
bool is_finite(const Aligned_array<Real>& numbers)
{
  const auto value = [&numbers](std::ptrdiff_t i) { return numbers.data()[i]; };
  return std::isfinite(largest_of<Real>(numbers.size(), value));
}

/// \brief Partition of the tree of supernodes into tasks for several threads.
///
/// A task is a range of supernodes: a subtree, several small sibling subtrees, or, above all these,
/// a single supernode. The partition depends on the structure only, never on the number of
/// threads. Tasks are numbered like the supernodes, children before parents.
class Elimination_tasks {
 public:
  struct Task {
    int begin, end;  ///< range of supernodes
    int parent;      ///< a task, or -1
    int children;    ///< number of tasks with this parent
  };

  /// \param share a subtree with more than this share of all operations is divided
  explicit Elimination_tasks(const Supernodal_structure& S, double share = 1. / 32);

  int size() const { return static_cast<int>(m_tasks.size()); }
  const Task& operator[](int t) const { return m_tasks[at(t)]; }

  /// \brief Calls `up(task, pool)` for every task, after those of its children.
  /// \throw the exceptions of `up`
  template <class Up>
  void run(int threads, const Up& up) const
  {
    Task_pool pool(threads);
    std::vector<std::atomic<int>> missing = missing_children();
    pool.run(leaves(), [&](int t) {
      up((*this)[t], pool);
      const int parent = (*this)[t].parent;
      if (parent >= 0 && --missing[at(parent)] == 0) pool.push(parent);
    });
  }

  /// \brief Calls `up` likewise, and then `down(task, pool)` for every task, after that of its
  /// parent.
  template <class Up, class Down>
  void run(int threads, const Up& up, const Down& down) const
  {
    Task_pool pool(threads);
    std::vector<std::atomic<int>> missing = missing_children();
    const std::vector<std::vector<int>> children = lists_of_children();
    pool.run(leaves(), [&](int t) {
      if (t >= 0) {
        up((*this)[t], pool);
        const int parent = (*this)[t].parent;
        if (parent < 0) pool.push(~t);
        if (parent >= 0 && --missing[at(parent)] == 0) pool.push(parent);
      } else {
        down((*this)[~t], pool);
        for (int c : children[at(~t)]) pool.push(~c);
      }
    });
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  std::vector<int> leaves() const;
  std::vector<std::atomic<int>> missing_children() const;
  std::vector<std::vector<int>> lists_of_children() const;
  void cut(const Supernodal_structure& S, const std::vector<double>& work, double most);

  std::vector<Task> m_tasks;
};

/// \brief Positions, in one array, of the update matrices that fronts pass to their parents.
///
/// An update is written while those of the children are still read, and is read until the parent's
/// is complete. Updates of even depth grow from the low end of the array, those of odd depth from
/// its high end: two stacks, one of which is popped while the other is pushed. With several threads
/// each task has a region of its own, inside the region of its parent.
class Contribution_stack {
 public:
  Contribution_stack() = default;

  /// Positions for supernodes that are eliminated sequentially
  /// \param size number of entries in the update of a supernode
  template <class Size>
  Contribution_stack(const Supernodal_structure& S, Size size) : m_begin(at(S.size()))
  {
    m_size = stack_up(S, {0, S.size(), -1, 0}, size).size;
  }

  /// Positions for tasks that run concurrently
  template <class Size>
  Contribution_stack(const Supernodal_structure& S, const Elimination_tasks& tasks, Size size)
      : m_begin(at(S.size()))
  {
    std::vector<Region> regions(at(tasks.size()));
    std::vector<int> roomiest(at(tasks.size()), -1);  // the child region with most free space
    for (int t = 0; t < tasks.size(); ++t) {
      Region& own = regions[at(t)];
      if (tasks[t].children == 0)
        own = stack_up(S, tasks[t], size);
      else
        enclose(own, size(tasks[t].begin), regions[at(roomiest[at(t)])]);
      const int up = tasks[t].parent;
      if (up < 0) continue;
      regions[at(up)].size += own.size;
      if (roomiest[at(up)] < 0 || own.spare() > regions[at(roomiest[at(up)])].spare())
        roomiest[at(up)] = t;
    }
    for (int t = tasks.size() - 1; t >= 0; --t) {
      Region& own = regions[at(t)];
      const Elimination_tasks::Task& task = tasks[t];
      const auto is_low = [&](int of) { return S.depth(tasks[of].begin) % 2 == 0; };
      if (const int up = task.parent; up >= 0) {
        put(own, t == roomiest[at(up)], regions[at(up)], is_low(up));
      } else {
        own.begin = m_size;
        m_size += own.size;
      }
      if (task.children > 0) {
        m_begin[at(task.begin)] = is_low(t) ? 0 : own.size - own.kept;
        own.next = own.begin;
        if (is_low(t)) own.next += own.padding + regions[at(roomiest[at(t)])].size;
      }
      for (int s = task.begin; s < task.end; ++s) m_begin[at(s)] += own.begin;
    }
  }

  /// Position of the update of supernode s
  std::int64_t operator[](int s) const { return m_begin[at(s)]; }

  /// Number of entries in the array
  std::int64_t size() const { return m_size; }

 private:
  struct Region {
    std::int64_t size = 0;
    std::int64_t kept = 0;     ///< still in use at one end when the task is done
    std::int64_t padding = 0;  ///< at the same end, before the regions inside
    std::int64_t begin = 0;    ///< in the array
    std::int64_t next = 0;     ///< begin of the next region inside
    std::int64_t spare() const { return size - kept; }
  };

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  // Positions, relative to the region, for supernodes that are eliminated sequentially.
  template <class Size>
  Region stack_up(const Supernodal_structure& S, const Elimination_tasks::Task& task, Size size)
  {
    std::array<std::int64_t, 2> used = {0, 0};
    Region region;
    for (int s = task.begin; s < task.end; ++s) {
      const std::size_t parity = at(S.depth(s) % 2);
      m_begin[at(s)] = used[parity];
      used[parity] += size(s);
      region.size = (std::max)(region.size, used[0] + used[1]);
      for (const int* c = S.children_begin(s); c != S.children_end(s); ++c)
        used[1 - parity] -= size(*c);
    }
    region.kept = used[0] + used[1];
    for (int s = task.begin; s < task.end; ++s)
      if (S.depth(s) % 2 == 1) m_begin[at(s)] = region.size - m_begin[at(s)] - size(s);
    return region;
  }

  static void enclose(Region& own, std::int64_t update, const Region& roomiest);
  static void put(Region& own, bool is_roomiest, Region& around, bool is_at_low_end);

  std::vector<std::int64_t> m_begin;
  std::int64_t m_size = 0;
};

/// \brief The numerical part of a supernodal Cholesky factor L L^H, computed by the multifrontal
/// method.
///
/// Fronts are eliminated children before parents; the update matrix that a front passes to its
/// parent is stored in an array (`Contribution_stack`). Subtrees are tasks for several threads, and
/// the large fronts above them are divided by rows. The partition depends on the structure only,
/// and each number is computed by the same operations in the same order on any thread, so the
/// factor is bitwise the same for any number of threads. Memory is allocated once and reused.
///
/// A factor that is only a preconditioner may be *rounded*: but for its diagonal, its numbers are
/// 16-bit multiples of a unit for each column. With a scale that makes the diagonal of the matrix
/// about 1 they are off by 3e-5 of a row, but for one of each column, which keeps the sum: the
/// smallest eigenvalues belong to smooth vectors. A front is rounded when it has passed its update
/// on.
///
/// The dense operations use the kernels of the `vector_unit()` at construction, which also
/// determine the layout of the numbers.
///
/// \tparam Scalar a real, complex or quaternion type \tparam Real the numbers stored. The compiled
/// library contains the combinations in `CGP_FOR_SUPERNODAL_INSTANCES`.
template <class Scalar, class Real>
class Supernodal_factor {
 public:
  using FT = typename Scalar_traits<Scalar>::FT;

  /// \param is_rounded whether panels are stored in 16 bits, for a preconditioner
  explicit Supernodal_factor(std::shared_ptr<const Supernodal_structure> structure,
                             bool is_rounded = false);

  const Supernodal_structure& structure() const { return *m_structure; }
  const Elimination_tasks& tasks() const { return m_tasks; }

  /// The dense kernels
  const Front_kernels<Real>& kernels() const { return m_kernels; }

  /// Layout of panels and updates
  const Panel_layout& layout() const { return m_kernels.layout; }

  /// Number of threads for a step of this duration on one thread: one if more would not pay off
  static int threads(double seconds);

  /// Bytes of the panels
  std::int64_t panel_bytes() const
  {
    const std::int64_t numbers = m_offsets.back();
    return m_is_rounded ? numbers * std::int64_t(sizeof(std::int16_t)) +
                              size_of_columns() * std::int64_t(sizeof(Real))
                        : numbers * std::int64_t(sizeof(Real));
  }

  /// Bytes of the panels and the updates
  std::int64_t bytes() const
  {
    return panel_bytes() + m_places.size() * std::int64_t(sizeof(Real));
  }

  /// \brief Factors S (A + diag(shift)) S with S = diag(scale), which is 1 if it is empty.
  /// \returns the first vertex, in the order of elimination, whose pivot is not positive; -1 if all
  /// are positive
  /// \throw std::bad_alloc
  int factorize(const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift,
                const Vector<FT>& scale = {});

  /// Releases the memory of the numbers; the next factorization allocates it anew
  void release();

  /// The front of supernode s, factored
  Factored_front<Real> front(int s) const;

  /// Update of the last factorization for the kept vertices below supernode s
  /// \pre s has no parent
  const Real* update(int s) const { return m_updates.data() + m_places[s]; }

 private:
  struct Input;       // a matrix, a shift, a scale and the first bad column
  struct One_by_one;  // sequential loops
  struct Front;       // a supernode and the positions of its numbers

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  /// Numbers for the columns of rounded panels
  std::int64_t size_of_columns() const
  {
    return m_is_rounded ? 2 * std::int64_t(m_structure->size_of_columns()) : 0;
  }

  double seconds() const;
  void plan();
  Front open_front(int s, Aligned_array<Real>& panel);
  template <class Loops>
  void eliminate(int s, Input& input, Loops& loops);
  int eliminate_at_once(const Front& f, const Input& input);
  template <class Loops>
  int eliminate_in_pieces(const Front& f, const Input& input, Loops& loops);
  template <class Visitor>
  void for_each_child(const Front& f, const Visitor& visit) const;
  void add_children_to_panel(const Front& f, int begin, int end) const;
  void set_update(const Front& f, int begin, int end) const;
  void add_matrix(const Front& f, const Input& input) const;
  int vertex(const Front& f, int row) const;
  void round(const Front& f);

  std::shared_ptr<const Supernodal_structure> m_structure;
  Front_kernels<Real> m_kernels;
  Elimination_tasks m_tasks;
  bool m_is_rounded;
  std::vector<std::int64_t> m_offsets;  // of panels, size + 1
  bool m_is_parallel = false;
  Contribution_stack m_places;
  Aligned_array<Real> m_panels, m_updates;
  Aligned_array<std::int16_t> m_rounded;  // the panels, if they are rounded,
  Aligned_array<Real> m_columns;          // and for each their units and the inverses of diagonals
};

}  // namespace Conformal_geometry_processing::internal
