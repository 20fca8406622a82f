// Tests include/Quaternionic_linear_algebra/direct/Supernodal_substitution.h
// Tests vector_units/Substitution_kernels.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Quaternionic_linear_algebra/direct/Supernodal_substitution.h>

#include <gtest/gtest.h>

#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Quaternionic_linear_algebra/direct/sweep_nested_dissection.h>

#include <cmath>
#include <complex>
#include <memory>
#include <type_traits>
#include <vector>

#include "quaternionic_linear_algebra/dense_fronts.h"
#include "quaternionic_linear_algebra/symbolic_elimination.h"
#include "quaternionic_linear_algebra/threads/threads.h"
#include "support/decompositions.h"
#include "support/spheres.h"

namespace cgp_test::supernodal_substitution_tests {

template <class Kind, int numbers_>
struct With_numbers : Kind {
  static constexpr int numbers = numbers_;
};
using Kinds_with_numbers =
    testing::Types<With_numbers<Kind<double, double>, 1>, With_numbers<Kind<double, float>, 1>,
                   With_numbers<Kind<double, double>, 4>, With_numbers<Kind<double, float>, 4>,
                   With_numbers<Kind<std::complex<double>, double>, 4>,
                   With_numbers<Kind<std::complex<double>, float>, 4>,
                   With_numbers<Kind<Quaternion<double>, double>, 4>,
                   With_numbers<Kind<Quaternion<double>, float>, 4>,
                   With_numbers<Kind<double, double>, 8>,
                   With_numbers<Kind<std::complex<double>, double>, 8>,
                   With_numbers<Kind<Quaternion<double>, double>, 8>,
                   With_numbers<Kind<Quaternion<double>, float>, 8>>;

template <class Kind>
class Supernodal_substitution : public testing::Test {
 protected:
  using Scalar = typename Kind::Scalar;
  using Real = typename Kind::Real;
  using Factor = CGP::internal::Supernodal_factor<Scalar, Real>;
  using Substitution = CGP::internal::Supernodal_substitution<Scalar, Real, Kind::numbers>;
  static constexpr int planes = Kind::planes;

