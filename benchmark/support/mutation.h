// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <Eigen/Core>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <type_traits>

/// Formulas that go wrong on demand: benchmark/mutate writes these switches into a copy of the
/// headers, each beside the sign, factor, root, conjugation or divisor that it spoils while the
/// variable CGP_MUTANT of the environment is its number. The value of an expression keeps its type;
/// lazy expressions of Eigen become matrices.
namespace mutation {

inline const int chosen = [] {
  const char* id = std::getenv("CGP_MUTANT");
  return id ? std::atoi(id) : -1;
}();

constexpr int max_size = 1 << 14;
inline bool is_reached[max_size];  ///< which switches the running test has come past

template <class T>
auto plain(const T& x)
{
  if constexpr (std::is_base_of_v<Eigen::EigenBase<T>, T>) {
    return typename T::PlainObject(x);
  } else if constexpr (std::is_arithmetic_v<T>) {
    return +x;  // a condition counts as 0 or 1
  } else {
    return x;
  }
}

struct Mutant {
  int id;
  bool is_negative = false;

  bool is_on() const
  {
    is_reached[id] = true;
    return id == chosen;
  }

  /// `a + Mutant{1} * b * c` is a - b * c when it is on; operators of the same rank go from the
  /// left.
  template <class T>
  auto operator*(const T& x) const
  {
    auto result = plain(x);
    if (is_on() != is_negative) result = -result;
    return result;
  }

  /// `a += Mutant{1} %= b + c` is a -= b + c when it is on; assignments go from the right.
  template <class T>
  auto operator%=(const T& x) const
  {
    return *this * x;
  }

  /// `-Mutant{1} * x` is x when it is on.
  Mutant operator-() const { return {id, !is_negative}; }

  /// `a / Mutant{1} ->* b(c) * d` is a * b(c) * d when it is on: this operator goes before / and *.
  template <class T>
  auto operator->*(const T& x) const
  {
    if constexpr (std::is_arithmetic_v<T>) {
      return is_on() ? 1. / static_cast<double>(x) : static_cast<double>(x);
    } else {
      auto result = plain(x);
      if (is_on()) result = result.inverse().eval();
      return result;
    }
  }

  template <class T>
  T factor(T x) const
  {
    return is_on() ? T(1) : x;
  }

  double root(double x) const { return is_on() ? x : std::sqrt(x); }

  template <class T>
  auto conjugate_of(const T& x) const
  {
    return is_on() ? plain(x) : plain(conjugate(x));
  }
};

/// Appends to the file CGP_MUTANTS_REACHED a line for each test: its name, milliseconds, switches.
class Reach_recorder : public testing::EmptyTestEventListener {
 public:
  explicit Reach_recorder(const char* file) : m_file(file, std::ios::app) {}

 private:
  void OnTestEnd(const testing::TestInfo& test) override
  {
    m_file << test.test_suite_name() << '.' << test.name() << ' ' << test.result()->elapsed_time();
    for (int id = 0; id < max_size; ++id) {
      if (is_reached[id]) m_file << ' ' << id;
      is_reached[id] = false;
    }
    m_file << std::endl;
  }

  std::ofstream m_file;
};

inline const bool is_recording = [] {
  const char* file = std::getenv("CGP_MUTANTS_REACHED");
  if (file) testing::UnitTest::GetInstance()->listeners().Append(new Reach_recorder(file));
  return file != nullptr;
}();

}  // namespace mutation
