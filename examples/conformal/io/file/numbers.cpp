// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "numbers.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

namespace conformal {
namespace {

// `from_chars` does not take the leading plus that printf("%+g") writes.
std::string_view without_plus(std::string_view word)
{
  if (word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+') word.remove_prefix(1);
  return word;
}

// Of a number that `from_chars` calls out of range: whether it is too small rather than too large.
bool is_tiny(std::string_view word)
{
  const auto exponent = word.find_first_of("eE");
  if (exponent != std::string_view::npos)
    return exponent + 1 < word.size() && word[exponent + 1] == '-';
  return word.substr(0, word.find('.')).find_first_of("123456789") == std::string_view::npos;
}

template <class Real>
std::optional<Real> parse_real(std::string_view word)
{
  word = without_plus(word);
  Real value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || error == std::errc::invalid_argument) return {};
  if (error == std::errc()) return value;
  const Real magnitude = is_tiny(word) ? Real(0) : std::numeric_limits<Real>::infinity();
  return word[0] == '-' ? -magnitude : magnitude;
}

template <class Number>
void append(std::string& text, Number value)
{
  std::array<char, 32> buffer{};  // the longest double takes 24 characters
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  text.append(buffer.data(), end);
}

}  // namespace

std::optional<double> parse_double(std::string_view word)
{
  return parse_real<double>(word);
}

std::optional<float> parse_float(std::string_view word)
{
  return parse_real<float>(word);
}

std::optional<std::int64_t> parse_integer(std::string_view word)
{
  word = without_plus(word);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || error != std::errc()) return {};
  return value;
}

void append_number(std::string& text, double value)
{
  append(text, value);
}
void append_number(std::string& text, float value)
{
  append(text, value);
}
void append_number(std::string& text, std::int64_t value)
{
  append(text, value);
}

std::string in_quotes(std::string_view word)
{
  constexpr std::size_t longest = 40;
  std::string text(1, '\'');
  for (const char c : word.substr(0, longest)) text += c >= ' ' && c <= '~' ? c : '?';
  if (word.size() > longest) text += "...";
  return text + "'";
}

}  // namespace conformal
