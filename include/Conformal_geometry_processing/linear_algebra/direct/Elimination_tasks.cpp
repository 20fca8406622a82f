// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/direct/Elimination_tasks.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <vector>

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

}  // namespace Conformal_geometry_processing
