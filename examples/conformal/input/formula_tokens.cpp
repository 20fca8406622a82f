// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "formula_tokens.h"

#include <algorithm>
#include <cstddef>

namespace conformal {
namespace {

using Kind = Formula_token::Kind;

bool is_digit(char c)
{
  return c >= '0' && c <= '9';
}

bool is_letter(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

/// how many digits there are, and points
std::size_t size_of_digits(std::string_view text)
{
  const auto is_other = [](char c) { return !is_digit(c) && c != '.'; };
  return static_cast<std::size_t>(std::find_if(text.begin(), text.end(), is_other) - text.begin());
}

/// an e belongs to the number only with digits after it
std::size_t size_of_number(std::string_view text)
{
  const std::size_t size = size_of_digits(text);
  if (size == text.size() || (text[size] != 'e' && text[size] != 'E')) return size;
  std::size_t begin = size + 1;
  if (begin < text.size() && (text[begin] == '+' || text[begin] == '-')) ++begin;
  const std::size_t digits = size_of_digits(text.substr(begin));
  return digits == 0 ? size : begin + digits;
}

std::size_t size_of_name(std::string_view text)
{
  const auto is_other = [](char c) { return !is_letter(c) && !is_digit(c); };
  return static_cast<std::size_t>(std::find_if(text.begin(), text.end(), is_other) - text.begin());
}

Kind kind_of(char c)
{
  return c == '(' ? Kind::opening : c == ')' ? Kind::closing : c == ',' ? Kind::comma : Kind::other;
}

/// \pre the text is not empty and does not begin with a blank
Formula_token first_token(std::string_view text)
{
  const bool has_point = text[0] == '.' && text.size() > 1 && is_digit(text[1]);
  if (is_digit(text[0]) || has_point)
    return {Kind::number, std::string(text.substr(0, size_of_number(text)))};
  if (is_letter(text[0])) return {Kind::name, std::string(text.substr(0, size_of_name(text)))};
  return {kind_of(text[0]), std::string(text.substr(0, 1))};
}

}  // namespace

Formula_tokens formula_tokens(std::string_view text)
{
  Formula_tokens tokens;
  while (true) {
    const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
    const std::string blanks(text.substr(0, begin));
    text.remove_prefix(begin);
    if (text.empty()) return tokens;
    tokens.push_back(first_token(text));
    tokens.back().blanks = blanks;
    text.remove_prefix(tokens.back().text.size());
  }
}

std::string formula_of(const Formula_tokens& tokens)
{
  std::string text;
  for (const Formula_token& token : tokens) text += token.blanks + token.text;
  return text;
}

std::size_t closing_of(const Formula_tokens& tokens, std::size_t opening)
{
  int depth = 0;
  for (std::size_t i = opening; i < tokens.size(); ++i) {
    depth += tokens[i].kind == Kind::opening ? 1 : tokens[i].kind == Kind::closing ? -1 : 0;
    if (depth == 0) return i;
  }
  return tokens.size();
}

}  // namespace conformal
