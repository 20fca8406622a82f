// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "numbers.h"

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <system_error>
#include <type_traits>

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

#ifdef __EMSCRIPTEN__  // has only the locale of C, and a library without these functions of reals
template <class Real>
std::from_chars_result from_chars(const char* begin, const char* end, Real& value)
{
  const std::string word(begin, end);
  char* rest = nullptr;
  if constexpr (std::is_same_v<Real, float>)
    value = std::strtof(word.c_str(), &rest);
  else
    value = std::strtod(word.c_str(), &rest);
  const bool is_decimal = !word.empty() && word[0] != '+' && !std::isspace(word[0] & 0xff) &&
                          word.find_first_of("xX") == std::string::npos;
  if (!is_decimal || rest == word.c_str()) return {begin, std::errc::invalid_argument};
  const bool is_in_range = std::isfinite(value) || word.find_first_of("iInN") != std::string::npos;
  return {begin + (rest - word.c_str()),
          is_in_range ? std::errc() : std::errc::result_out_of_range};
}

template <class Real>
std::to_chars_result to_chars(char* begin, char* end, Real value)
{
  const int digits = std::numeric_limits<Real>::max_digits10;
  const int size = std::snprintf(begin, end - begin, "%.*g", digits, static_cast<double>(value));
  return {begin + size, std::errc()};
}
#else
using std::from_chars, std::to_chars;
#endif

template <class Real>
std::optional<Real> parse_real(std::string_view word)
{
  word = without_plus(word);
  Real value = 0;
  const auto [end, error] = from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || error == std::errc::invalid_argument) return {};
  if (error == std::errc()) return value;
  const Real magnitude = is_tiny(word) ? Real(0) : std::numeric_limits<Real>::infinity();
  return word[0] == '-' ? -magnitude : magnitude;
}

template <class Number>
void append(std::string& text, Number value)
{
  std::array<char, 32> buffer{};  // the longest double takes 24 characters
  const auto end = to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
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
