// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <mpi.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

/// What the processes of the program do together. All functions but `rank()` and `processes()` are
/// collective: every process calls them, in the same order.
namespace conformal::mpi {

int rank();
int processes();

/// \brief Does work that is not collective on every process. Where it throws on one, all of them
/// throw what the first of these did, as a `Failure`.
void together(const std::function<void()>& work);

double sum(double value);
std::size_t sum(std::size_t value);
double largest(double value);
inline double smallest(double value)
{
  return -largest(-value);
}

/// the sum of each coefficient
template <class Matrix>
Matrix sum_of(Matrix values)
{
  MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_SUM,
                MPI_COMM_WORLD);
  return values;
}

/// the value of each process, in their order
std::vector<double> of_each(double value);

/// the text of the first process
std::string broadcast(std::string text);
bool broadcast(bool value);

/// \brief Delivers `to[p]` to process p.
/// \return what has arrived, in the order of the senders
/// \param[out] counts how much is from each
std::vector<std::byte> deliver_bytes(const std::vector<std::vector<std::byte>>& to,
                                     std::size_t size, std::vector<int>& counts);

template <class T>
std::vector<T> deliver(const std::vector<std::vector<T>>& to, std::vector<int>* counts = nullptr)
{
  static_assert(std::is_trivially_copyable_v<T>);
  std::vector<std::vector<std::byte>> bytes;
  for (const std::vector<T>& part : to) {
    const auto* first = reinterpret_cast<const std::byte*>(part.data());
    bytes.emplace_back(first, first + part.size() * sizeof(T));
  }
  std::vector<int> own_counts;
  const std::vector<std::byte> got =
      deliver_bytes(bytes, sizeof(T), counts != nullptr ? *counts : own_counts);
  std::vector<T> values(got.size() / sizeof(T));
  std::copy(got.begin(), got.end(), reinterpret_cast<std::byte*>(values.data()));
  return values;
}

/// \brief Contiguous ranges of the numbers below a total, one for each process: `first[p]` to
/// `first[p + 1]`.
struct Ranges {
  std::vector<int> first;

  static Ranges equal(int total);
  static Ranges of(int mine);

  int begin() const { return first[static_cast<std::size_t>(rank())]; }
  int end() const { return first[static_cast<std::size_t>(rank()) + 1]; }
  int size() const { return end() - begin(); }
  int total() const { return first.back(); }
  bool is_mine(int i) const { return begin() <= i && i < end(); }
  std::size_t owner(int i) const
  {
    return static_cast<std::size_t>(std::upper_bound(first.begin(), first.end(), i) -
                                    first.begin() - 1);
  }
};

/// \brief the answers to questions, each of which a process `whom(question)` knows.
/// \param answer of all that this process is asked, in the order of the processes that ask: returns
/// a vector of as many answers
template <class Question, class Whom, class Answer>
auto ask(const std::vector<Question>& all, const Whom& whom, const Answer& answer)
{
  const auto n = static_cast<std::size_t>(processes());
  std::vector<std::vector<Question>> questions(n);
  for (const Question& q : all) questions[whom(q)].push_back(q);
  std::vector<int> counts;
  const auto known = answer(deliver(questions, &counts));
  std::vector<std::decay_t<decltype(known)>> answers;
  auto next = known.begin();
  for (const int count : counts) {
    answers.emplace_back(next, next + count);
    next += count;
  }
  const auto got = deliver(answers);
  std::vector<std::size_t> place(n, 0);
  for (std::size_t p = 1; p < n; ++p) place[p] = place[p - 1] + questions[p - 1].size();
  std::decay_t<decltype(known)> found;
  found.reserve(all.size());
  for (const Question& q : all) found.push_back(got[place[whom(q)]++]);
  return found;
}

/// \brief the values at any numbers, of a table that is divided by ranges.
/// \param values of the numbers in the range of this process
template <class T>
std::vector<T> look_up(const std::vector<int>& numbers, const Ranges& ranges,
                       const std::vector<T>& values)
{
  return ask(
      numbers, [&](int i) { return ranges.owner(i); },
      [&](const std::vector<int>& asked) {
        std::vector<T> known;
        known.reserve(asked.size());
        for (const int i : asked)
          known.push_back(values[static_cast<std::size_t>(i - ranges.begin())]);
        return known;
      });
}

}  // namespace conformal::mpi
