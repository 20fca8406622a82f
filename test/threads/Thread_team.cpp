// Tests include/Conformal_geometry_processing/threads/Thread_team.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/threads/Thread_team.h>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <set>
#include <stdexcept>

namespace cgp_test::thread_team_tests {

using Conformal_geometry_processing::internal::Thread_team;
using Ids = std::set<std::thread::id>;

/// the threads that work at the same time: no call ends before all have begun, or 20 seconds later
Ids together(Thread_team& team, int threads)
{
  std::mutex mutex;
  Ids ids;
  team.run(threads, [&] {
    std::unique_lock<std::mutex> lock(mutex);
    ids.insert(std::this_thread::get_id());
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (static_cast<int>(ids.size()) < threads && std::chrono::steady_clock::now() < end) {
      lock.unlock();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      lock.lock();
    }
  });
  return ids;
}

TEST(Thread_team, works_on_as_many_threads_as_are_asked_for)
{
  Thread_team team;
  for (const int threads : {1, 3, 2, 5}) {
    const Ids ids = together(team, threads);
    EXPECT_EQ(ids.size(), static_cast<std::size_t>(threads));
    EXPECT_EQ(ids.count(std::this_thread::get_id()), 1u);
  }
}

TEST(Thread_team, is_that_of_an_enclosing_function)
{
  Thread_team outer;
  const Ids ids = together(outer, 2);
  for (int i = 0; i < 3; ++i) {
    Thread_team inner;
    EXPECT_EQ(together(inner, 2), ids);
  }
  EXPECT_EQ(together(outer, 2), ids);
}

TEST(Thread_team, does_not_divide_work_within_work)
{
  Thread_team team;
  std::atomic<int> calls{0}, inner_calls{0};
  team.run(3, [&] {
    ++calls;
    Thread_team().run(3, [&] { ++inner_calls; });
  });
  EXPECT_EQ(inner_calls, calls);
}

TEST(Thread_team, hands_an_exception_to_the_caller_and_works_again)
{
  Thread_team team;
  for (int i = 0; i < 2; ++i) {
    EXPECT_THROW(team.run(2, [] { throw std::domain_error("all"); }), std::domain_error);
    EXPECT_EQ(together(team, 2).size(), 2u);
  }
}

TEST(Thread_team, hands_over_the_exception_of_another_thread)
{
  Thread_team team;
  const auto caller = std::this_thread::get_id();
  std::atomic<bool> has_begun{false};
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  EXPECT_THROW(team.run(2,
                        [&] {
                          if (std::this_thread::get_id() != caller) {
                            has_begun = true;
                            throw std::domain_error("the other one");
                          }
                          while (!has_begun && std::chrono::steady_clock::now() < end)
                            std::this_thread::yield();
                        }),
               std::domain_error);
}

std::atomic<int> ended{0};

struct Counts_its_end {
  ~Counts_its_end() { ++ended; }
};

TEST(Thread_team, ends_its_threads_when_it_ends)
{
  {
    Thread_team team;
    team.run(1, [] {});
    EXPECT_EQ(together(team, 3).size(), 3u);
    std::atomic<int> left{3};
    const auto caller = std::this_thread::get_id();
    team.run(3, [&] {
      --left;
      while (left > 0) std::this_thread::yield();
      if (std::this_thread::get_id() == caller) return;
      thread_local Counts_its_end one;
      (void)one;
    });
    EXPECT_EQ(ended, 0);
  }
  EXPECT_EQ(ended, 2);
}

TEST(Thread_team, of_one_thread_does_not_meet_that_of_another)
{
  std::vector<std::thread> threads;
  std::vector<Ids> ids(3);
  Thread_team own;
  for (Ids& set : ids)
    threads.emplace_back([&set] {
      Thread_team team;
      for (int i = 0; i < 50; ++i) set = together(team, 2);
    });
  const Ids mine = together(own, 2);
  for (std::thread& t : threads) t.join();
  Ids all = mine;
  for (const Ids& set : ids) all.insert(set.begin(), set.end());
  EXPECT_EQ(all.size(), 8u);
}

}  // namespace cgp_test::thread_team_tests
