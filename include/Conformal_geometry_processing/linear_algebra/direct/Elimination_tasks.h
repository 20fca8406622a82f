// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_ELIMINATION_TASKS_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_ELIMINATION_TASKS_H

#include <Conformal_geometry_processing/linear_algebra/direct/Supernodal_structure.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Task_pool.h>

#include <atomic>
#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {

namespace internal {

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

}  // namespace internal

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/linear_algebra/direct/Elimination_tasks_impl.h>
#endif

#endif
