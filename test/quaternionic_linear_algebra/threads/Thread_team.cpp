// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/threads/Thread_team.h>

#include <gtest/gtest.h>

#include "quaternionic_linear_algebra/threads/threads.h"

#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>

namespace cgp_test::thread_team_tests {

namespace CGP = Conformal_geometry_processing;
using Conformal_geometry_processing::internal::Thread_team;
using Ids = std::set<std::thread::id>;

// Both while the other thread polls, and after it has gone to sleep.
TEST(Signal, wakes_a_thread_that_polls_or_sleeps)
{
  for (const int delay : {0, 50}) {
    CGP::internal::Signal signal;
    std::mutex mutex;
    bool is_waiting = false, is_ready = false;
    std::thread waiting([&] {
      std::unique_lock<std::mutex> lock(mutex);
      is_waiting = true;
      while (!is_ready) signal.wait(lock);
      EXPECT_TRUE(lock.owns_lock());
    });
    std::unique_lock<std::mutex> lock(mutex);
    while (!is_waiting) {
      lock.unlock();
      std::this_thread::yield();
      lock.lock();
    }
    lock.unlock();
    std::this_thread::sleep_for(std::chrono::milliseconds(delay));
    lock.lock();
    is_ready = true;
    signal.announce();
    lock.unlock();
    waiting.join();
  }
}

TEST(Number_of_threads, is_one_unless_more_are_asked_for)
{
  EXPECT_EQ(CGP::number_of_threads(), 1);
  CGP::set_number_of_threads(3);
  EXPECT_EQ(CGP::number_of_threads(), 3);
  CGP::set_number_of_threads(1);
  EXPECT_EQ(CGP::number_of_threads(), 1);
}

TEST(Number_of_threads, is_that_of_the_machine_for_zero_or_less)
{
  for (const int all : {0, -1}) {
    CGP::set_number_of_threads(all);
    EXPECT_EQ(CGP::number_of_threads(),
              std::max(1, static_cast<int>(std::thread::hardware_concurrency())));
  }
  CGP::set_number_of_threads(1);
}

TEST(Number_of_threads, has_a_limit)
{
  CGP::set_number_of_threads(1000000);
  EXPECT_EQ(CGP::number_of_threads(), 1024);
  CGP::set_number_of_threads(1);
}

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

using namespace CGP::internal;
using cgp_test::Threads;

TEST(For_each_range, visits_every_element_once)
{
  for (const int threads : {1, 2, 5}) {
    const Threads setting(threads);
    for (const int count : {0, 1, 2, 7, 1000})
      for (const int least : {1, 3, 400}) {
        std::vector<std::atomic<int>> visits(static_cast<std::size_t>(count));
        for (auto& v : visits) v = 0;
        for_each_index(count, least, [&](int i) { ++visits[static_cast<std::size_t>(i)]; });
        for (const auto& v : visits) EXPECT_EQ(v, 1);
      }
  }
}

TEST(For_each_range, makes_ranges_that_are_worth_it)
{
  const Threads setting(4);
  const Thread_team team;
  for (const int per_thread : {1, 3}) {
    std::mutex mutex;
    std::vector<std::ptrdiff_t> sizes;
    for_each_range(
        1000, 30,
        [&](std::ptrdiff_t first, std::ptrdiff_t last) {
          const std::lock_guard<std::mutex> lock(mutex);
          sizes.push_back(last - first);
        },
        per_thread);
    EXPECT_EQ(sizes.size(), static_cast<std::size_t>(4 * per_thread));
    for (const auto size : sizes) EXPECT_GE(size, 30);
  }
  int ranges = 0;
  for_each_range(59, 30, [&](std::ptrdiff_t, std::ptrdiff_t) { ++ranges; });
  EXPECT_EQ(ranges, 1);
}

TEST(For_each_range, hands_an_exception_to_the_caller)
{
  for (const int threads : {1, 2}) {
    const Threads setting(threads);
    EXPECT_THROW(for_each_index(100, 1,
                                [](int i) {
                                  if (i == 57) throw std::domain_error("57");
                                }),
                 std::domain_error);
  }
}

double sum_of_inverses(int count, std::ptrdiff_t least)
{
  const auto add = [](std::ptrdiff_t first, std::ptrdiff_t last, double& sum) {
    for (std::ptrdiff_t i = first; i < last; ++i) sum += 1. / static_cast<double>(i + 1);
  };
  return sum_of_ranges(count, 100, 0., add, least);
}

TEST(Sum_of_ranges, has_the_same_bits_for_any_number_of_threads)
{
  for (const int count : {0, 1, 100, 101, 10000}) {
    const double one = sum_of_inverses(count, 1);
    double plain = 0;
    for (int i = 0; i < count; ++i) plain += 1. / (i + 1);
    EXPECT_NEAR(one, plain, 1e-12);
    for (const int threads : {2, 3, 7})
      for (const int least : {1, 10}) {
        const Threads setting(threads);
        EXPECT_EQ(sum_of_inverses(count, least), one);
      }
  }
}

TEST(Sum_of_ranges, adds_in_the_order_of_the_elements)
{
  struct Word {
    std::string letters;
    Word& operator+=(const Word& other)
    {
      letters += other.letters;
      return *this;
    }
  };
  const Threads setting(3);
  const auto add = [](std::ptrdiff_t first, std::ptrdiff_t last, Word& word) {
    for (std::ptrdiff_t i = first; i < last; ++i) word.letters += static_cast<char>('a' + i);
  };
  EXPECT_EQ(sum_of_ranges(26, 4, Word(), add).letters, "abcdefghijklmnopqrstuvwxyz");
}

}  // namespace cgp_test::thread_team_tests
