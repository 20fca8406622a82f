// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/linear_algebra/direct/Supernodal_structure.h>
#include <Conformal_geometry_processing/threads/Task_pool.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgLinearAlgebra
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

/// \ingroup PkgLinearAlgebra
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

}  // namespace Conformal_geometry_processing::internal