  // As many right-hand sides as fill the numbers per row, compared with dense elimination.
  static void expect_solution(const Pattern& pattern, const CGP::internal::Ordering& order,
                              bool is_rounded = false)
  {
    const auto A = random_definite<Scalar>(pattern, 5);
    Factor factor(std::make_shared<CGP::internal::Supernodal_structure>(*pattern, order),
                  is_rounded);
    ASSERT_EQ(factor.factorize(A, {}), -1);
    const CGP::internal::Ordering& rows = factor.structure().order();
    const auto b = random_block<Scalar>(A.size(), Substitution::columns, 6);
    std::vector<Real> numbers;
    for (int i : rows)
      for (int c = 0; c < Substitution::columns; ++c) {
        double parts[planes];
        CGP::internal::Scalar_planes<Scalar>::get(b(i, c), parts);
        for (double part : parts) numbers.push_back(static_cast<Real>(part));
      }
    Substitution(factor).solve(numbers.data());
    CGP::Block<Scalar> x(A.size(), Substitution::columns);
    const Real* from = numbers.data();
    for (int i : rows)
      for (int c = 0; c < Substitution::columns; ++c, from += planes) {
        double parts[planes];
        for (int q = 0; q < planes; ++q) parts[q] = from[q];
        x(i, c) = CGP::internal::Scalar_planes<Scalar>::put(parts);
      }
    const Eigen::MatrixXd expected = definite_solution(real_form(A), real_columns(b));
    const double precision = is_rounded ? 1e-3 : Kind::precision;
    EXPECT_LE((real_columns(x) - expected).norm(), precision * expected.norm());
  }
};
TYPED_TEST_SUITE(Supernodal_substitution, Kinds_with_numbers);

TYPED_TEST(Supernodal_substitution, solves_as_dense_elimination_does)
{
  on_every_unit([&] {
    for (const auto& [name, pattern, order] : ordered_graphs()) {
      SCOPED_TRACE(name);
      this->expect_solution(pattern, order);
    }
  });
}

TYPED_TEST(Supernodal_substitution, solves_with_a_dense_matrix_of_many_row_blocks)
{
  on_every_unit([&] { this->expect_solution(full_pattern(150), random_permutation(150, 7)); });
}

TYPED_TEST(Supernodal_substitution, solves_with_rounded_rows_in_single_precision)
{
  if constexpr (std::is_same_v<typename TypeParam::Real, float>)
    on_every_unit([&] {
      for (const auto& [name, pattern, order] : ordered_graphs()) {
        SCOPED_TRACE(name);
        this->expect_solution(pattern, order, true);
      }
    });
}

TYPED_TEST(Supernodal_substitution, gives_the_same_bits_for_any_number_of_threads)
{
  on_every_unit([&] {
    const Mesh_view mesh = geodesic_sphere(TypeParam::planes == 4 ? 34 : 60);
    const Pattern pattern = CGP::vertex_graph(mesh);
    typename TestFixture::Factor factor(std::make_shared<CGP::internal::Supernodal_structure>(
        *pattern, CGP::sweep_nested_dissection(*pattern, mesh.positions())));
    ASSERT_EQ(factor.factorize(random_definite<typename TypeParam::Scalar>(pattern, 8), {}), -1);
    std::vector<typename TypeParam::Real> b(at(TypeParam::numbers * pattern->size()));
    for (std::size_t i = 0; i < b.size(); ++i)
      b[i] = static_cast<typename TypeParam::Real>(std::sin(double(i)));
    auto expected = b;
    typename TestFixture::Substitution(factor).solve(expected.data());
    for (const int threads : {2, 5}) {
      const Threads setting(threads);
      ASSERT_GT(factor.panel_bytes(), 5000000);  // enough for threads
      auto x = b;
      typename TestFixture::Substitution substitution(factor);
      substitution.solve(x.data());
      EXPECT_EQ(x, expected);
    }
  });
}

TEST(Rounded_substitution, gives_the_same_bits_for_any_number_of_threads)
{
  const Mesh_view mesh = geodesic_sphere(50);
  const Pattern pattern = CGP::vertex_graph(mesh);
  const auto A = random_definite<Quaternion<double>>(pattern, 8);
  const auto structure = std::make_shared<CGP::internal::Supernodal_structure>(
      *pattern, CGP::sweep_nested_dissection(*pattern, mesh.positions()));
  std::vector<float> expected;
  for (const int threads : {1, 2, 5}) {
    const Threads setting(threads);
    CGP::internal::Supernodal_factor<Quaternion<double>, float> factor(structure, true);
    ASSERT_EQ(factor.factorize(A, {}), -1);
    ASSERT_GT(factor.panel_bytes(), 5000000);  // enough for threads
    std::vector<float> x(at(4 * pattern->size()));
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = std::sin(static_cast<float>(i));
    CGP::internal::Supernodal_substitution<Quaternion<double>, float>(factor).solve(x.data());
    if (threads == 1) expected = x;
    EXPECT_EQ(x, expected);
  }
}

TYPED_TEST(Supernodal_substitution, goes_through_kept_rows_in_two_halves)
{
  on_every_unit([&] {
    using Number = typename TypeParam::Scalar;
    using Stored = typename TypeParam::Real;
    constexpr int parts = TestFixture::planes, numbers_per_row = TypeParam::numbers;
    const int n = 48, kept = 17, columns = TestFixture::Substitution::columns;
    const Pattern pattern = random_pattern(n, 9);
    const auto A = random_definite<Number>(pattern, 10);
    typename TestFixture::Factor factor(std::make_shared<CGP::internal::Supernodal_structure>(
        *pattern, random_permutation(n, 11), kept));
    ASSERT_EQ(factor.factorize(A, {}), -1);
    const CGP::internal::Ordering& order = factor.structure().order();

    const auto x = random_block<Number>(n, columns, 12);  // in the order of elimination
    CGP::Block<Number> P(n, n);
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) P(i, j) = A.coefficient(order[at(i)], order[at(j)]);
    const Eigen::MatrixXd all = real_form(P), b = all * real_columns(x);
    const Eigen::Index size = parts * kept;
    const Eigen::MatrixXd complement = all.inverse().bottomRightCorner(size, size).inverse();

    const auto numbers = [&](const Eigen::MatrixXd& block) {  // [row][column][component]
      std::vector<Stored> result;
      for (int i = 0; i < n; ++i)
        for (int c = 0; c < columns; ++c)
          for (int q = 0; q < parts; ++q)
            result.push_back(static_cast<Stored>(block(parts * i + q, c)));
      return result;
    };
    const auto expect_near = [&](const Stored* from, const Stored* expected, int count) {
      for (int i = 0; i < count; ++i) ASSERT_NEAR(from[i], expected[i], 30 * TypeParam::precision);
    };
    Eigen::MatrixXd left = real_columns(x);
    left.bottomRows(size) = complement * left.bottomRows(size);
    std::vector<Stored> y = numbers(b);
    const std::vector<Stored> solution = numbers(real_columns(x)), expected = numbers(left);
    typename TestFixture::Substitution substitution(factor);
    substitution.forward(y.data());
    expect_near(&y[at(numbers_per_row * (n - kept))], &expected[at(numbers_per_row * (n - kept))],
                numbers_per_row * kept);
    std::copy(solution.end() - numbers_per_row * kept, solution.end(),
              y.end() - numbers_per_row * kept);
    substitution.backward(y.data());
    expect_near(y.data(), solution.data(), numbers_per_row * n);
  });
}

TYPED_TEST(Supernodal_substitution, takes_as_many_right_hand_sides_as_fill_a_row)
{
  EXPECT_EQ(TestFixture::Substitution::columns * TypeParam::planes, TypeParam::numbers);
}

}  // namespace cgp_test::supernodal_substitution_tests
