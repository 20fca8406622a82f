// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Quaternionic_linear_algebra/direct/Supernodal_factor.h>
#include <Quaternionic_linear_algebra/direct/sweep_nested_dissection.h>

#include <gtest/gtest.h>

#include "quaternionic_linear_algebra/dense_fronts.h"
#include "quaternionic_linear_algebra/hermitian_matrices.h"
#include "quaternionic_linear_algebra/symbolic_elimination.h"
#include "quaternionic_linear_algebra/threads/threads.h"
#include "support/decompositions.h"
#include "support/spheres.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <mutex>
#include <utility>

namespace cgp_test::supernodal_factor_tests {

namespace CGP = Conformal_geometry_processing;
using Q = CGP::Quaternion<double>;
using CGP::internal::Elimination_tasks;
using CGP::internal::Supernodal_structure;

constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();

TEST(Is_finite, sees_every_component_of_every_entry)
{
  auto A = random_hermitian<Q>(random_pattern(12, 1), 2);
  EXPECT_TRUE(CGP::internal::is_finite(A));
  for (int k = 0; k < A.pattern().size_of_entries(); ++k)
    for (double Q::*component : {&Q::w, &Q::x, &Q::y, &Q::z})
      for (const double bad : {nan, infinity, -infinity}) {
        const double good = std::exchange(A.value(k).*component, bad);
        EXPECT_FALSE(CGP::internal::is_finite(A));
        A.value(k).*component = good;
      }
}

TEST(Is_finite, sees_one_number_among_many_on_several_threads)
{
  const Threads setting(2);
  CGP::internal::Aligned_array<float> numbers;
  numbers.resize(100'000);
  std::fill_n(numbers.data(), numbers.size(), -3.f);
  EXPECT_TRUE(CGP::internal::is_finite(numbers));
  for (const std::int64_t i : {0, 8191, 8192, 99'999}) {
    numbers.data()[i] = static_cast<float>(nan);
    EXPECT_FALSE(CGP::internal::is_finite(numbers));
    numbers.data()[i] = 1e30f;
    EXPECT_TRUE(CGP::internal::is_finite(numbers));
  }
}

double power_of_two(const CGP::Quaternion_vector<double>& v)
{
  return CGP::internal::power_of_two<Quaternion<double>>(v.size(),
                                                         [&](std::ptrdiff_t i) { return v[i]; });
}

TEST(Power_of_two, is_just_above_the_largest_number)
{
  CGP::Quaternion_vector<double> v = CGP::Quaternion_vector<double>::Constant(3, {});
  v[0].x = .1;
  for (const double largest : {.75, 1., 1.5, 3e40, 1e-30}) {
    v[1].z = -largest;
    v[0].x = .1 * largest;
    const double power = power_of_two(v);
    EXPECT_GT(power, largest);
    EXPECT_LE(power, 2 * largest);
    EXPECT_EQ(std::ldexp(1., std::ilogb(power)), power);
  }
}

TEST(Power_of_two, is_one_where_there_is_none)
{
  CGP::Quaternion_vector<double> v = CGP::Quaternion_vector<double>::Constant(3, {});
  EXPECT_EQ(power_of_two(v), 1);
  for (const double odd : {nan, infinity, 1e-310}) {
    v[1].y = odd;
    EXPECT_EQ(power_of_two(v), 1);
  }
}

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

template <class Kind>
class Supernodal_factor : public testing::Test {
 protected:
  using Scalar = typename Kind::Scalar;
  using Factor = CGP::internal::Supernodal_factor<Scalar, typename Kind::Real>;

  static Factor factor_of(const Pattern& pattern, const CGP::internal::Ordering& order)
  {
    return Factor(std::make_shared<CGP::internal::Supernodal_structure>(*pattern, order));
  }

  static CGP::Block<Scalar> unpacked(const Factor& factor)
  {
    const CGP::internal::Supernodal_structure& S = factor.structure();
    const int n = S.size_of_columns();
    CGP::Block<Scalar> L = CGP::Block<Scalar>::Constant(n, n, Scalar{});
    for (int s = 0; s < S.size(); ++s)
      for (int j = 0; j < S.width(s); ++j)
        for (int i = j; i < S.width(s) + S.height(s); ++i)
          L(i < S.width(s) ? S.first(s) + i : S.rows(s)[i - S.width(s)], S.first(s) + j) =
              get<Kind>(factor.front(s).panel + in_panel<Kind>(S.width(s), i, j));
    return L;
  }

  static CGP::Block<Scalar> permuted(const CGP::Hermitian_sparse_matrix<Scalar>& A,
                                     const CGP::internal::Ordering& order)
  {
    CGP::Block<Scalar> P(A.size(), A.size());
    for (int j = 0; j < A.size(); ++j)
      for (int i = 0; i < A.size(); ++i) P(i, j) = A.coefficient(order[at(i)], order[at(j)]);
    return P;
  }

  static void expect_factor(const Pattern& pattern, const CGP::internal::Ordering& order)
  {
    const auto A = random_definite<Scalar>(pattern, 5);
    const Eigen::VectorXd shift = random_numbers(A.size(), 6).cwiseAbs();
    Factor factor = factor_of(pattern, order);
    ASSERT_EQ(factor.factorize(A, shift), -1);
    const Eigen::MatrixXd expected =
        cholesky_factor(real_form(permuted(plus_diagonal(A, shift), factor.structure().order())));
    EXPECT_LE((real_form(unpacked(factor)) - expected).norm(), Kind::precision * expected.norm());
  }
};
TYPED_TEST_SUITE(Supernodal_factor, Kinds);

TYPED_TEST(Supernodal_factor, is_the_cholesky_factor_of_the_permuted_matrix)
{
  on_every_unit([&] {
    for (const auto& [name, pattern, order] : ordered_graphs()) {
      SCOPED_TRACE(name);
      this->expect_factor(pattern, order);
    }
  });
}

TYPED_TEST(Supernodal_factor, of_a_dense_matrix_passes_large_updates_up_a_chain)
{
  on_every_unit([&] { this->expect_factor(full_pattern(150), random_permutation(150, 7)); });
}

TYPED_TEST(Supernodal_factor, is_the_same_to_the_bit_every_time_and_in_the_same_memory)
{
  on_every_unit([&] {
    const Pattern pattern = random_pattern(90, 8);
    const auto A = random_definite<typename TypeParam::Scalar>(pattern, 9);
    auto factor = this->factor_of(pattern, random_permutation(90, 10));
    ASSERT_EQ(factor.factorize(A, {}), -1);
    const auto* const before = factor.front(0).panel;
    const std::vector<typename TypeParam::Real> numbers(
        before, before + factor.panel_bytes() / std::int64_t(sizeof(typename TypeParam::Real)));
    ASSERT_EQ(factor.factorize(random_definite<typename TypeParam::Scalar>(pattern, 11), {}), -1);
    EXPECT_NE(std::memcmp(before, numbers.data(), std::size_t(factor.panel_bytes())), 0);
    ASSERT_EQ(factor.factorize(A, {}), -1);
    EXPECT_EQ(factor.front(0).panel, before);
    EXPECT_EQ(std::memcmp(before, numbers.data(), std::size_t(factor.panel_bytes())), 0);
  });
}

TYPED_TEST(Supernodal_factor, names_the_vertex_of_a_pivot_that_is_not_positive)
{
  on_every_unit([&] {
    const int n = 60;
    const Pattern pattern = random_pattern(n, 12);
    const auto A = random_definite<typename TypeParam::Scalar>(pattern, 13);
    auto factor = this->factor_of(pattern, random_permutation(n, 14));
    for (const int vertex : {0, 17, 59}) {
      Eigen::VectorXd shift = Eigen::VectorXd::Zero(n);
      shift[vertex] = -3 * A.diagonal(vertex);
      EXPECT_EQ(factor.factorize(A, shift), vertex);
    }
    EXPECT_EQ(factor.factorize(A, {}), -1);
  });
}

// A dense matrix is a chain of large fronts, done in pieces; a mesh has a tree with many branches.
template <class Kind>
std::vector<std::pair<Pattern, CGP::internal::Ordering>> large_graphs()
{
  constexpr int planes = Kind::planes, n = 520 / planes + 150;
  const Mesh_view mesh = geodesic_sphere(planes == 1 ? 30 : planes == 2 ? 24 : 16);
  const Pattern graph = CGP::vertex_graph(mesh);
  return {{full_pattern(n), random_permutation(n, 16)},
          {graph, CGP::sweep_nested_dissection(*graph, mesh.positions())}};
}

TYPED_TEST(Supernodal_factor, is_the_same_to_the_bit_for_any_number_of_threads)
{
  on_every_unit([&] {
    using Real = typename TypeParam::Real;
    for (const auto& [pattern, order] : large_graphs<TypeParam>()) {
      const auto A = random_definite<typename TypeParam::Scalar>(pattern, 17);
      auto factor = this->factor_of(pattern, order);
      ASSERT_EQ(factor.factorize(A, {}), -1);
      const std::int64_t bytes = factor.bytes();
      std::int64_t bytes_of_many = 0, bytes_of_one = 0;
      const std::vector<Real> one(
          factor.front(0).panel,
          factor.front(0).panel + factor.panel_bytes() / std::int64_t(sizeof(Real)));
      for (const int threads : {2, 3, 7, 1}) {
        const Threads setting(threads);
        ASSERT_EQ(factor.factorize(A, {}), -1);
        (threads > 1 ? bytes_of_many : bytes_of_one) = factor.bytes();
        EXPECT_EQ(std::memcmp(factor.front(0).panel, one.data(), std::size_t(factor.panel_bytes())),
                  0);
      }
      EXPECT_EQ(bytes_of_one, bytes);
      EXPECT_GE(bytes_of_many, bytes);
    }
  });
}

TYPED_TEST(Supernodal_factor, names_the_first_bad_vertex_for_any_number_of_threads)
{
  on_every_unit([&] {
    for (const auto& [pattern, order] : large_graphs<TypeParam>()) {
      const auto A = random_definite<typename TypeParam::Scalar>(pattern, 18);
      auto factor = this->factor_of(pattern, order);
      for (const int threads : {2, 5}) {
        const Threads setting(threads);
        Eigen::VectorXd shift = Eigen::VectorXd::Zero(pattern->size());
        for (const double place : {0.95, 0.7, 0.6, 0.3, 0.1}) {
          const int vertex = factor.structure().order()[at(int(place * pattern->size()))];
          shift[vertex] = -3 * A.diagonal(vertex);
          EXPECT_EQ(factor.factorize(A, shift), vertex);
        }
        EXPECT_EQ(factor.factorize(A, {}), -1);
      }
    }
  });
}

TYPED_TEST(Supernodal_factor, takes_one_thread_where_more_do_not_pay)
{
  const Threads setting(4);
  EXPECT_EQ(TestFixture::Factor::threads(1e-4), 1);
  EXPECT_EQ(TestFixture::Factor::threads(1), 4);
}

TYPED_TEST(Supernodal_factor, leaves_the_schur_complement_to_kept_vertices)
{
  on_every_unit([&] {
    using Number = typename TypeParam::Scalar;
    for (const auto& [name, pattern, order] : ordered_graphs()) {
      SCOPED_TRACE(name);
      const int n = pattern->size(), kept = (n + 2) / 3;
      const auto A = random_definite<Number>(pattern, 16);
      typename TestFixture::Factor factor(
          std::make_shared<CGP::internal::Supernodal_structure>(*pattern, order, kept));
      ASSERT_EQ(factor.factorize(A, {}), -1);
      const CGP::internal::Supernodal_structure& S = factor.structure();
      const CGP::Block<Number> P = this->permuted(A, S.order());
      CGP::Block<Number> complement = P.bottomRightCorner(kept, kept);
      for (int s = 0; s < S.size(); ++s)
        for (int j = 0; S.parent(s) < 0 && j < S.height(s); ++j)
          for (int i = j; i < S.height(s); ++i) {
            const Number c =
                get<TypeParam>(factor.update(s) + in_update<TypeParam>(S.height(s), i, j));
            const int row = S.rows(s)[i] - (n - kept), column = S.rows(s)[j] - (n - kept);
            complement(row, column) += c;
            if (i != j) complement(column, row) += CGP::conjugate(c);
          }
      const Eigen::MatrixXd all = real_form(P), inverse = all.inverse();
      const Eigen::Index size = real_form(complement).rows();
      const Eigen::MatrixXd expected = inverse.bottomRightCorner(size, size).inverse();
      EXPECT_LE((real_form(complement) - expected).norm(), TypeParam::precision * all.norm());
    }
  });
}

TYPED_TEST(Supernodal_factor, knows_its_memory_before_it_is_allocated)
{
  on_every_unit([&] {
    const Pattern pattern = grid_pattern(12, 12);
    const auto factor = this->factor_of(pattern, random_permutation(144, 15));
    const std::int64_t scalar = sizeof(typename TypeParam::Real) * TypeParam::planes;
    EXPECT_GE(factor.panel_bytes(), factor.structure().stored_entries() * scalar);
    EXPECT_GT(factor.bytes(), factor.panel_bytes());
  });
}

}  // namespace cgp_test::supernodal_factor_tests
