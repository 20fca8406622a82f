// Tests include/Quaternionic_linear_algebra/threads/Task_pool.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Quaternionic_linear_algebra/threads/Task_pool.h>

#include <gtest/gtest.h>

#include <chrono>
#include <new>
#include <numeric>
#include <set>
#include <stdexcept>

namespace cgp_test::task_pool_tests {

namespace CGP = Conformal_geometry_processing;

class Task_pool : public testing::TestWithParam<int> {
 protected:
  CGP::internal::Task_pool pool{GetParam()};
};
INSTANTIATE_TEST_SUITE_P(With_threads, Task_pool, testing::Values(1, 2, 5));

TEST_P(Task_pool, does_every_task_once)
{
  std::vector<int> tasks(1000);
  std::iota(tasks.begin(), tasks.end(), 0);
  for (int again = 0; again < 3; ++again) {
    std::vector<std::atomic<int>> done(tasks.size());
    for (auto& count : done) count = 0;
    pool.run(tasks, [&](int t) { ++done[static_cast<std::size_t>(t)]; });
    for (const auto& count : done) EXPECT_EQ(count, 1);
  }
}

TEST_P(Task_pool, does_nothing_without_tasks)
{
  pool.run({}, [](int) { FAIL(); });
}

TEST_P(Task_pool, does_the_tasks_that_tasks_bring_forth)
{
  std::atomic<int> sum{0};
  pool.run({1}, [&](int t) {  // the nodes of a binary tree
    sum += t;
    if (t < 512) {
      pool.push(2 * t);
      pool.push(2 * t + 1);
    }
  });
  EXPECT_EQ(sum, 1023 * 1024 / 2);
}

TEST_P(Task_pool, shares_out_loops_of_several_tasks_at_once)
{
  std::vector<std::vector<int>> squares(7, std::vector<int>(300, -1));
  pool.run({0, 1, 2, 3, 4, 5, 6}, [&](int t) {
    std::vector<int>& row = squares[static_cast<std::size_t>(t)];
    pool.for_each(300, [&](int i) { row[static_cast<std::size_t>(i)] = t * i * i; });
    EXPECT_EQ(std::count(row.begin(), row.end(), -1), 0);  // all are done when the loop returns
    pool.for_each(0, [&](int) { FAIL(); });
  });
  for (int t = 0; t < 7; ++t)
    for (int i = 0; i < 300; ++i)
      EXPECT_EQ(squares[static_cast<std::size_t>(t)][static_cast<std::size_t>(i)], t * i * i);
}

TEST_P(Task_pool, hands_an_exception_of_a_task_to_the_caller_and_works_again)
{
  std::vector<int> tasks(100);
  std::iota(tasks.begin(), tasks.end(), 0);
  EXPECT_THROW(pool.run(tasks,
                        [&](int t) {
                          if (t == 17) throw std::bad_alloc();
                          pool.push(17);
                        }),
               std::bad_alloc);
  std::atomic<int> sum{0};
  pool.run(tasks, [&](int t) { sum += t; });
  EXPECT_EQ(sum, 4950);
}

TEST_P(Task_pool, hands_an_exception_of_a_loop_to_the_caller)
{
  bool is_reached = false;
  const auto act = [&](int) {
    pool.for_each(1000, [&](int i) {
      if (i == 500) throw std::domain_error("500");
    });
    is_reached = true;
  };
  EXPECT_THROW(pool.run({0}, act), std::domain_error);
  EXPECT_FALSE(is_reached);
}

TEST(Task_pool_of_two, has_a_second_thread_that_helps_with_the_loop_of_the_only_task)
{
  CGP::internal::Task_pool pool(2);
  std::mutex mutex;
  std::set<std::thread::id> threads;
  pool.run({0}, [&](int) {
    pool.for_each(2, [&](int) {  // neither visit ends before both have begun
      std::unique_lock<std::mutex> lock(mutex);
      threads.insert(std::this_thread::get_id());
      const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
      while (threads.size() < 2 && std::chrono::steady_clock::now() < end) {
        lock.unlock();
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        lock.lock();
      }
    });
  });
  EXPECT_EQ(threads.size(), 2u);
}

}  // namespace cgp_test::task_pool_tests
