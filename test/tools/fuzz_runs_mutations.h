// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "fuzz_readers_mutations.h"

#include <algorithm>
#include <cctype>

// Damage that a reader does not notice: points and faces exchanged, repeated, moved far away.

namespace fuzz {

class Surface_mutator : public Mutator {
 public:
  using Mutator::Mutator;

  /// a copy with one fault or a few, three of four of them inside the lines
  std::string mutant(std::string text)
  {
    if (below(4) == 0) return Mutator::mutant(text);
    const bool is_text = text.find('\0') == std::string::npos;
    for (std::size_t faults = 1 + below(3); faults > 0 && !text.empty(); --faults)
      is_text ? rearrange(text) : overwrite_bytes(text);
    return text;
  }

 private:
  using Range = std::pair<std::size_t, std::size_t>;  // [begin, end)

  Range random_line(const std::string& text)
  {
    const std::size_t place = below(text.size());
    const std::size_t before = text.rfind('\n', place == 0 ? 0 : place - 1);
    const std::size_t after = text.find('\n', place);
    return {before == std::string::npos ? 0 : before + 1,
            after == std::string::npos ? text.size() : std::max(after, before + 1)};
  }

  static std::string_view in(const std::string& text, Range range)
  {
    return std::string_view(text).substr(range.first, range.second - range.first);
  }

  // Whether a line may replace another one: a point only a point, a face only a face.
  static bool is_alike(std::string_view a, std::string_view b)
  {
    const auto is_real = [](std::string_view text) {
      return text.find('.') != std::string_view::npos;
    };
    const auto blanks = [](std::string_view text) {
      return std::count(text.begin(), text.end(), ' ');
    };
    return is_real(a) == is_real(b) && blanks(a) == blanks(b) && !a.empty() && !b.empty() &&
           std::isalpha(static_cast<unsigned char>(a[0])) ==
               std::isalpha(static_cast<unsigned char>(b[0]));
  }

  template <class Choice>
  void copy_alike(std::string& text, const Choice& choice)
  {
    for (int attempt = 0; attempt < 20; ++attempt) {
      const Range from = choice(), to = choice();
      if (!is_alike(in(text, from), in(text, to))) continue;
      const std::string copy(in(text, from));
      text.replace(to.first, to.second - to.first, copy);
      return;
    }
  }

  void replace_coordinate(std::string& text)
  {
    using namespace std::string_view_literals;
    constexpr std::array numbers = {"0"sv,    "1e-9"sv, "1e-160"sv, "1e9"sv, "1e160"sv,
                                    "1e30"sv, "-2"sv,   "1"sv,      "3"sv,   "0.5"sv};
    for (int attempt = 0; attempt < 20; ++attempt) {
      const Range word = random_word(text);
      if (in(text, word).find('.') == std::string_view::npos) continue;
      text.replace(word.first, word.second - word.first, numbers[below(numbers.size())]);
      return;
    }
  }

  void rearrange(std::string& text)
  {
    const std::size_t what = below(4);
    if (what == 0)
      copy_alike(text, [&] { return random_line(text); });
    else if (what == 1)
      replace_coordinate(text);
    else
      copy_alike(text, [&] { return random_word(text); });
  }

  // As of a binary file: four bytes copied over others, in step with the numbers half of the time.
  void overwrite_bytes(std::string& text)
  {
    if (text.size() < 200) return;
    const std::size_t from = below(text.size() - 4);
    std::size_t to = below(text.size() - 4);
    if (below(2) == 0) to = from + 4 * below((text.size() - from) / 4);
    for (std::size_t i = 0; i < 4 && to + i < text.size(); ++i) text[to + i] = text[from + i];
  }
};

}  // namespace fuzz
