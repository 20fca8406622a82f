// Tests include/Conformal_geometry_processing/linear_algebra/direct/Elimination_tasks.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Conformal_geometry_processing/linear_algebra/direct/Elimination_tasks.h>

#include <gtest/gtest.h>

#include <mutex>

#include "linear_algebra/symbolic_elimination.h"

namespace cgp_test::elimination_tasks_tests {

using CGP::internal::Elimination_tasks;
using CGP::internal::Supernodal_structure;

double work(const Supernodal_structure& S, int begin, int end)
{
  double sum = 0;
  for (int s = begin; s < end; ++s) {
    const double front = S.width(s) + S.height(s);
    sum += S.width(s) * front * front;
  }
  return sum;
}

void expect_cut(const Supernodal_structure& S, double share)
{
  const Elimination_tasks tasks(S, share);
  std::vector<int> task(at(S.size()), -1), children(at(tasks.size()), 0);
  int next = 0;
  for (int t = 0; t < tasks.size(); ++t) {
    EXPECT_EQ(tasks[t].begin, next);
    EXPECT_GT(tasks[t].end, next);
    for (; next < tasks[t].end; ++next) task[at(next)] = t;
  }
  EXPECT_EQ(next, S.size());
  for (int t = 0; t < tasks.size(); ++t) {
    if (tasks[t].end - tasks[t].begin > 1) {
      EXPECT_LE(work(S, tasks[t].begin, tasks[t].end), share * work(S, 0, S.size()) * (1 + 1e-12));
    }
    for (int s = tasks[t].begin; s < tasks[t].end; ++s) {
      const int up = S.parent(s) < 0 ? -1 : task[at(S.parent(s))];
      EXPECT_TRUE(up == t || up == tasks[t].parent);
    }
    if (tasks[t].parent >= 0) ++children[at(tasks[t].parent)];
  }
  for (int t = 0; t < tasks.size(); ++t) EXPECT_EQ(tasks[t].children, children[at(t)]);
}

TEST(Elimination_tasks, are_subtrees_of_limited_work_and_single_supernodes_above_them)
{
  for (const auto& [name, pattern, order] : ordered_graphs()) {
    SCOPED_TRACE(name);
    const Supernodal_structure S(*pattern, order);
    for (const double share : {0., 0.02, 0.2, 1.}) expect_cut(S, share);
  }
}

TEST(Elimination_tasks, are_one_where_all_fits)
{
  const Supernodal_structure S(*grid_pattern(9, 9), random_permutation(81, 1));
  EXPECT_EQ(Elimination_tasks(S, 1.).size(), 1);
  EXPECT_EQ(Elimination_tasks(S, 0.).size(), S.size());
}

TEST(Elimination_tasks, run_up_the_tree_and_down_again)
{
  const Supernodal_structure S(*grid_pattern(20, 20), random_permutation(400, 2));
  const Elimination_tasks tasks(S, 0.02);
  ASSERT_GT(tasks.size(), 10);
  for (const int threads : {1, 3}) {
    std::mutex mutex;
    std::vector<int> ups, downs;  // the first supernodes, in the order of time
    const auto note = [&](std::vector<int>& list) {
      return [&](const Elimination_tasks::Task& task, CGP::internal::Task_pool&) {
        const std::lock_guard<std::mutex> lock(mutex);
        list.push_back(task.begin);
      };
    };
    tasks.run(threads, note(ups), note(downs));
    std::vector<int> only_ups;
    tasks.run(threads, note(only_ups));
    ASSERT_EQ(ups.size(), at(tasks.size()));
    ASSERT_EQ(downs.size(), at(tasks.size()));
    ASSERT_EQ(only_ups.size(), at(tasks.size()));
    const auto place = [&](const std::vector<int>& list, int t) {
      return std::find(list.begin(), list.end(), tasks[t].begin) - list.begin();
    };
    for (int t = 0; t < tasks.size(); ++t) {
      ASSERT_LT(place(only_ups, t), tasks.size());
      if (tasks[t].parent < 0) continue;
      EXPECT_LT(place(ups, t), place(ups, tasks[t].parent));
      EXPECT_LT(place(only_ups, t), place(only_ups, tasks[t].parent));
      EXPECT_GT(place(downs, t), place(downs, tasks[t].parent));
    }
  }
}

}  // namespace cgp_test::elimination_tasks_tests
