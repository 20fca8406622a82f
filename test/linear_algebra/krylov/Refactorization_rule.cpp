// Tests include/Conformal_geometry_processing/linear_algebra/krylov/Refactorization_rule.h
// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later

#include <Conformal_geometry_processing/linear_algebra/krylov/Refactorization_rule.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace {

namespace CGP = Conformal_geometry_processing;

constexpr double price = 10, fresh = 3;

/// Plays a flow whose steps cost `fresh` solves with a factorization of their own, and
/// `extra(steps since)` more with an older one; gives the steps that got one.
template <class Extra>
std::vector<int> factorized_steps(int steps, Extra extra)
{
  CGP::internal::Refactorization_rule rule;
  rule.set_price(price);
  std::vector<int> factorized;
  for (int step = 0, age = 0; step < steps; ++step, ++age) {
    const bool is_worn = rule.begin_step();
    if (is_worn || step == 0) {
      rule.renewed();
      factorized.push_back(step);
      age = 0;
    }
    rule.add(fresh);
    if (age == 0) continue;
    rule.add(std::min(extra(age), rule.budget()));
    if (rule.budget() <= 0) {
      rule.renewed_in_the_midst();
      factorized.push_back(step);
      rule.add(fresh);
      age = 0;
    }
  }
  return factorized;
}

}  // namespace

TEST(Factorization_price, grows_with_the_operations_for_each_number_of_the_factor)
{
  CGP::Solver_statistics s;
  s.factor_entries = 1000;
  s.flops = 1e6;
  const double real = CGP::factorization_price(s, 1);
  s.flops = 4e6;
  EXPECT_EQ(CGP::factorization_price(s, 4), real);
  EXPECT_GT(CGP::factorization_price(s, 1), real);
  s.flops = 0;
  EXPECT_GE(CGP::factorization_price(s, 1), 1);
}

TEST(Refactorization_rule, keeps_for_ever_what_costs_less_than_a_new_one)
{
  EXPECT_EQ(factorized_steps(200, [](int) { return 0.; }), std::vector<int>{0});
  EXPECT_EQ(factorized_steps(200, [](int) { return 0.9 * price; }), std::vector<int>{0});
}

// Costs c, 2c, 3c, ...: the average (price + c m (m + 1) / 2) / (m + 1) over m more steps is least
// near m = sqrt(2 price / c).
TEST(Refactorization_rule, replaces_what_wears_evenly_at_the_least_cost_per_step)
{
  for (const double c : {0.05, 0.2, 1.}) {
    const auto average = [&](int m) { return (price + c * m * (m + 1) / 2) / (m + 1); };
    double least = std::numeric_limits<double>::infinity();
    for (int m = 0; m < 100; ++m) least = std::min(least, average(m));
    const std::vector<int> steps = factorized_steps(100, [&](int age) { return c * age; });
    ASSERT_GE(steps.size(), 3u);
    const int cycle = steps[2] - steps[1];
    EXPECT_EQ(steps[1] - steps[0], cycle);
    EXPECT_LE(average(cycle - 1), 1.05 * least);
  }
}

TEST(Refactorization_rule, tries_less_and_less_where_every_old_one_fails)
{
  // With an old one, a step costs the price in vain and the price again.
  int tried = 0;
  const std::vector<int> steps = factorized_steps(100, [&](int) {
    ++tried;
    return 2 * price;
  });
  EXPECT_EQ(steps.size(), 100u);
  EXPECT_EQ(tried, 7);  // steps 1, 3, 6, 11, 20, 37, 70
}

TEST(Refactorization_rule, never_lets_a_step_cost_more_than_the_price_on_top)
{
  CGP::internal::Refactorization_rule rule;
  rule.set_price(price);
  rule.begin_step();
  rule.renewed();
  rule.add(fresh);
  EXPECT_FALSE(rule.begin_step());
  EXPECT_EQ(rule.budget(), price + fresh);
  rule.add(fresh);
  EXPECT_EQ(rule.budget(), price);
  rule.add(4);
  EXPECT_EQ(rule.budget(), price - 4);
  rule.add(6);
  EXPECT_EQ(rule.budget(), 0);
}

TEST(Refactorization_rule, pauses_after_a_failure_and_twice_as_long_after_the_next)
{
  CGP::internal::Refactorization_rule rule;
  rule.set_price(price);
  rule.begin_step();
  rule.renewed();
  for (const int pause : {1, 2, 4, 8}) {
    EXPECT_FALSE(rule.begin_step());
    rule.add(fresh + price);
    rule.renewed_in_the_midst();
    for (int i = 0; i < pause; ++i) {
      EXPECT_TRUE(rule.begin_step()) << i;
      rule.renewed();
      rule.add(fresh);
    }
  }
  EXPECT_FALSE(rule.begin_step());
  rule.add(fresh);
  EXPECT_FALSE(rule.begin_step());  // it has served: the next failure is again the first
  rule.renewed_in_the_midst();
  EXPECT_TRUE(rule.begin_step());
  rule.renewed();
  EXPECT_FALSE(rule.begin_step());
}
