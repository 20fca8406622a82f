// Tests direct/Supernodal_factor.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Quaternionic_linear_algebra/direct/Supernodal_factor.h>

#include <gtest/gtest.h>

#include <functional>

#include "quaternionic_linear_algebra/symbolic_elimination.h"

namespace cgp_test::contribution_stack_tests {

using CGP::internal::Contribution_stack;
using CGP::internal::Elimination_tasks;
using CGP::internal::Supernodal_structure;

struct Numbers {
  const Supernodal_structure& S;
  std::int64_t operator()(int s) const { return std::int64_t(S.height(s)) * (S.height(s) + 1) / 2; }
};

bool overlap(const Supernodal_structure& S, const Contribution_stack& places, int s, int t)
{
  return places[s] < places[t] + Numbers{S}(t) && places[t] < places[s] + Numbers{S}(s);
}

// An update exists from the front of its supernode to the front of the parent.
TEST(Contribution_stack, never_hold_two_updates_that_wait_at_the_same_time)
{
  for (const auto& [name, pattern, order] : ordered_graphs()) {
    SCOPED_TRACE(name);
    const Supernodal_structure S(*pattern, order);
    const Contribution_stack places(S, Numbers{S});
    std::int64_t all = 0;
    for (int t = 0; t < S.size(); ++t) {
      EXPECT_GE(places[t], 0);
      EXPECT_LE(places[t] + Numbers{S}(t), places.size());
      all += Numbers{S}(t);
      for (int s = 0; s < t; ++s)
        EXPECT_FALSE(S.parent(s) >= t && overlap(S, places, s, t)) << s << " and " << t;
    }
    EXPECT_LE(places.size(), all);
  }
}

TEST(Contribution_stack, of_a_long_path_are_as_few_as_two_updates)
{
  std::vector<std::pair<int, int>> edges;
  for (int i = 0; i + 1 < 200; ++i) edges.push_back({i, i + 1});
  CGP::internal::Ordering order(200);
  std::iota(order.begin(), order.end(), 0);
  const Supernodal_structure S(*pattern_of_edges(200, edges), order);
  EXPECT_EQ(Contribution_stack(S, Numbers{S}).size(), 2);
}

// Tasks that are not on one path to a root may be done at any time, the one after the other or both
// at once: whatever they use must be apart.
TEST(Contribution_stack, of_tasks_are_apart_unless_one_is_done_before_the_other_begins)
{
  for (const auto& [name, pattern, order] : ordered_graphs())
    for (const double share : {0., 0.1, 1.}) {
      SCOPED_TRACE(name);
      const Supernodal_structure S(*pattern, order);
      const Elimination_tasks tasks(S, share);
      const Contribution_stack places(S, tasks, Numbers{S});
      const auto is_above = [&](int t, int s) {
        while (s >= 0 && s < t) s = S.parent(s);
        return s == t;
      };
      std::vector<int> task;
      for (int t = 0; t < tasks.size(); ++t) task.resize(at(tasks[t].end), t);
      for (int t = 0; t < S.size(); ++t) {
        EXPECT_GE(places[t], 0);
        EXPECT_LE(places[t] + Numbers{S}(t), places.size());
        for (int s = 0; s < t; ++s) {
          const bool one_by_one = task[at(s)] == task[at(t)] || is_above(t, s);
          const bool is_over = one_by_one && S.parent(s) >= 0 && S.parent(s) < t;
          EXPECT_FALSE(!is_over && overlap(S, places, s, t)) << s << " and " << t;
        }
      }
    }
}

}  // namespace cgp_test::contribution_stack_tests
