// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Share_search.h
#include <Conformal_geometry_processing/spin/Share_search.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace cgp_test::share_search_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Spin_report;
using Search = CGP::internal::Share_search<double>;

Spin_report with_excess(double excess)
{
  Spin_report r;
  r.converged = true;
  r.scales.bound = 2;
  r.scales.high = std::pow(2, excess);
  return r;
}

/// finds shares up to a limit that depends on where it begins; tells what it has tried
struct Surface_that_bears {
  double from_zero, from_another;
  Spin_report::Fault fault = Spin_report::Fault::scales;
  std::vector<std::pair<double, double>> tried = {};  // the share, and where from

  Search::Attempt operator()(double share, const double* from)
  {
    tried.emplace_back(share, from ? *from : 0);
    const bool is_good = share <= (from ? from_another : from_zero);
    Spin_report r = with_excess(is_good || fault != Spin_report::Fault::scales ? .5 : 1.5);
    if (!is_good && fault == Spin_report::Fault::map) r.conformality.quasi_conformal.mean = 1e9;
    r.scales.kept_norm = share;
    r.solves = 1;
    CGP::Spin_result result;
    result.report = r;
    return {std::move(result), share};
  }
};

Spin_report found(Surface_that_bears& surface, double share = 1)
{
  return Search(std::ref(surface)).run(share).report;
}

TEST(Share_search, takes_all_where_that_succeeds)
{
  Surface_that_bears surface{1, 1};
  EXPECT_TRUE(found(surface));
  EXPECT_EQ(surface.tried.size(), 1);
}

TEST(Share_search, goes_on_to_more_from_what_it_has_found)
{
  Surface_that_bears surface{.5, .8};
  const Spin_report r = found(surface);
  EXPECT_TRUE(r);
  EXPECT_EQ(r.scales.kept_norm, .75);
  EXPECT_EQ(r.solves, 4);  // of all attempts
  const std::vector<std::pair<double, double>> expected = {{1, 0}, {.5, 0}, {.75, .5}, {.875, .75}};
  EXPECT_EQ(surface.tried, expected);
}

TEST(Share_search, tries_less_where_more_fails_again)
{
  Surface_that_bears surface{.5, .7};
  EXPECT_EQ(found(surface).scales.kept_norm, .625);
  EXPECT_EQ(surface.tried.back(), std::pair(.625, .5));
}

TEST(Share_search, begins_with_a_part_where_all_is_known_to_be_too_much)
{
  Surface_that_bears surface{.6, .9};
  EXPECT_EQ(found(surface, .5).scales.kept_norm, .875);
}

TEST(Share_search, ends_at_an_eighth)
{
  for (const auto fault : {Spin_report::Fault::scales, Spin_report::Fault::map}) {
    Surface_that_bears surface{0, 0, fault};
    const Spin_report r = found(surface);
    EXPECT_EQ(r.fault(), fault);
    EXPECT_EQ(surface.tried.back().first, 1. / 8);
    // Of maps that are not conformal, that of most of rho tells most.
    EXPECT_EQ(r.scales.kept_norm, fault == Spin_report::Fault::map ? 1 : 1. / 8);
  }
}

TEST(Share_search, leaves_it_at_what_is_not_nearer)
{
  int tries = 0;
  const Spin_report r = Search([&](double share, const double* from) {
                          ++tries;
                          CGP::Spin_result result;
                          result.report = with_excess(share == 1 ? 2 : .5);
                          result.report.scales.kept_norm = .5;
                          result.report.iterations = tries;
                          EXPECT_EQ(from != nullptr, tries > 2);
                          return Search::Attempt{std::move(result), share};
                        })
                            .run(1)
                            .report;
  EXPECT_TRUE(r);
  EXPECT_EQ(tries, 3);
  EXPECT_EQ(r.iterations, 1 + 2 + 3);
}

TEST(Share_search, is_over_when_cancelled)
{
  int tries = 0;
  const Spin_report r = Search([&](double share, const double*) {
                          CGP::Spin_result result;
                          result.report = with_excess(share == 1 ? 2 : .5);
                          result.report.cancelled = ++tries == 3;
                          return Search::Attempt{std::move(result), share};
                        })
                            .run(1)
                            .report;
  EXPECT_TRUE(r.cancelled);
  EXPECT_EQ(tries, 3);
}

}  // namespace cgp_test::share_search_tests
