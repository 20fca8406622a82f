// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Damages files: deterministic for a seed, on every platform (uses only the raw output of the
// generator, because the distributions of the standard library differ).

namespace fuzz {

class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : m_random(seed) {}

  /// a copy with one fault or a few
  std::string mutant(std::string text)
  {
    for (std::size_t faults = 1 + below(2) * below(4); faults > 0 && !text.empty(); --faults)
      mutate(text);
    return text;
  }

  std::size_t below(std::size_t n) { return static_cast<std::size_t>(m_random() % n); }

 protected:
  static bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

  // the word around a random place: [begin, end)
  std::pair<std::size_t, std::size_t> random_word(const std::string& text)
  {
    std::size_t begin = below(text.size()), end = begin;
    while (begin > 0 && !is_blank(text[begin - 1])) --begin;
    while (end < text.size() && !is_blank(text[end])) ++end;
    return {begin, end};
  }

 private:
  void replace_word(std::string& text)
  {
    using namespace std::string_view_literals;
    constexpr std::array words = {
        "nan"sv,        "inf"sv,      "-1"sv,     "2147483648"sv, "18446744073709551615"sv,
        "0"sv,          "1e400"sv,    "1e-400"sv, "-0"sv,         "4294967295"sv,
        "1000000000"sv, "\xff\xfe"sv, "#"sv,      "\\"sv,         "3"sv,
        "+7"sv,         "0x10"sv,     "1,5"sv,    "uchar"sv,      "list"sv};
    const auto [begin, end] = random_word(text);
    text.replace(begin, end - begin, words[below(words.size())]);
  }

  void copy_range(std::string& text)
  {
    const std::size_t begin = below(text.size()), size = 1 + below(60);
    text.insert(below(text.size() + 1), text.substr(begin, size));
  }

  // In text, brackets and elements inside of one another
  void repeat_range(std::string& text)
  {
    const std::string range = text.substr(below(text.size()), 1 + below(12));
    const std::size_t begin = below(text.size() + 1);
    std::string all;
    for (std::size_t times = std::size_t(1) << below(14); times > 0; --times) all += range;
    text.insert(begin, all);
  }

  void overwrite_number(std::string& text)
  {
    constexpr std::array<std::uint32_t, 8> numbers = {0xffffffffu, 0x7fffffffu, 0x80000000u, 0u,
                                                      0x7fc00000u, 0x7f800000u, 0xffffu,     0x10u};
    const std::uint32_t number = numbers[below(numbers.size())];
    const std::size_t begin = below(text.size());
    for (std::size_t i = 0; i < 4 && begin + i < text.size(); ++i)
      text[begin + i] = static_cast<char>(static_cast<unsigned char>(number >> (8 * i)));
  }

  void mutate(std::string& text)
  {
    switch (below(8)) {
      case 0:
        text.resize(below(text.size()));
        break;
      case 1:
        text[below(text.size())] = static_cast<char>(static_cast<unsigned char>(below(256)));
        break;
      case 2:
        text[below(text.size())] ^= static_cast<char>(1u << below(7));
        break;
      case 3:
        text.erase(below(text.size()), 1 + below(20));
        break;
      case 4:
        copy_range(text);
        break;
      case 5:
        overwrite_number(text);
        break;
      case 6:
        repeat_range(text);
        break;
      default:
        replace_word(text);
        break;
    }
  }

  std::mt19937_64 m_random;
};

}  // namespace fuzz
